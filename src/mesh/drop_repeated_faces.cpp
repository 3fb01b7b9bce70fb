#include "mesh/repair_steps.hpp"
#include "mesh/repeated_faces.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {

void drop_repeated_faces(Mended& mended) {
  const Mesh& mesh = mended.mesh;
  const auto repeats = find_repeated_faces(mesh);
  if (repeats.empty()) return;
  const EdgeTable edges(mesh);
  std::vector<unsigned char> drop(mesh.face_count(), 0);
  std::size_t dropped = 0;
  for (const RepeatedFace& repeat : repeats) {
    if (is_back_to_back(mesh, edges, repeat.face)) continue;
    drop[repeat.face] = 1;
    ++dropped;
  }
  if (dropped == 0) return;
  Selection s = Selection::of_all_vertices(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (drop[f] == 0) s.add_face(mesh, f);
  }
  mended.mesh = select(mesh, std::move(s));
  mended.done.push_back(
      fmt::format("dropped {} of another face", counted(dropped, "repeat", "repeats")));
}

}  // namespace surpass::repair_step

#include "mesh/repair_steps.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {

void separate_repeated_corners(Mended& mended) {
  const Mesh& mesh = mended.mesh;
  Selection s = Selection::of_all_vertices(mesh);
  std::vector<Index> last_face(mesh.points.size(), kNone);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) {
      const Index v = mesh.face_vertices[c];
      s.add_corner(c, last_face[v] == f ? s.add_copy(v) : v);
      last_face[v] = f;
    }
    s.end_face(f);
  }
  const std::size_t copies = s.vertex_source.size() - mesh.points.size();
  if (copies == 0) return;
  mended.mesh = select(mesh, std::move(s));
  mended.done.push_back(fmt::format("added {} for faces that name a vertex twice",
                                    counted(copies, "vertex copy", "vertex copies")));
}

}  // namespace surpass::repair_step

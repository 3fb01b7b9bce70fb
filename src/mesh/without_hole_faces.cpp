#include "mesh/select.hpp"

namespace surpass {

Selection visible_part(const Mesh& mesh, Index kept) {
  return visible_part(mesh, std::vector<unsigned char>(kept, 1));
}

Selection visible_part(const Mesh& mesh, std::vector<unsigned char> kept) {
  std::vector<unsigned char> is_hole(mesh.face_count(), 0);
  for (const Index f : mesh.hole_faces) is_hole[f] = 1;
  std::vector<unsigned char>& used = kept;
  used.resize(mesh.vertex_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (is_hole[f] != 0) continue;
    for (const Index v : mesh.face(f)) used[v] = 1;
  }
  Selection selection = Selection::of_vertices(used);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (is_hole[f] == 0) selection.add_face(mesh, f);
  }
  return selection;
}

}  // namespace surpass

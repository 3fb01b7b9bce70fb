#include <algorithm>

#include "mesh/select.hpp"

namespace surpass {

Selection visible_part(const Mesh& mesh, Index kept) {
  std::vector<unsigned char> is_hole(mesh.face_count(), 0);
  for (const Index f : mesh.hole_faces) is_hole[f] = 1;
  std::vector<unsigned char> used(mesh.vertex_count(), 0);
  std::fill(used.begin(), used.begin() + kept, static_cast<unsigned char>(1));
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

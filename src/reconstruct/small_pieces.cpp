#include <algorithm>

#include "mesh/disjoint_sets.hpp"
#include "reconstruct/clean_up.hpp"

namespace surpass::reconstruction {

std::size_t drop_small_pieces(Mesh& mesh, double share) {
  DisjointSets pieces(mesh.points.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const Index v : face) pieces.unite(face[0], v);
  }
  std::vector<std::size_t> faces(mesh.points.size(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) ++faces[pieces.find(mesh.face(f)[0])];
  const std::size_t largest = faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end());
  const double least = share * mesh.face_count();
  const auto is_small = [&](Index piece) {
    return faces[piece] < largest && static_cast<double>(faces[piece]) < least;
  };
  std::size_t dropped = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (faces[v] > 0 && is_small(v)) ++dropped;
  }
  if (dropped == 0) return 0;
  Mesh kept;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!is_small(pieces.find(mesh.face(f)[0]))) kept.add_face(mesh.face(f));
  }
  mesh.face_offsets = std::move(kept.face_offsets);
  mesh.face_vertices = std::move(kept.face_vertices);
  return dropped;
}

}  // namespace surpass::reconstruction

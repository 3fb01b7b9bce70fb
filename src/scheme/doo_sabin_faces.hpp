// The faces of the refined mesh, with what each of their corners was made of.
#pragma once

#include <vector>

#include "scheme/doo_sabin_layout.hpp"

namespace surpass::doo_sabin {

/// A corner of a new face. It comes out of the given corner `at`: as its corner point (`toward` is
/// kNone), or 3/4 of its vertex and 1/4 of the vertex of `toward`, a neighbour in the same face
/// (curve point) or `at` itself (kept vertex).
struct NewCorner {
  Index point = 0;
  Index at = 0;
  Index toward = kNone;
};

/// Polygons in compressed rows.
struct NewFaces {
  std::vector<Index> offsets = {0};
  std::vector<NewCorner> corners;

  [[nodiscard]] Index count() const { return static_cast<Index>(offsets.size() - 1); }
  [[nodiscard]] Index size(Index f) const { return offsets[f + 1] - offsets[f]; }
  void end_face() { offsets.push_back(static_cast<Index>(corners.size())); }
};

/// The quad of a smooth edge, or one quad for each side of a curve edge that has a face.
void append_edge_faces(const Layout& layout, Index e, NewFaces& faces);

/// The polygon of a smooth vertex or dart; one for each sector between curve edges; the triangles
/// of a tip. A curve vertex's polygon ends with the edge between its two curve points.
void append_vertex_faces(const Layout& layout, Index v, NewFaces& faces);

/// All faces of the refined mesh: those of faces, of edges, of vertices.
struct NewMesh {
  NewFaces faces;
  std::vector<Index> edge_face;    ///< #E: the first face of each edge
  std::vector<Index> vertex_face;  ///< #V: the first face of each vertex, or the next one's
};
[[nodiscard]] NewMesh new_mesh(const Layout& layout);

/// Position of the corner from which the edge between two points starts in a face.
[[nodiscard]] Index edge_position(const NewFaces& faces, Index f, Index a, Index b);

}  // namespace surpass::doo_sabin

// Masks of Catmull-Clark subdivision around one vertex with any polygons.
//
// Catmull, Clark, Recursively generated B-spline surfaces on arbitrary topological meshes, 1978;
// Halstead, Kass, DeRose, Efficient, fair interpolation using Catmull-Clark surfaces, 1993 (limit
// masks for quads); for other faces the limit mask follows by invariance under one refinement.
// Creases as OpenSubdiv has them, but for the limit at darts and at interior vertices of valence 2,
// which are exact here.
#pragma once

#include <vector>

#include "scheme/ring.hpp"
#include "scheme/settle.hpp"
#include "scheme/tangents.hpp"

namespace surpass::catmull_clark {

/// A ring with its faces. Points, and so the weights of masks, are in the order: center, spokes,
/// then the remaining vertices of the faces, face after face.
struct FaceRing : Ring {
  /// Positions of each face's vertices among the points, starting with 0, the center. Face j lies
  /// between the spokes j and j + 1; an open ring has one face less than spokes.
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Index> columns;  ///< mesh vertices of the points; empty for a refined ring

  [[nodiscard]] std::size_t point_count() const;
  [[nodiscard]] bool all_quads() const;
  [[nodiscard]] FaceRing child() const;
  [[nodiscard]] std::vector<Mask> child_masks() const;
  static FaceRing around(const Topology& topology, const Sharpness& sharpness, Index v);
};

/// Refined position of the center.
[[nodiscard]] Mask vertex_mask(const FaceRing& ring);

/// Limit position of the center, semi-sharp rings included.
[[nodiscard]] Mask limit_mask(const FaceRing& ring);

/// The faces must be quads, and no sharpness may fade.
[[nodiscard]] std::vector<Tangents> tangent_masks(const FaceRing& ring);

/// Ready for tangent_masks.
[[nodiscard]] bool is_settled(const FaceRing& ring);

/// A row over the one-ring of a plain vertex, as the refined position and the limit position have
/// it: `center` V + `spoke` sum of neighbours + `face` sum of the faces' centroids, all divided by
/// `sum`.
struct PlainRow {
  double center;
  double spoke;
  double face;
  double sum;
};
[[nodiscard]] PlainRow refined_row(std::size_t valence);
[[nodiscard]] PlainRow limit_row(std::size_t valence);

}  // namespace surpass::catmull_clark

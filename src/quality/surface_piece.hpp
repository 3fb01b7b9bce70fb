// Pieces of one surface with bounds of their distance to another.
#pragma once

#include <array>
#include <vector>

#include "quality/triangle_tree.hpp"

namespace surpass {

/// A triangle on one surface, with the nearest triangles of the other at its corners and centre.
/// The distance to one fixed triangle is a convex function of the point, so over the piece it is
/// largest at a corner: for every triangle t of the other surface,
///     max over x in piece of d(x, surface)  <=  max over corners v of d(v, t).
class SurfacePiece {
 public:
  SurfacePiece(const TriangleTree& to, const std::array<Sample, 3>& corners);

  /// The largest distance found at corners and centre, and where.
  [[nodiscard]] const Sample& farthest() const;
  /// No point of the piece is farther away, up to rounding.
  [[nodiscard]] double upper_bound() const { return upper_bound_; }
  [[nodiscard]] double longest_edge() const;
  [[nodiscard]] double area() const;

  /// The mean of f(distance) over the piece by a rule with weights 1/12 at the corners and 3/4 at
  /// the centre, which is exact for quadratic functions.
  template <class F>
  [[nodiscard]] double mean(F&& f) const {
    const double at_corners =
        f(corners_[0].distance) + f(corners_[1].distance) + f(corners_[2].distance);
    return at_corners / 12 + f(centre_.distance) * 0.75;
  }

  /// Halves the piece at its longest edge.
  void bisect(const TriangleTree& to, std::vector<SurfacePiece>& parts) const;
  /// Cuts the piece where it leaves the prism over the triangle nearest to its centre, so that
  /// parts of coinciding surfaces fall into single triangles; halves it if no cut goes deep.
  void cut(const TriangleTree& to, std::vector<SurfacePiece>& parts) const;

 private:
  void bound(const TriangleTree& to);

  std::array<Sample, 3> corners_;
  Sample centre_;
  double upper_bound_ = 0;
};

}  // namespace surpass

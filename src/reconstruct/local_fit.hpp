// The surface near a point, as the graph of a quadric over the plane of its neighbours.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

#include "reconstruct/vectors.hpp"

namespace surpass::reconstruction {

/// A plane through the centre of some points, by principal components.
struct LocalPlane {
  Eigen::Vector3d centre;
  Eigen::Matrix3d axes;  ///< columns: two in the plane, then the normal
  [[nodiscard]] Eigen::Vector3d local(const Point& p) const {
    return axes.transpose() * (as_vector(p) - centre);
  }
};
[[nodiscard]] LocalPlane fit_plane(std::span<const Point> points, std::span<const Index> chosen);

/// A height function of degree two over the plane, by least squares.
struct LocalFit {
  Point projected;       ///< the point moved to the quadric, along the plane's normal
  double deviation = 0;  ///< standard deviation of the heights from the quadric
};

/// For point i and its neighbours (at least six). Heights are scaled by the size of the
/// neighbourhood, so units do not matter.
[[nodiscard]] LocalFit fit_quadric(std::span<const Point> points, Index i,
                                   std::span<const Index> neighbours);

}  // namespace surpass::reconstruction

// The sum of squared distances to planes, as a quadratic function of the point.
#pragma once

#include <array>

#include <Eigen/Core>

namespace surpass::reconstruction {

/// M. Garland, P. Heckbert, Surface simplification using quadric error metrics, SIGGRAPH 1997.
class Quadric {
 public:
  /// The plane through `p` with this unit normal.
  void add_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
    const double d = -normal.dot(p);
    const std::array<double, 4> plane = {normal[0], normal[1], normal[2], d};
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) sums_[at++] += plane[i] * plane[j];
    }
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += other.sums_[i];
  }
  /// At p; rounding may make it a little negative.
  [[nodiscard]] double at(const Eigen::Vector3d& p) const {
    const auto& [xx, xy, xz, xw, yy, yz, yw, zz, zw, ww] = sums_;
    return p[0] * (xx * p[0] + 2 * (xy * p[1] + xz * p[2] + xw)) +
           p[1] * (yy * p[1] + 2 * (yz * p[2] + yw)) + p[2] * (zz * p[2] + 2 * zw) + ww;
  }

 private:
  std::array<double, 10> sums_ = {};
};

}  // namespace surpass::reconstruction

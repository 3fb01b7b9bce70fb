// Principal curvatures of a parametric surface from its derivatives.
#pragma once

#include <optional>

#include "scheme/limit_samples.hpp"

namespace surpass {

struct SurfaceCurvature {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double area_element = 0;  ///< |Su x Sv|
  double k1 = 0;  ///< the smaller one; negative where the surface bends away from the normal
  double k2 = 0;

  [[nodiscard]] double mean() const { return (k1 + k2) / 2; }
  [[nodiscard]] double gauss() const { return k1 * k2; }
  [[nodiscard]] double square() const { return k1 * k1 + k2 * k2; }
  [[nodiscard]] double largest() const { return std::max(std::abs(k1), std::abs(k2)); }
};

/// Nothing where Su and Sv are parallel to 1e-12 of the longer one, so that there is no plane.
[[nodiscard]] std::optional<SurfaceCurvature> curvature_of(const LimitJet& jet);

}  // namespace surpass

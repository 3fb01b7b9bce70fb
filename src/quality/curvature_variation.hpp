// How much the mean curvature varies over a sampled surface.
#pragma once

#include "quality/sampled_surface.hpp"

namespace surpass {

struct CurvatureVariation {
  double square = 0;  ///< integral of |grad H|^2
  double total = 0;   ///< integral of |grad H|
};

/// H is taken linear between measured samples, over triangles inscribed in the surface; a quad is
/// cut along both diagonals and the mean taken. In the unit of `surface`.
[[nodiscard]] CurvatureVariation curvature_variation(const SampledSurface& surface,
                                                     const MeasuredPart& part,
                                                     const Context& context);

}  // namespace surpass

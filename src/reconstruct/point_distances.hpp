// The single distances behind the figures.
#pragma once

#include <surpass/reconstruct.hpp>

#include <vector>

namespace surpass::reconstruction {

/// #points distances to the surface; NaN for points that are not finite.
[[nodiscard]] Result<std::vector<double>> distances_to(std::span<const Point> points,
                                                       const Mesh& surface, const Context& context);

/// NaN does not count.
[[nodiscard]] PointDistances summary(const std::vector<double>& distances);

}  // namespace surpass::reconstruction

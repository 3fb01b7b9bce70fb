// Points of eight patches to and from lanes. A point takes four numbers, of which the last is 0: so
// it moves as one.
#pragma once

#include <surpass/mesh.hpp>

#include <vector>

#include "interpolate/lanes.hpp"

namespace surpass {

inline constexpr std::size_t kPointStride = 4;

/// Those of `numbers` (by 3) with these indices.
[[nodiscard]] std::vector<double> padded_points(std::span<const Index> indices,
                                                std::span<const double> numbers);

/// points[c], c < columns, has in lane l the point local[l * columns + c] of `x`. Lanes from
/// `lanes` on are 0.
void gather_points(const Index* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors* points);

/// Adds them, lane after lane, to those of `y`.
void scatter_points(const Index* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors* points, double* y);

}  // namespace surpass

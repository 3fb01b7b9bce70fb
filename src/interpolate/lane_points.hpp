// Points of patches to and from lanes. A point takes four numbers, of which the last is 0: so
// it moves as one.
#pragma once

#include <surpass/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include "interpolate/lanes.hpp"

namespace surpass {

inline constexpr std::size_t kPointStride = 4;

/// Of a point among those of a chunk of patches.
using LocalIndex = std::uint16_t;

/// a.b; four sums, so that none waits for the one before.
[[nodiscard]] double dot_of_points(std::span<const double> a, std::span<const double> b);
[[nodiscard]] double dot_of_points(std::span<const double> a, std::span<const float> b);

/// points[c], c < columns, has in lane l the point local[l * columns + c] of `x`. Lanes from
/// `lanes` on are 0.
void gather_points(const LocalIndex* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors<double>* points);
/// The same as seen from the first one, column 0: then single precision tells apart what lies close
/// together, wherever it is. Of what is the same for all points nothing is left.
void gather_points(const LocalIndex* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors<float>* points);

/// Adds them, lane after lane, to those of `y`.
void scatter_points(const LocalIndex* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors<double>* points, double* y);
void scatter_points(const LocalIndex* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors<float>* points, float* y);

}  // namespace surpass

// Vertices that lie together.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass {

/// For each point the smallest number of a kept point that is at most `distance` away, or its own
/// number, and then it is kept itself. Points are taken in order, so kept ones are further apart
/// than `distance`. With distance 0 only equal coordinates meet; points that are not finite never
/// do. Expected O(#points).
[[nodiscard]] std::vector<Index> merge_targets(std::span<const Point> points, double distance);

}  // namespace surpass

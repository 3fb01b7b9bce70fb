// Limit points from rows of weights that sum to one.
#pragma once

#include <span>
#include <vector>

#include "scheme/sparse_rows.hpp"

namespace surpass {

/// The rows times the points. Wherever the mesh lies, with an error of about one unit in the last
/// place of the coordinates: what these have in common is taken away before, and added after.
/// O(#weights).
[[nodiscard]] std::vector<Point> limit_points(const SparseRows& rows, std::span<const Point> points,
                                              const Context& context);

}  // namespace surpass

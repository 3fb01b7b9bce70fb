// What is reported of a solve, and what is said of it.
#pragma once

#include "interpolate/similarity_solve.hpp"

namespace surpass {

/// Three numbers a point.
[[nodiscard]] std::vector<Point> points_of(std::span<const double> values);

/// Limits of the given vertices.
[[nodiscard]] std::vector<Point> limits_of(const SimilarityPrepared& prepared,
                                           std::span<const Point> control, const Context& context);

/// `limits`: of the given vertices, which shall be at `points`; `side`: of the given box.
[[nodiscard]] SimilarityReport similarity_report(const SimilarityPrepared& prepared, Found& found,
                                                 std::span<const Point> limits,
                                                 std::span<const Point> points, double side,
                                                 const Context& context);

}  // namespace surpass

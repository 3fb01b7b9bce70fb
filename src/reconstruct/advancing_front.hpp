// The door to CGAL: nothing else in Surpass names it.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <array>
#include <span>
#include <vector>

namespace surpass::reconstruction {

using Triangle = std::array<Index, 3>;

/// Triangles over the points (finite; equal ones count once), oriented alike in each piece, by
/// CGAL's advancing front with its default parameters. No triangle has a perimeter above
/// `perimeter`, unless that is 0. Points on a line, or fewer than three, give no triangle. The
/// order of the triangles depends on the points alone. Stages "delaunay" and "front". Errors:
/// cancelled; what CGAL's own checks find (`singular`).
[[nodiscard]] Result<std::vector<Triangle>> advancing_front(std::span<const Point> points,
                                                            double perimeter,
                                                            const Context& context);

}  // namespace surpass::reconstruction

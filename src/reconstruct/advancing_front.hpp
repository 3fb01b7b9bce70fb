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
/// `perimeter`, unless that is 0. Points on a line, or fewer than three, give no triangle. They
/// start with their smallest vertex and are in order; which side each piece is seen from is left to
/// chance. Stages "delaunay" and "front". Errors:
/// cancelled; what CGAL's own checks find (`singular`).
/// CGAL settles ties (equal radii and angles, as on grids) by addresses in memory: points that are
/// `untied` have none, and give the same triangles always.
[[nodiscard]] Result<std::vector<Triangle>> advancing_front(std::span<const Point> points,
                                                            double perimeter,
                                                            const Context& context);

/// Every coordinate moved by up to `amount`, as the point's number says; but points in one plane
/// stay as they are, for out of it their triangles would be chosen by chance.
[[nodiscard]] std::vector<Point> untied(std::span<const Point> points, double amount);

}  // namespace surpass::reconstruction

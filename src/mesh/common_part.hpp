// Far from the origin the coordinates of a mesh have their first digits in common. Sums of them
// round those digits again and again, though they cancel in the end.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass {

/// A point in the box, with 0 along the axes where the box is nearer to 0 than it is long. To take
/// it away from points of the box is exact: differences of numbers within a factor of two are
/// (Sterbenz, Floating-point computation, 1974).
[[nodiscard]] Point common_part(const Box& box);

/// Whether there is something to take away.
[[nodiscard]] bool is_far(const Point& common);

/// points + sign * common, in place. O(#points).
void add_common(std::span<Point> points, const Point& common, double sign);

}  // namespace surpass

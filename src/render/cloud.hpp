// How points without faces are to be drawn: each with the tilt of the points around it.
#pragma once

#include <surpass/context.hpp>

#include <span>
#include <vector>

#include "render/vector.hpp"

namespace surpass::picture {

struct Cloud {
  std::vector<Vec3> normals;  ///< unit, of either sign; zero where the points around tell none
  float spacing = 0;          ///< median distance from a point to its nearest neighbour
};

/// Planes through the nearest points. O(#points log #points); the same bits for any threads.
[[nodiscard]] Cloud look_at_cloud(std::span<const Vec3> points, const Context& context);

}  // namespace surpass::picture

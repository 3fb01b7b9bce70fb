// The mesh's edges as lines of constant width in the picture, drawn where the surface is seen.
#pragma once

#include <span>
#include <vector>

#include "render/camera.hpp"
#include "render/display_mesh.hpp"

namespace surpass::picture {

class EdgeLines {
 public:
  EdgeLines(std::span<const Vec3> points, const Camera& camera);

  /// How much of a sample at a place of the picture a line covers, 0 to 1. `spacing` is the
  /// distance of samples in pixels.
  [[nodiscard]] float coverage(const Triangle& triangle, const Vec2& place, float spacing) const;

 private:
  std::vector<Vec2> places_;
};

}  // namespace surpass::picture

// What is behind everything.
#pragma once

#include <surpass/render.hpp>

#include "render/vector.hpp"

namespace surpass::picture {

/// Linear light of the background, `down` of the way from the upper edge of the picture to the
/// lower.
[[nodiscard]] inline Colour backdrop(float down) {
  const Colour top = {0.955F, 0.955F, 0.945F};
  const Colour bottom = {0.700F, 0.712F, 0.722F};
  return top + (bottom - top) * down;
}

/// The same for a row of pixels.
[[nodiscard]] inline Colour backdrop(int row, int height) {
  return backdrop((static_cast<float>(row) + 0.5F) / static_cast<float>(height));
}

/// The background and nothing before it.
[[nodiscard]] Image blank(int width, int height);

}  // namespace surpass::picture

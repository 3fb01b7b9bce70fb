// Rules at corners and on creases, the same in Loop and Catmull-Clark subdivision: there the
// neighbourhood across a sharp edge plays no part. Masks are over the points of a ring: center,
// spokes, others.
#pragma once

#include "scheme/ring.hpp"
#include "scheme/settle.hpp"

namespace surpass {

/// The center stays.
[[nodiscard]] inline Mask corner_mask(std::size_t points) {
  Mask mask(points, 0.0);
  mask[0] = 1;
  return mask;
}

/// `center` at the center and the rest in equal parts at the two sharp spokes.
[[nodiscard]] inline Mask curve_mask(const Ring& ring, std::size_t points, double center) {
  Mask mask(points, 0.0);
  mask[0] = center;
  for (const std::size_t j : ring.sharp_spokes()) mask[1 + j] = (1 - center) / 2;
  return mask;
}

/// The refined position of the center; smooth() is its mask where no rule of curves applies. Where
/// sharpness runs out, the child's rule is blended in: OpenSubdiv's uniform creasing.
template <class Smooth>
[[nodiscard]] Mask refined_mask(const Ring& ring, std::size_t points, Smooth&& smooth) {
  const auto mask_of = [&](const Ring& choice) {
    switch (choice.rule()) {
      case VertexRule::corner: return corner_mask(points);
      case VertexRule::crease: return curve_mask(choice, points, 3.0 / 4);
      default: return smooth();
    }
  };
  Mask mask = mask_of(ring);
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth || rule == VertexRule::dart) return mask;
  const Ring child = ring.child();
  if (child.rule() == rule) return mask;
  // Applied to the parent's points; only the choice of sharp spokes is the child's.
  blend(mask, static_cast<double>(transitional_weight(ring, child)), mask_of(child));
  return mask;
}

}  // namespace surpass

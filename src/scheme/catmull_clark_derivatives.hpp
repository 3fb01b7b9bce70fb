// Derivatives of Catmull-Clark surfaces at a vertex among quads, where they have a closed form.
#pragma once

#include <optional>

#include "scheme/catmull_clark_masks.hpp"

namespace surpass::catmull_clark {

/// In a parameter that grows by 1 along the spoke; the sign of `first` is not fixed. Empty where
/// there is no such derivative, or none that is known.
struct SpokeDerivatives {
  std::optional<Mask> first;
  std::optional<Mask> second;
};

/// Along a spoke, as a side of the face that is seen. The faces of the ring must be quads.
[[nodiscard]] SpokeDerivatives spoke_derivatives(const FaceRing& ring, std::size_t spoke);

/// The mixed second derivative at the corner of face `face` of the ring; its sign is not fixed.
[[nodiscard]] std::optional<Mask> mixed_derivative(const FaceRing& ring, std::size_t face);

/// The limit tangent along a spoke of an extraordinary vertex, scaled such that valence 4 would
/// give the derivative; empty where the vertex is not smooth, or of valence 2.
[[nodiscard]] std::optional<Mask> tangent_along(const FaceRing& ring, std::size_t spoke);

}  // namespace surpass::catmull_clark

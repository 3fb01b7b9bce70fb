// Parameters of non-stationary Loop subdivision: how they go on, and what they do to a ring.
#pragma once

#include <surpass/nonstationary.hpp>

namespace surpass::nonstationary {

/// v after so many steps of the iteration. Geometric: 1 + (v - 1) rate^-steps.
[[nodiscard]] double iterated(double v, int steps, const NonstationaryOptions& options);

/// The value in the mask of a level whose parameter is v: v itself, but its successor under the
/// exponential iteration, as with exponential polynomials.
[[nodiscard]] double in_mask(double v, const NonstationaryOptions& options);

/// Levels after which every parameter is 1 to less than rounding.
[[nodiscard]] int settling_levels(const NonstationaryOptions& options);

/// Weight of the ring at parameter 1.
[[nodiscard]] double ring_weight(Index valence, LoopWeights weights);

/// lambda and its derivative by the first parameter alpha of the vertex; `beta` is the edges'.
/// steps 0: in the limit.
struct Share {
  double value = 0;
  double derivative = 0;
};
[[nodiscard]] Share share_of_centroid(double alpha, double beta, double ring, int steps,
                                      const NonstationaryOptions& options);

/// Factors by which second derivatives at a vertex of valence 6 exceed those that Loop's rules see
/// in its ring: of the Laplacian, and of the rest.
struct BendFactors {
  double laplacian = 1;
  double deviator = 1;
};
[[nodiscard]] BendFactors bend_factors(double alpha, double beta,
                                       const NonstationaryOptions& options);

}  // namespace surpass::nonstationary

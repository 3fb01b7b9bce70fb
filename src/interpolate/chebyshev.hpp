// Chebyshev's semi-iteration with sweeps in single precision (see sweeps.hpp).
#pragma once

#include "interpolate/solvers.hpp"

namespace surpass {

/// Rounds of as many sweeps as are likely to be needed, with a test after each: two, where points
/// are a hundredth of the unit off and the tolerance is not below 1e-12.
Verdict chebyshev_iteration(const LinearSystem& system, SemiIteration coefficients,
                            Monitor& monitor, std::span<double> x);

/// Exactly `sweeps` sweeps, nothing tested in between. False if cancelled.
bool chebyshev_iteration_blind(const LinearSystem& system, SemiIteration coefficients,
                               unsigned sweeps, std::span<double> x);

}  // namespace surpass

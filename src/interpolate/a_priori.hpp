// "One can go directly from M0 to Mk": how many sweeps suffice, before the first is done.
#pragma once

#include "interpolate/linear_system.hpp"

namespace surpass {

/// Sweeps after which no vertex of a proven block is farther than `tolerance` (absolute, times the
/// system's scale) from its target, given x. With |r|_d^2 = sum d_i |r_i|^2 and the eigenvalues of
/// L in [lo, 1], |r_k|_max <= (min d)^(-1/2) q_k |r_0|_d, where q_k is (1 - lo)^k for Richardson
/// and 2 s^k / (1 + s^2k), s = (1 - sqrt lo) / (1 + sqrt lo), for Chebyshev. Costs one evaluation.
[[nodiscard]] unsigned sweeps_needed(const LinearSystem& system, Solver solver,
                                     std::span<const double> x, double tolerance);

}  // namespace surpass

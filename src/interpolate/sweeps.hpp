// A semi-iteration whose sweeps are single precision: they correct a point that is double, and from
// time to time the correction is added to the point and the residual measured anew.
//
// x is the point, r = target - L x in double precision. The sweeps work on z, which starts at 0 and
// goes towards the solution of L z = r, with all numbers rounded to 24 bits: half the memory, and
// an error of a few 1e-7 of r. Then x + z is the new point. The momentum goes on over that, so
// apart from rounding the points are those of the same iteration in double precision. Wilkinson,
// Rounding errors in algebraic processes, 1963 (iterative refinement).
#pragma once

#include <algorithm>
#include <functional>

#include "interpolate/linear_system.hpp"

namespace surpass {

/// Coefficients of one sweep: next = x + momentum (x - previous) + step (target - L x).
struct SweepStep {
  double momentum;
  double step;
};

struct SweepErrors {
  ErrorNorms start;  ///< of the target itself, if these evaluations are the first
  ErrorNorms last;   ///< of the newest point
};

/// Is told now and then which part is done.
using Tick = std::function<void(double)>;

/// By how much a residual may shrink between two that are measured: more is lost in rounding.
inline constexpr double kLargestGain = 1e5;

/// Residuals times this are what sweeps work on: a power of two that takes them to where single
/// precision has room on both sides, 60 powers of ten below and 19 above the unit.
[[nodiscard]] inline double correction_scale(const LinearSystem& system) {
  return std::min(system.scale, 0x1p900) * 0x1p60;
}

}  // namespace surpass

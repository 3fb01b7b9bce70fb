// One sweep of a semi-iteration over one level of ordered rows.
#pragma once

#include "interpolate/linear_system.hpp"
#include "interpolate/ordered_rows.hpp"

namespace surpass {

/// Numbers that a place has in the arrays of a sweep: three, which most systems have and which move
/// a quarter less memory than four, or twice as many.
[[nodiscard]] constexpr std::size_t sweep_stride(std::size_t width) {
  return OrderedRows::kStride * (width <= OrderedRows::kStride ? 1 : 2);
}

/// The arrays, each with a number to spare behind the last place: registers hold four, and the
/// fourth of three is loaded, but never used or stored.
struct SweepPoints {
  const double* target;
  const double* current;
  const double* previous;
  double* next;  ///< in the place of the previous one, but for the first two sweeps
};

/// Coefficients of one sweep.
struct SweepStep {
  double momentum;
  double step;
};

/// next = current + momentum * (current - previous) + step * (target - L current), with the
/// operations of LinearSystem::sweep in their order. Of the places next to the level's and the
/// neighbouring ones', the first number may be read. With `norms`, the errors of `current`, times
/// `scale`, are added to them. At most 4 right-hand sides.
void sweep_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const SweepPoints& points, const SweepStep& sweep, double scale,
                 ErrorNorms* norms);

}  // namespace surpass

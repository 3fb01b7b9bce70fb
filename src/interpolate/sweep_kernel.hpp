// One stage of the sweeps of sweeps.hpp over one level of ordered rows.
#pragma once

#include "interpolate/ordered_rows.hpp"
#include "interpolate/sweeps.hpp"

namespace surpass {

/// Numbers that a place has in the arrays of a sweep: three, which most systems have and which move
/// a quarter less memory than four, or twice as many.
[[nodiscard]] constexpr std::size_t sweep_stride(std::size_t width) {
  return OrderedRows::kStride * (width <= OrderedRows::kStride ? 1 : 2);
}

// All arrays have a number to spare behind the last place: registers hold four, and the fourth of
// three is loaded, but never used or stored. Of the places next to the level's and the neighbouring
// ones', the first number may be read. Right-hand sides are `width`, 4 at most.

/// A sweep of the correction.
struct CorrectionSweep {
  SweepStep step;
  const float* residual;
  const float* current;
  float* next;  ///< in the place of the correction before
  bool fresh;   ///< there is none before: it counts as 0
  /// Where this is the last sweep before the residual: `to` = `from` + the new correction times
  /// `unit`, and what comes to `next` is by how much the sweep moved. Else null.
  const double* from;
  double* to;
  double unit;
};

/// next = current + momentum (current - previous) + step (residual - L current).
void sweep_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const CorrectionSweep& sweep);

/// The residual of a point, measured, and the first sweep from it.
struct ResidualSweep {
  SweepStep step;
  const double* target;
  const double* point;
  double norm_scale;  ///< of the norms
  double scale;       ///< of the residual that is stored
  float* residual;
  /// Enters holding by how much the last sweep moved, unless `fresh`: then by nothing. Leaves
  /// holding momentum times that + step * residual.
  float* correction;
  bool fresh;
};

/// residual = (target - L point) * scale, with the operations of LinearSystem::residual in their
/// order. Its errors are added to `norms`.
void measure_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                   const ResidualSweep& sweep, ErrorNorms& norms);

}  // namespace surpass

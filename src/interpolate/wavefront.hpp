// Many sweeps of a semi-iteration in one pass over memory.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "interpolate/ordered_rows.hpp"
#include "interpolate/solvers.hpp"

namespace surpass {

/// The iterates of a semi-iteration on a block whose rows are ordered. `advance` has the same bits
/// as LinearSystem::sweep repeated: every number comes from the same operations in the same order.
class Wavefront {
 public:
  static constexpr std::size_t kWidth = 4;  ///< right-hand sides at most
  /// A point, or what else has so many numbers; those that there are not, are 0.
  using Four [[gnu::vector_size(32)]] = double;
  struct alignas(32) Values {  // aligned as machines with wide registers expect it
    Four four;
  };

  /// Starts at the target; what lies outside the block is taken from x (#V by width).
  Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x);

  /// Coefficients of one sweep.
  struct Sweep {
    double momentum;
    double step;
  };

  /// Does all sweeps, at least one; the errors are those of the point before the last one. Nothing
  /// if cancelled. `tick`, if there is one, is told now and then which part is done.
  std::optional<ErrorNorms> advance(std::span<const Sweep> sweeps,
                                    const std::function<void(double)>& tick = {});

  /// The point that was measured last, written to the block's part of x.
  void copy_measured(std::span<double> x) const { copy(measured_, x); }
  /// The point after the last sweep.
  void copy_newest(std::span<double> x) const { copy(1 - measured_, x); }

 private:
  struct Passage;
  bool sweep_together(std::span<const Sweep> sweeps, std::size_t parity, Passage* before,
                      Passage* after, ErrorNorms* norms,
                      const std::function<void(double)>& tick) const;
  void copy(std::size_t from, std::span<double> x) const;

  const OrderedRows& rows_;
  const LinearSystem& system_;
  std::unique_ptr<Values[]> target_;
  std::array<std::unique_ptr<Values[]>, 2> points_;  // of two sweeps, taking turns
  std::size_t measured_ = 1;                         // the older of them
};

/// The ordered rows of the system's block, or null if it cannot be swept over with them.
[[nodiscard]] inline const OrderedRows* rows_to_sweep(const LinearSystem& system) {
  return system.width <= Wavefront::kWidth ? system.block.ordered.get() : nullptr;
}

/// semi_iteration on ordered rows: the sweeps that are likely to be needed are done without a test
/// in between.
Verdict wavefront_iteration(const OrderedRows& rows, const LinearSystem& system,
                            SemiIteration coefficients, Monitor& monitor, std::span<double> x);

/// semi_iteration_blind on ordered rows.
bool wavefront_iteration_blind(const OrderedRows& rows, const LinearSystem& system,
                               SemiIteration coefficients, unsigned sweeps, std::span<double> x);

}  // namespace surpass

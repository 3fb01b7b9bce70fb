// Many sweeps of a semi-iteration in one pass over memory.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "interpolate/ordered_rows.hpp"
#include "interpolate/solvers.hpp"
#include "interpolate/sweep_arrays.hpp"
#include "interpolate/sweep_kernel.hpp"

namespace surpass {

/// The iterates of a semi-iteration on a block whose rows are ordered. `advance` has the same bits
/// as LinearSystem::sweep repeated: every number comes from the same operations in the same order.
class Wavefront {
 public:
  static constexpr std::size_t kWidth = 4;  ///< right-hand sides at most

  /// Starts at the target; what lies outside the block is taken from x (#V by width).
  Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x);
  Wavefront(const Wavefront&) = delete;
  Wavefront& operator=(const Wavefront&) = delete;
  ~Wavefront();

  using Sweep = SweepStep;

  struct Errors {
    ErrorNorms start;  ///< of the target itself, if these sweeps are the first
    ErrorNorms last;   ///< of the point before the last sweep
  };

  /// Does all sweeps, at least one. Nothing if cancelled, after which there is no point to be
  /// copied. The very first sweep has no momentum. `tick`, if there is one, is told now and then
  /// which part is done.
  std::optional<Errors> advance(std::span<const Sweep> sweeps,
                                const std::function<void(double)>& tick = {});

  /// What it started from, written to the block's part of x.
  void copy_target(std::span<double> x) const { copy(0, x); }
  /// The point that was measured last, written to the block's part of x.
  void copy_measured(std::span<double> x) const { copy(done_ - 1, x); }
  /// The point after the last sweep.
  void copy_newest(std::span<double> x) const { copy(done_, x); }

 private:
  struct Passage;
  struct Group {  // of stages that one thread does
    std::size_t begin;
    std::size_t end;
    Passage* before;
    Passage* after;
  };

  /// The point after `sweeps` sweeps, which for the newest three of them is still there.
  [[nodiscard]] double* point(std::size_t sweeps) const;
  bool go(const Group& group, std::span<const Sweep> sweeps, Errors& errors,
          const std::function<void(double)>& tick) const;
  /// Stages before the sweeps.
  [[nodiscard]] std::size_t gathers() const { return done_ == 0 ? 1 : 0; }
  void gather(std::size_t level) const;
  void copy(std::size_t sweeps, std::span<double> x) const;

  const OrderedRows& rows_;
  const LinearSystem& system_;
  std::size_t stride_;
  SweepArrays arrays_;
  std::size_t done_ = 0;  // sweeps
};

/// The ordered rows of the system's block, or null if it cannot be swept over with them.
[[nodiscard]] inline const OrderedRows* rows_to_sweep(const LinearSystem& system) {
  return system.width <= Wavefront::kWidth ? system.block.ordered.get() : nullptr;
}

/// semi_iteration on ordered rows: the sweeps that are likely to be needed are done in two passes
/// over memory, with a test after each.
Verdict wavefront_iteration(const OrderedRows& rows, const LinearSystem& system,
                            SemiIteration coefficients, Monitor& monitor, std::span<double> x);

/// semi_iteration_blind on ordered rows.
bool wavefront_iteration_blind(const OrderedRows& rows, const LinearSystem& system,
                               SemiIteration coefficients, unsigned sweeps, std::span<double> x);

}  // namespace surpass

// Many sweeps of a semi-iteration in one pass over memory.
#pragma once

#include <optional>
#include <vector>

#include "interpolate/ordered_rows.hpp"
#include "interpolate/sweep_arrays.hpp"
#include "interpolate/sweep_kernel.hpp"

namespace surpass {

/// The sweeps of sweeps.hpp on a block whose rows are ordered, with the bits of PlainSweeps: every
/// number comes from the same operations in the same order.
class Wavefront {
 public:
  static constexpr std::size_t kWidth = 4;  ///< right-hand sides at most

  /// Starts at the target; what lies outside the block is taken from x (#V by width).
  Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x);
  Wavefront(const Wavefront&) = delete;
  Wavefront& operator=(const Wavefront&) = delete;
  ~Wavefront();

  /// As many evaluations of the limit as there are sweeps, at least one. The last is measured, and
  /// so is the very first one; its sweep has no momentum. Nothing if cancelled, after which there
  /// is no point to be copied. The measured point is also written to the block's part of `out`,
  /// if there is one: that costs less than copying it afterwards.
  std::optional<SweepErrors> advance(std::span<const SweepStep> sweeps, const Tick& tick = {},
                                     std::span<double> out = {});

  /// The point that was measured last, written to the block's part of x.
  void copy_measured(std::span<double> x) const;

 private:
  struct Passage;
  struct Round;
  struct Group {  // of stages that one thread does
    std::size_t begin;
    std::size_t end;
    Passage* before;
    Passage* after;
  };

  bool go(const Group& group, Round& round, const Tick& tick) const;
  void run_stage(std::size_t stage, std::size_t level, Round& round) const;
  template <class Use>
  void for_vertices(std::size_t level, const double* array, Use&& use) const;
  void gather(std::size_t level) const;
  void hand_out(std::size_t level, double* out) const;
  void measure(std::size_t level, Round& round, bool is_start) const;
  void sweep(std::size_t level, const Round& round, std::size_t at) const;
  void move(std::size_t level) const;

  /// The target is the first point and stays where it is.
  [[nodiscard]] const double* point() const {
    return done_ <= 1 ? arrays_.target.get() : arrays_.point.get();
  }
  /// The correction after so many sweeps of a round.
  [[nodiscard]] float* correction(std::size_t sweeps) const {
    return arrays_.corrections[(newest_ + sweeps) % 2].get();
  }

  const OrderedRows& rows_;
  const LinearSystem& system_;
  std::size_t stride_;
  double scale_;  // of residual and corrections
  SweepArrays arrays_;
  std::size_t done_ = 0;    // evaluations
  std::size_t newest_ = 0;  // which array has the correction
};

/// The ordered rows of the system's block, or null if it cannot be swept over with them.
[[nodiscard]] inline const OrderedRows* rows_to_sweep(const LinearSystem& system) {
  return system.width <= Wavefront::kWidth ? system.block.ordered.get() : nullptr;
}

}  // namespace surpass

// What a solver of a FreeSystem notes while it iterates, and when it ends.
#pragma once

#include <algorithm>
#include <cmath>

#include "interpolate/free_system.hpp"

namespace surpass {

class FreeProgress {
 public:
  /// `gradient`: at the start; what follows is relative to its length.
  FreeProgress(const FreeSystem& system, const StopAt& stop, std::span<const double> gradient)
      : system_(system), stop_(stop), start_(std::sqrt(system.dot(gradient, gradient))) {
    outcome_.at_rest = start_ == 0;
  }

  /// Whether another iteration is to follow.
  [[nodiscard]] bool goes_on() {
    if (start_ == 0 || reached_ || outcome_.iterations >= stop_.max_iterations) return false;
    outcome_.cancelled = system_.context.cancelled();
    return !outcome_.cancelled;
  }

  /// An iteration has led to a gradient of this squared length.
  void note(double squared) {
    const double residual = std::sqrt(squared) / start_;
    ++outcome_.iterations;
    outcome_.residuals.push_back(residual);
    reached_ = residual <= stop_.tolerance;
    const double fraction = std::log(residual) / std::log(stop_.tolerance);
    system_.context.report({.stage = "solve",
                            .fraction = fraction >= 0 ? std::min(1.0, fraction) : 0.0,
                            .iteration = outcome_.iterations,
                            .residual = residual});
  }

  [[nodiscard]] bool reached() const { return reached_; }
  [[nodiscard]] FreeOutcome outcome() && { return std::move(outcome_); }

 private:
  const FreeSystem& system_;
  StopAt stop_;
  double start_;
  bool reached_ = false;
  FreeOutcome outcome_;
};

}  // namespace surpass

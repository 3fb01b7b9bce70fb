// Decides when an iteration ends, keeps its history, and carries progress and cancellation.
#pragma once

#include <surpass/interpolate.hpp>

#include <string_view>

#include "interpolate/linear_system.hpp"

namespace surpass {

enum class Verdict {
  go_on,
  reached,    ///< the error is within the tolerance
  exhausted,  ///< no evaluations left
  stalled,    ///< no progress any more, or the error is not a number
  cancelled,
};

struct StopRule {
  double tolerance = 0;  ///< relative to unit
  double unit = 1;       ///< the length of which errors are fractions
  unsigned max_iterations = 0;
  bool full_history = false;
  bool stop_when_stalled = false;
  std::string_view stage = "solve";
};

class Monitor {
 public:
  Monitor(const StopRule& rule, const LinearSystem& system) : rule_(rule), system_(system) {}

  /// Takes the error of the next evaluation of the limit, or of the one `steps` ahead.
  Verdict record(const ErrorNorms& norms, unsigned steps = 1);

  /// Tells how far the `steps` evaluations to come are, of which only the last will be recorded.
  void announce(double part, unsigned steps) const;

  /// By how much the last error is above the tolerance, as a factor.
  [[nodiscard]] double excess() const { return last_.max / rule_.tolerance; }
  [[nodiscard]] double tolerance() const { return rule_.tolerance; }
  [[nodiscard]] unsigned iterations_left() const { return rule_.max_iterations - last_.iteration; }

  /// Every evaluation is to be recorded.
  [[nodiscard]] bool wants_each() const { return rule_.full_history; }

  [[nodiscard]] unsigned iterations() const { return last_.iteration; }
  [[nodiscard]] const Iteration& first() const { return first_; }
  [[nodiscard]] const Iteration& last() const { return last_; }
  [[nodiscard]] const Iteration& best() const { return best_; }
  /// Ended so, the iteration stands at a point that is worse than an earlier one.
  [[nodiscard]] bool passed_best(Verdict verdict) const {
    const bool failed = verdict == Verdict::exhausted || verdict == Verdict::stalled;
    return failed && best_.max != last_.max;
  }
  /// Every iteration, or the first and the last.
  [[nodiscard]] std::vector<Iteration> history() const;

 private:
  // Evaluations without a tenth gained after which an iteration counts as stalled.
  static constexpr unsigned kPatience = 200;

  [[nodiscard]] double fraction() const;

  StopRule rule_;
  const LinearSystem& system_;
  Iteration first_;
  Iteration last_;
  Iteration best_;
  Iteration progress_;  // the last one that gained a tenth
  std::vector<Iteration> history_;
};

}  // namespace surpass

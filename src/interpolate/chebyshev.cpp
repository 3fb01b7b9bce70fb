#include "interpolate/chebyshev.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "interpolate/plain_sweeps.hpp"
#include "interpolate/wavefront.hpp"

namespace surpass {
namespace {

constexpr unsigned kMostSweeps = 64;  // at once: more of them would leave the cache

std::vector<SweepStep> next_steps(SemiIteration& coefficients, unsigned count) {
  std::vector<SweepStep> steps;
  for (unsigned k = 0; k < count; ++k) {
    steps.push_back({coefficients.momentum(), coefficients.step()});
    coefficients.advance();
  }
  return steps;
}

// Sweeps that bring an error down by `factor`, or as far as one round can.
unsigned likely_sweeps(double factor, double reduction) {
  const double gain = std::min(factor, kLargestGain);
  const double wanted = std::ceil(std::log(gain) / -std::log(reduction));
  return static_cast<unsigned>(std::clamp(wanted, 1.0, double{kMostSweeps}));
}

// About half of the sweeps that points take which are a hundredth of the unit off: with how far the
// limit is, the second round is told how many are left.
unsigned first_sweeps(const Monitor& monitor, double reduction) {
  constexpr double kUsualError = 1e-2;
  const double factor = std::max(1.0, kUsualError / monitor.tolerance());
  return std::min(likely_sweeps(std::sqrt(factor), reduction), monitor.iterations_left());
}

// Calls use(sweeps) with the fast sweeps where rows are ordered, else with the plain ones.
template <class Use>
auto with_sweeps(const LinearSystem& system, std::span<const double> x, Use&& use) {
  if (const OrderedRows* rows = rows_to_sweep(system)) {
    Wavefront sweeps(*rows, system, x);
    return use(sweeps);
  }
  PlainSweeps sweeps(system, x);
  return use(sweeps);
}

// Writes the point after these rounds to x. False if cancelled.
bool repeat_rounds(const LinearSystem& system, SemiIteration coefficients,
                   std::span<const unsigned> rounds, std::span<double> x) {
  return with_sweeps(system, x, [&](auto& sweeps) {
    for (const unsigned count : rounds) {
      if (!sweeps.advance(next_steps(coefficients, count))) return false;
    }
    sweeps.copy_measured(x);
    return true;
  });
}

// The iteration, and what its rounds were.
class Rounds {
 public:
  Rounds(const LinearSystem& system, const SemiIteration& start, Monitor& monitor)
      : system_(system), start_(start), coefficients_(start), monitor_(monitor) {}

  template <class Sweeps>
  Verdict run(Sweeps& sweeps, std::span<double> x) {
    auto errors = advance(sweeps, first_sweeps(monitor_, start_.reduction()));
    if (!errors) return Verdict::cancelled;
    Verdict verdict = monitor_.record(errors->start);
    if (verdict != Verdict::go_on) {
      system_.for_values([&](std::size_t at, std::size_t) { x[at] = system_.target[at]; });
      return verdict;
    }
    if (rounds_.back() > 1) verdict = monitor_.record(errors->last, rounds_.back() - 1);
    bool is_copied = false;
    while (verdict == Verdict::go_on) {
      const unsigned count = std::min(likely_sweeps(monitor_.excess(), start_.reduction()),
                                      monitor_.iterations_left());
      errors = advance(sweeps, count, x);
      verdict = errors ? monitor_.record(errors->last, count) : Verdict::cancelled;
      is_copied = true;
    }
    if (!is_copied && verdict != Verdict::cancelled) sweeps.copy_measured(x);
    return verdict;
  }

  /// The iteration is deterministic: its best point is found again by going there.
  void return_to_best(std::span<double> x) {
    unsigned evaluations = 0;
    std::size_t count = 0;
    while (count < rounds_.size() && evaluations < monitor_.best().iteration) {
      evaluations += rounds_[count++];
    }
    // The very first point is measured, too, in the middle of its round.
    if (evaluations > monitor_.best().iteration) rounds_.front() = 1;
    repeat_rounds(system_, start_, std::span(rounds_).first(count), x);
  }

 private:
  template <class Sweeps, class... Out>
  auto advance(Sweeps& sweeps, unsigned count, Out... out) {
    rounds_.push_back(count);
    return sweeps.advance(
        next_steps(coefficients_, count), [&](double part) { monitor_.announce(part, count); },
        out...);
  }

  const LinearSystem& system_;
  SemiIteration start_;
  SemiIteration coefficients_;
  Monitor& monitor_;
  std::vector<unsigned> rounds_;  // evaluations in each
};

}  // namespace

Verdict chebyshev_iteration(const LinearSystem& system, SemiIteration coefficients,
                            Monitor& monitor, std::span<double> x) {
  Rounds rounds(system, coefficients, monitor);
  const Verdict verdict =
      with_sweeps(system, x, [&](auto& sweeps) { return rounds.run(sweeps, x); });
  if (monitor.passed_best(verdict)) rounds.return_to_best(x);
  return verdict;
}

bool chebyshev_iteration_blind(const LinearSystem& system, SemiIteration coefficients,
                               unsigned sweeps, std::span<double> x) {
  const unsigned most = likely_sweeps(kLargestGain, coefficients.reduction());
  std::vector<unsigned> rounds;
  for (unsigned left = sweeps + 1; left > 0; left -= rounds.back()) {
    rounds.push_back(std::min(left, most));
  }
  return repeat_rounds(system, coefficients, rounds, x);
}

}  // namespace surpass

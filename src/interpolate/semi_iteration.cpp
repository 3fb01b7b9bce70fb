// Richardson's iteration (the paper's) and Chebyshev's acceleration of it: the same sweep with
// other coefficients. Golub and Varga, Chebyshev semi-iterative methods, 1961.
#include <algorithm>
#include <cmath>

#include "interpolate/solvers.hpp"

namespace surpass {

SemiIteration SemiIteration::chebyshev(double lowest) {
  SemiIteration c;
  const double middle = (lowest + 1) / 2;
  c.half_width_ = (1 - lowest) / 2;
  c.step_ = 1 / middle;
  c.reduction_ = (1 - std::sqrt(lowest)) / (1 + std::sqrt(lowest));
  if (c.half_width_ == 0) return c;  // L is the identity
  c.sigma_ = middle / c.half_width_;
  c.rho_ = 1 / c.sigma_;
  return c;
}

// The recurrence is the same, U_1 is twice T_1.
SemiIteration SemiIteration::chebyshev_of_second_kind(double lowest) {
  SemiIteration c = chebyshev(lowest);
  c.rho_ /= 2;
  return c;
}

void SemiIteration::advance() {
  if (half_width_ == 0) return;
  const double rho = 1 / (2 * sigma_ - rho_);
  momentum_ = rho * rho_;
  step_ = 2 * rho / half_width_;
  rho_ = rho;
}

namespace {

void start_from_target(const LinearSystem& system, std::span<double> x) {
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
}

// Two arrays take turns; the one that holds the result may be the wrong one.
class Buffers {
 public:
  explicit Buffers(std::span<double> x)
      : x_(x), other_(x.begin(), x.end()), current_(x), next_(other_) {}
  [[nodiscard]] std::span<double> current() const { return current_; }
  [[nodiscard]] std::span<double> next() const { return next_; }
  void swap() { std::swap(current_, next_); }
  void finish() {
    if (current_.data() != x_.data()) std::copy(current_.begin(), current_.end(), x_.begin());
  }

 private:
  std::span<double> x_;
  std::vector<double> other_;
  std::span<double> current_;
  std::span<double> next_;
};

}  // namespace

Verdict semi_iteration(const LinearSystem& system, SemiIteration coefficients, Monitor& monitor,
                       std::span<double> x) {
  start_from_target(system, x);
  const SemiIteration start = coefficients;
  Buffers buffers(x);
  for (;;) {
    const ErrorNorms norms = system.sweep(buffers.current(), buffers.next(),
                                          coefficients.momentum(), coefficients.step(), true);
    const Verdict verdict = monitor.record(norms);
    if (verdict == Verdict::go_on) {
      coefficients.advance();
      buffers.swap();
      continue;
    }
    buffers.finish();
    if (monitor.passed_best(verdict)) {
      // The iteration is deterministic: its best point is found again by going there.
      semi_iteration_blind(system, start, monitor.best().iteration - 1, x);
    }
    return verdict;
  }
}

bool semi_iteration_blind(const LinearSystem& system, SemiIteration coefficients, unsigned sweeps,
                          std::span<double> x) {
  start_from_target(system, x);
  Buffers buffers(x);
  for (unsigned k = 0; k < sweeps; ++k) {
    if (system.context.cancelled()) return false;
    system.sweep(buffers.current(), buffers.next(), coefficients.momentum(), coefficients.step(),
                 false);
    coefficients.advance();
    buffers.swap();
  }
  buffers.finish();
  return true;
}

}  // namespace surpass

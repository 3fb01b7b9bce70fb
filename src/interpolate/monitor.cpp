#include "interpolate/monitor.hpp"

#include <algorithm>
#include <cmath>

namespace surpass {

Verdict Monitor::record(const ErrorNorms& norms, unsigned steps) {
  const double unit = rule_.unit * system_.scale;
  const auto count = static_cast<double>(std::max<std::size_t>(1, system_.block.vertices.size()));
  const bool is_first = last_.iteration == 0;
  last_ = {last_.iteration + steps, norms.max / unit, norms.sum / count / unit};
  if (is_first) first_ = best_ = progress_ = last_;
  if (last_.max < best_.max) best_ = last_;
  if (last_.max < 0.9 * progress_.max) progress_ = last_;
  if (rule_.full_history) history_.push_back(last_);
  system_.context.report({.stage = rule_.stage,
                          .fraction = fraction(),
                          .iteration = last_.iteration,
                          .error = last_.max});

  if (system_.context.cancelled()) return Verdict::cancelled;
  if (last_.max <= rule_.tolerance) return Verdict::reached;
  if (last_.iteration >= rule_.max_iterations) return Verdict::exhausted;
  if (!std::isfinite(last_.max)) return Verdict::stalled;
  const bool hopeless = last_.iteration - progress_.iteration > kPatience;
  return rule_.stop_when_stalled && hopeless ? Verdict::stalled : Verdict::go_on;
}

void Monitor::announce(double part, unsigned steps) const {
  if (last_.iteration == 0) return;  // nothing is known yet
  const auto done = static_cast<unsigned>(part * steps);
  system_.context.report({.stage = rule_.stage,
                          .fraction = std::lerp(fraction(), 1.0, part),
                          .iteration = last_.iteration + done,
                          .error = last_.max});
}

double Monitor::fraction() const {
  if (last_.max <= rule_.tolerance) return 1;
  const double whole = std::log(first_.max / rule_.tolerance);
  const double done = std::log(first_.max / last_.max);
  return whole > 0 && std::isfinite(done) ? std::clamp(done / whole, 0.0, 1.0) : 0;
}

std::vector<Iteration> Monitor::history() const {
  if (rule_.full_history) return history_;
  if (last_.iteration == 0) return {};
  if (last_.iteration == 1) return {last_};
  return {first_, last_};
}

}  // namespace surpass

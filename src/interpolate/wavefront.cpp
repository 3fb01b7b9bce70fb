// A sweep needs of the one before only what lies a level around it. So while one sweep is at level
// l, the next can be at l - 1, and so on: all of them go through the mesh together, and what they
// touch stays in the cache. (Temporal blocking along breadth-first levels.)
#include "interpolate/wavefront.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace surpass {
namespace {

// Below that, a second thread costs more than it gains.
constexpr std::size_t kSweepsToShare = 4;
constexpr Index kRowsToShare = 65536;

}  // namespace

Wavefront::Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x)
    : rows_(rows),
      system_(system),
      stride_(sweep_stride(system.width)),
      arrays_(system.block.spare->take(rows.vertices.size() * stride_ + 1)) {
  for (std::size_t i = rows.row_count; i < rows.vertices.size(); ++i) {
    const double* known = x.data() + rows.vertices[i] * system.width;
    for (const auto& array : {&arrays_.target, &arrays_.points[0], &arrays_.points[1]}) {
      double* place = array->get() + i * stride_;
      std::fill(std::copy_n(known, system.width, place), place + stride_, 0.0);
    }
  }
}

Wavefront::~Wavefront() { system_.block.spare->give_back(std::move(arrays_)); }

// The target is the first point and is not overwritten, so the other two arrays take turns.
double* Wavefront::point(std::size_t sweeps) const {
  return sweeps == 0 ? arrays_.target.get() : arrays_.points[sweeps % 2].get();
}

void Wavefront::gather(std::size_t level) const {
  const std::size_t width = system_.width;
  const Index end = rows_.level_begin(level + 1);
  double* place = arrays_.target.get() + rows_.level_begin(level) * stride_;
  for (Index i = rows_.level_begin(level); i < end; ++i, place += stride_) {
    const double* from = system_.target.data() + rows_.vertices[i] * width;
    for (std::size_t c = 0; c < stride_; ++c) place[c] = c < width ? from[c] : 0;
  }
}

// How many fronts a group of stages is through with. The next group waits here, asleep.
struct Wavefront::Passage {
  std::atomic<std::size_t> passed{0};
  void pass(std::size_t fronts) {
    passed.store(fronts, std::memory_order_release);
    passed.notify_one();
  }
  void await(std::size_t fronts) const {
    for (std::size_t now = passed.load(std::memory_order_acquire); now < fronts;
         now = passed.load(std::memory_order_acquire)) {
      passed.wait(now, std::memory_order_acquire);
    }
  }
};

// A stage is a sweep or, before the first of them, the gathering of the target; at front f, stage s
// is at level f - s. So the sweep before has passed the next level: all that this one reads is
// there, and what it overwrites is not needed any more. Another thread has to be a front further,
// as the first number of the level after that may be read as well.
bool Wavefront::go(const Group& group, std::span<const Sweep> sweeps, Errors& errors,
                   const std::function<void(double)>& tick) const {
  const std::size_t levels = rows_.level_count();
  const std::size_t fronts = levels + gathers() + sweeps.size() - 1;
  const std::size_t between_ticks = fronts / 32 + 1;
  bool completed = true;
  for (std::size_t front = 0; front < fronts && completed; ++front) {
    if (group.before != nullptr) group.before->await(std::min(front + 2, fronts));
    completed = !system_.context.cancelled();
    if (tick && front % between_ticks == 0) {
      tick(static_cast<double>(front) / static_cast<double>(fronts));
    }
    for (std::size_t stage = group.begin; stage < std::min(front + 1, group.end); ++stage) {
      const std::size_t level = front - stage;
      if (level >= levels) continue;
      if (stage < gathers()) {
        gather(level);
        continue;
      }
      const std::size_t s = stage - gathers();
      const std::size_t k = done_ + s;
      const SweepPoints points{point(0), point(k), point(k == 0 ? 0 : k - 1), point(k + 1)};
      ErrorNorms* norms = s + 1 == sweeps.size() ? &errors.last : k == 0 ? &errors.start : nullptr;
      sweep_level(rows_, level, system_.width, points, sweeps[s], system_.scale, norms);
    }
    if (group.after != nullptr) group.after->pass(front + 1);
  }
  if (group.after != nullptr) group.after->pass(fronts);  // cancelled or not: nobody waits for ever
  return completed;
}

std::optional<Wavefront::Errors> Wavefront::advance(std::span<const Sweep> sweeps,
                                                    const std::function<void(double)>& tick) {
  const std::size_t stages = gathers() + sweeps.size();
  Errors errors;
  bool completed = false;
  if (sweeps.size() < kSweepsToShare || rows_.row_count < kRowsToShare) {
    completed = go({0, stages, nullptr, nullptr}, sweeps, errors, tick);
  } else {
    // Two threads: the earlier half of the stages, and behind it the later one.
    const std::size_t half = stages / 2;
    Passage passage;
    bool earlier = false;
    bool later = false;
    parallel::run_beside(
        system_.context,
        [&] {
          earlier = go({0, half, nullptr, &passage}, sweeps, errors, tick);
        },
        [&] {
          later = go({half, stages, &passage, nullptr}, sweeps, errors, {});
        });
    completed = earlier && later;
  }
  if (!completed) return std::nullopt;
  if (done_ == 0 && sweeps.size() == 1) errors.start = errors.last;
  done_ += sweeps.size();
  return errors;
}

void Wavefront::copy(std::size_t sweeps, std::span<double> x) const {
  const double* from = point(sweeps);
  const std::size_t width = system_.width;
  parallel::for_ranges(system_.context, rows_.row_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::copy_n(from + i * stride_, width, x.data() + rows_.vertices[i] * width);
    }
  });
}

namespace {

constexpr unsigned kMostSweeps = 64;  // at once: more of them would leave the cache

std::vector<Wavefront::Sweep> next_sweeps(SemiIteration& coefficients, unsigned count) {
  std::vector<Wavefront::Sweep> sweeps;
  for (unsigned k = 0; k < count; ++k) {
    sweeps.push_back({coefficients.momentum(), coefficients.step()});
    coefficients.advance();
  }
  return sweeps;
}

// Sweeps that bring an error down by `factor`.
unsigned likely_sweeps(double factor, double reduction) {
  const double wanted = std::ceil(std::log(factor) / -std::log(reduction));
  return static_cast<unsigned>(std::clamp(wanted, 1.0, double{kMostSweeps}));
}

// About half of the sweeps that points take which are a hundredth of the unit off: with how far the
// limit is, the second pass is told how many are left.
unsigned first_sweeps(const Monitor& monitor, double reduction) {
  constexpr double kUsualError = 1e-2;
  const double factor = std::max(1.0, kUsualError / monitor.tolerance());
  return std::min(likely_sweeps(std::sqrt(factor), reduction), monitor.iterations_left());
}

}  // namespace

Verdict wavefront_iteration(const OrderedRows& rows, const LinearSystem& system,
                            SemiIteration coefficients, Monitor& monitor, std::span<double> x) {
  const SemiIteration start = coefficients;
  Wavefront front(rows, system, x);
  unsigned count = first_sweeps(monitor, coefficients.reduction());
  const auto advance = [&] {
    return front.advance(next_sweeps(coefficients, count),
                         [&](double part) { monitor.announce(part, count); });
  };
  auto errors = advance();
  if (!errors) return Verdict::cancelled;
  Verdict verdict = monitor.record(errors->start);
  if (verdict != Verdict::go_on) {
    front.copy_target(x);
    return verdict;
  }
  if (count > 1) verdict = monitor.record(errors->last, count - 1);
  while (verdict == Verdict::go_on) {
    count = std::min(likely_sweeps(monitor.excess(), coefficients.reduction()),
                     monitor.iterations_left());
    errors = advance();
    verdict = errors ? monitor.record(errors->last, count) : Verdict::cancelled;
  }
  if (verdict == Verdict::cancelled) return verdict;
  front.copy_measured(x);
  if (monitor.passed_best(verdict)) {
    // The iteration is deterministic: its best point is found again by going there.
    wavefront_iteration_blind(rows, system, start, monitor.best().iteration - 1, x);
  }
  return verdict;
}

bool wavefront_iteration_blind(const OrderedRows& rows, const LinearSystem& system,
                               SemiIteration coefficients, unsigned sweeps, std::span<double> x) {
  if (sweeps == 0) {
    system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
    return true;
  }
  Wavefront front(rows, system, x);
  for (unsigned done = 0; done < sweeps; done += kMostSweeps) {
    const unsigned count = std::min(kMostSweeps, sweeps - done);
    if (!front.advance(next_sweeps(coefficients, count))) return false;
  }
  front.copy_newest(x);
  return true;
}

}  // namespace surpass

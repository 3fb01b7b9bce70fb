// A sweep needs of the one before only what lies a level around it. So while one sweep is at level
// l, the next can be at l - 1, and so on: all of them go through the mesh together, and what they
// touch stays in the cache. (Temporal blocking along breadth-first levels.)
#include "interpolate/wavefront.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace surpass {
namespace {

// Below that, a second thread costs more than it gains.
constexpr std::size_t kSweepsToShare = 4;
constexpr Index kRowsToShare = 65536;

// Points have three numbers, nearly always: said to the compiler, that is three moves.
void move_point(const double* from, std::size_t width, double* to) {
  if (width == 3) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = from[c];
  } else {
    std::copy_n(from, width, to);
  }
}

}  // namespace

Wavefront::Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x)
    : rows_(rows),
      system_(system),
      stride_(sweep_stride(system.width)),
      scale_(correction_scale(system)),
      arrays_(system.block.spare->take(rows.vertices.size() * stride_ + 1)) {
  for (std::size_t i = rows.row_count; i < rows.vertices.size(); ++i) {
    const double* known = x.data() + rows.vertices[i] * system.width;
    for (double* array : {arrays_.target.get(), arrays_.point.get()}) {
      double* place = array + i * stride_;
      std::fill(std::copy_n(known, system.width, place), place + stride_, 0.0);
    }
    for (const auto& array : arrays_.corrections) {
      std::fill_n(array.get() + i * stride_, stride_, 0.0F);
    }
  }
}

Wavefront::~Wavefront() { system_.block.spare->give_back(std::move(arrays_)); }

// Calls use(i, v * width) for the level's places and their vertices v. Where these lie in `array`
// looks random, so memory is asked for ahead.
template <class Use>
void Wavefront::for_vertices(std::size_t level, const double* array, Use&& use) const {
  constexpr Index kAhead = 24;
  const std::size_t width = system_.width;
  const Index end = rows_.level_begin(level + 1);
  const Index* vertices = rows_.vertices.data();
  for (Index i = rows_.level_begin(level); i < end; ++i) {
    if (i + kAhead < rows_.row_count) {
      const double* ahead = array + vertices[i + kAhead] * width;
      __builtin_prefetch(ahead);
      __builtin_prefetch(ahead + width - 1);
    }
    use(i, vertices[i] * width);
  }
}

void Wavefront::gather(std::size_t level) const {
  const double* from = system_.target.data();
  for_vertices(level, from, [&](Index i, std::size_t at) {
    double* place = arrays_.target.get() + i * stride_;
    move_point(from + at, system_.width, place);
    std::fill(place + system_.width, place + stride_, 0.0);
  });
}

void Wavefront::hand_out(std::size_t level, double* out) const {
  for_vertices(level, out, [&](Index i, std::size_t at) {
    move_point(arrays_.point.get() + i * stride_, system_.width, out + at);
  });
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

// What happens between two residuals, in stages that follow each other at a distance of a level:
// the target is gathered and its residual measured, if this is the start, then come the sweeps, the
// last of which moves the point, and the residual of that.
struct Wavefront::Round {
  std::span<const SweepStep> steps;
  bool is_start;
  std::span<double> out;
  SweepErrors errors = {};

  [[nodiscard]] std::size_t before() const { return is_start ? 2 : 0; }
  [[nodiscard]] std::size_t evaluations() const { return steps.size() - (is_start ? 1 : 0); }
  /// With the residual of the new point one evaluation more.
  [[nodiscard]] std::size_t sweeps() const { return evaluations() == 0 ? 0 : evaluations() - 1; }
  /// The first sweep is part of measuring; if it is the only one, moving the point is a stage.
  [[nodiscard]] std::size_t moves() const { return evaluations() == 1 ? 1 : 0; }
  [[nodiscard]] std::size_t stages() const {
    return before() + sweeps() + moves() + (evaluations() == 0 ? 0 : 1);
  }
  /// About how many sweeps a stage takes as long as: twice as long where places in memory look
  /// random, and with twice the digits.
  [[nodiscard]] unsigned cost(std::size_t stage) const {
    if (stage < before()) return 2;
    if (stage + 1 < stages()) return 1;
    return out.empty() ? 2 : 4;
  }
  /// The stages before this one take about half of the time.
  [[nodiscard]] std::size_t middle() const {
    unsigned all = 0;
    for (std::size_t stage = 0; stage < stages(); ++stage) all += cost(stage);
    std::size_t stage = 0;
    for (unsigned done = 0; 2 * done + cost(stage) <= all; ++stage) done += cost(stage);
    return std::max<std::size_t>(stage, 1);
  }
};

void Wavefront::measure(std::size_t level, Round& round, bool is_start) const {
  const ResidualSweep sweep{
      .step = is_start ? round.steps.front() : round.steps.back(),
      .target = arrays_.target.get(),
      .point = is_start ? arrays_.target.get() : arrays_.point.get(),
      .norm_scale = system_.scale,
      .scale = scale_,
      .residual = arrays_.residual.get(),
      .correction = is_start ? correction(0) : correction(round.sweeps()),
      .fresh = is_start,
  };
  measure_level(rows_, level, system_.width, sweep,
                is_start ? round.errors.start : round.errors.last);
}

void Wavefront::sweep(std::size_t level, const Round& round, std::size_t at) const {
  const bool is_last = at + 1 == round.sweeps();
  const CorrectionSweep sweep{
      .step = round.steps[at + (round.is_start ? 1 : 0)],
      .residual = arrays_.residual.get(),
      .current = correction(at),
      .next = correction(at + 1),
      .fresh = at == 0,
      .from = point(),
      .to = is_last ? arrays_.point.get() : nullptr,
      .unit = 1 / scale_,
  };
  sweep_level(rows_, level, system_.width, sweep);
}

void Wavefront::move(std::size_t level) const {
  const double unit = 1 / scale_;
  const std::size_t end = rows_.level_begin(level + 1) * stride_;
  for (std::size_t at = rows_.level_begin(level) * stride_; at < end; ++at) {
    arrays_.point[at] = point()[at] + static_cast<double>(correction(0)[at]) * unit;
  }
}

void Wavefront::run_stage(std::size_t stage, std::size_t level, Round& round) const {
  if (round.is_start && stage == 0) return gather(level);
  if (round.is_start && stage == 1) return measure(level, round, true);
  const std::size_t at = stage - round.before();
  if (at < round.sweeps()) return sweep(level, round, at);
  if (stage + 1 < round.stages()) return move(level);
  measure(level, round, false);
  if (!round.out.empty()) hand_out(level, round.out.data());
}

// At front f, stage s is at level f - s. So the stage before has passed the next level: all that
// this one reads is there, and what it overwrites is not needed any more. Another thread has to be
// a front further, as the first number of the level after that may be read as well.
bool Wavefront::go(const Group& group, Round& round, const Tick& tick) const {
  const std::size_t levels = rows_.level_count();
  const std::size_t fronts = levels + round.stages() - 1;
  const std::size_t between_ticks = fronts / 32 + 1;
  bool completed = true;
  for (std::size_t front = 0; front < fronts && completed; ++front) {
    if (group.before != nullptr) group.before->await(std::min(front + 2, fronts));
    completed = !system_.context.cancelled();
    if (tick && front % between_ticks == 0) {
      tick(static_cast<double>(front) / static_cast<double>(fronts));
    }
    for (std::size_t stage = group.begin; stage < std::min(front + 1, group.end); ++stage) {
      if (front - stage < levels) run_stage(stage, front - stage, round);
    }
    if (group.after != nullptr) group.after->pass(front + 1);
  }
  if (group.after != nullptr) group.after->pass(fronts);  // cancelled or not: nobody waits for ever
  return completed;
}

std::optional<SweepErrors> Wavefront::advance(std::span<const SweepStep> sweeps, const Tick& tick,
                                              std::span<double> out) {
  Round round{sweeps, done_ == 0, out};
  const std::size_t stages = round.stages();
  bool completed = false;
  if (sweeps.size() < kSweepsToShare || rows_.row_count < kRowsToShare) {
    completed = go({0, stages, nullptr, nullptr}, round, tick);
  } else {
    // Two threads: the earlier half of the work, and behind it the later one.
    const std::size_t half = round.middle();
    Passage passage;
    bool earlier = false;
    bool later = false;
    parallel::run_beside(
        system_.context,
        [&] {
          earlier = go({0, half, nullptr, &passage}, round, tick);
        },
        [&] {
          later = go({half, stages, &passage, nullptr}, round, {});
        });
    completed = earlier && later;
  }
  if (!completed) return std::nullopt;
  if (round.evaluations() == 0) round.errors.last = round.errors.start;
  newest_ = (newest_ + round.sweeps()) % 2;
  done_ += sweeps.size();
  return round.errors;
}

void Wavefront::copy_measured(std::span<double> x) const {
  const double* from = point();
  const std::size_t width = system_.width;
  parallel::for_ranges(system_.context, rows_.row_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::copy_n(from + i * stride_, width, x.data() + rows_.vertices[i] * width);
    }
  });
}

}  // namespace surpass

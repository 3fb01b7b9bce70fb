// A sweep needs of the one before only what lies a level around it. So while one sweep is at level
// l, the next can be at l - 1, and so on: all of them go through the mesh together, and what they
// touch stays in the cache. (Temporal blocking along breadth-first levels.)
#include "interpolate/wavefront.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace surpass {
// The same operations on wider registers have the same bits, so each machine may use its own. (The
// choice is made before a sanitizer is ready for it.)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SURPASS_FOR_EACH_MACHINE [[gnu::target_clones("avx2", "default")]]
#else
#define SURPASS_FOR_EACH_MACHINE
#endif

namespace {

using Four = Wavefront::Four;

struct Arrays {
  const Wavefront::Values* target;
  const Wavefront::Values* current;
  Wavefront::Values* previous;  // becomes the next
};

void include(ErrorNorms& norms, const Four& r, double scale) {
  double squared = 0;
  for (std::size_t c = 0; c < Wavefront::kWidth; ++c) squared += (r[c] * scale) * (r[c] * scale);
  const double distance = std::sqrt(squared);
  if (distance > norms.max || std::isnan(distance)) norms.max = distance;
  norms.sum += distance;
}

// Below that, a second thread costs more than it gains.
constexpr std::size_t kSweepsToShare = 4;
constexpr Index kRowsToShare = 65536;

// One run. With a constant kLength the loop over a row's entries has no branch.
template <Index kLength, bool kMeasured>
[[gnu::always_inline]] inline void sweep_run(const OrderedRows& rows, const OrderedRows::Run& run,
                                             const Arrays& a, const Wavefront::Sweep& sweep,
                                             double scale, ErrorNorms& norms) {
  const Index length = kLength != 0 ? kLength : run.length;
  const Index* columns = rows.columns.data() + run.columns;
  const double* weights = rows.weights.data() + run.weights;
  double kept[kLength != 0 ? kLength : 1];  // in registers
  for (Index k = 0; k < kLength; ++k) kept[k] = weights[k];
  const auto* current = reinterpret_cast<const double*>(a.current);
  const auto at = [&](Index column) -> const Four& {
    return *reinterpret_cast<const Four*>(current + column);
  };
  const double momentum = sweep.momentum;
  const double step = sweep.step;
  for (Index i = run.begin; i < run.end; ++i, columns += length) {
    Four product{};
    for (Index k = 0; k < length; ++k) {
      product += (kLength != 0 ? kept[k] : weights[k]) * at(columns[k]);
    }
    const Four x = a.current[i].four;
    const Four r = a.target[i].four - product;
    a.previous[i].four = x + momentum * (x - a.previous[i].four) + step * r;
    if (kMeasured) include(norms, r, scale);
  }
}

template <bool kMeasured>
[[gnu::always_inline]] inline void sweep_any_level(const OrderedRows& rows, std::size_t level,
                                                   const Arrays& a, const Wavefront::Sweep& sweep,
                                                   double scale, ErrorNorms& norms) {
  for (Index i = rows.levels[level]; i < rows.levels[level + 1]; ++i) {
    const OrderedRows::Run& run = rows.runs[i];
    switch (run.length) {
      case 4: sweep_run<4, kMeasured>(rows, run, a, sweep, scale, norms); break;
      case 5: sweep_run<5, kMeasured>(rows, run, a, sweep, scale, norms); break;
      case 6: sweep_run<6, kMeasured>(rows, run, a, sweep, scale, norms); break;
      case 7: sweep_run<7, kMeasured>(rows, run, a, sweep, scale, norms); break;
      case 8: sweep_run<8, kMeasured>(rows, run, a, sweep, scale, norms); break;
      case 9: sweep_run<9, kMeasured>(rows, run, a, sweep, scale, norms); break;
      default: sweep_run<0, kMeasured>(rows, run, a, sweep, scale, norms); break;
    }
  }
}

SURPASS_FOR_EACH_MACHINE
void sweep_level(const OrderedRows& rows, std::size_t level, const Arrays& a,
                 const Wavefront::Sweep& sweep) {
  ErrorNorms none;
  sweep_any_level<false>(rows, level, a, sweep, 1, none);
}

SURPASS_FOR_EACH_MACHINE
void sweep_and_measure_level(const OrderedRows& rows, std::size_t level, const Arrays& a,
                             const Wavefront::Sweep& sweep, double scale, ErrorNorms& norms) {
  sweep_any_level<true>(rows, level, a, sweep, scale, norms);
}

}  // namespace

// Nothing is cleared first: fresh memory costs more to touch than to fill.
Wavefront::Wavefront(const OrderedRows& rows, const LinearSystem& system, std::span<const double> x)
    : rows_(rows),
      system_(system),
      target_(std::make_unique_for_overwrite<Values[]>(rows.row_count)) {
  const std::size_t places = rows.vertices.size();
  for (auto& points : points_) points = std::make_unique_for_overwrite<Values[]>(places);
  parallel::for_ranges(system.context, places, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool known = i >= rows.row_count;
      const double* from = known ? x.data() : system.target.data();
      Four value{};
      const std::size_t at = rows.vertices[i] * system.width;
      for (std::size_t c = 0; c < system.width; ++c) value[c] = from[at + c];
      if (!known) target_[i].four = value;
      points_[0][i].four = points_[1][i].four = value;
    }
  });
}

// How far a group of sweeps is: the levels that its last sweep has passed. The next group waits
// here, asleep.
struct Wavefront::Passage {
  std::atomic<std::size_t> passed{0};
  void pass(std::size_t levels) {
    passed.store(levels, std::memory_order_release);
    passed.notify_one();
  }
  void await(std::size_t levels) const {
    for (std::size_t now = passed.load(std::memory_order_acquire); now < levels;
         now = passed.load(std::memory_order_acquire)) {
      passed.wait(now, std::memory_order_acquire);
    }
  }
};

// A sweep may be at a level when the one before has passed the next level: then all that it reads
// is there, and what it overwrites is not needed any more.
bool Wavefront::sweep_together(std::span<const Sweep> sweeps, std::size_t parity, Passage* before,
                               Passage* after, ErrorNorms* norms,
                               const std::function<void(double)>& tick) const {
  const std::size_t levels = rows_.level_count();
  const std::size_t last = sweeps.size() - 1;
  const std::size_t fronts = levels + last;
  const std::size_t between_ticks = fronts / 32 + 1;
  bool completed = true;
  for (std::size_t front = 0; front < fronts && completed; ++front) {
    if (before != nullptr) before->await(std::min(front + 2, levels));
    completed = !system_.context.cancelled();
    if (tick && front % between_ticks == 0) {
      tick(static_cast<double>(front) / static_cast<double>(fronts));
    }
    for (std::size_t s = 0; s <= std::min(front, last); ++s) {
      if (front - s >= levels) continue;
      const std::size_t from = (parity + s) % 2;
      const Arrays arrays{target_.get(), points_[from].get(), points_[1 - from].get()};
      if (norms != nullptr && s == last) {
        sweep_and_measure_level(rows_, front - s, arrays, sweeps[s], system_.scale, *norms);
      } else {
        sweep_level(rows_, front - s, arrays, sweeps[s]);
      }
    }
    if (after != nullptr && front >= last) after->pass(front - last + 1);
  }
  if (after != nullptr) after->pass(levels);  // cancelled or not, so that nobody waits for ever
  return completed;
}

std::optional<ErrorNorms> Wavefront::advance(std::span<const Sweep> sweeps,
                                             const std::function<void(double)>& tick) {
  const std::size_t first = 1 - measured_;
  ErrorNorms norms;
  bool completed = false;
  if (sweeps.size() < kSweepsToShare || rows_.row_count < kRowsToShare) {
    completed = sweep_together(sweeps, first, nullptr, nullptr, &norms, tick);
  } else {
    // Two threads: the earlier half of the sweeps, and behind it the later one.
    const std::size_t half = sweeps.size() / 2;
    Passage passage;
    bool earlier = false;
    bool later = false;
    parallel::run_beside(
        system_.context,
        [&] {
          earlier = sweep_together(sweeps.first(half), first, nullptr, &passage, nullptr, tick);
        },
        [&] {
          later = sweep_together(sweeps.subspan(half), first + half, &passage, nullptr, &norms, {});
        });
    completed = earlier && later;
  }
  if (!completed) return std::nullopt;
  measured_ = (first + sweeps.size() - 1) % 2;
  return norms;
}

void Wavefront::copy(std::size_t from, std::span<double> x) const {
  parallel::for_ranges(system_.context, rows_.row_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = rows_.vertices[i] * system_.width;
      for (std::size_t c = 0; c < system_.width; ++c) x[at + c] = points_[from][i].four[c];
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

}  // namespace

Verdict wavefront_iteration(const OrderedRows& rows, const LinearSystem& system,
                            SemiIteration coefficients, Monitor& monitor, std::span<double> x) {
  const SemiIteration start = coefficients;
  Wavefront front(rows, system, x);
  Verdict verdict{};
  // The first sweep tells how far there is to go. Chebyshev's polynomials reach their rate after a
  // loss of up to 2.
  unsigned count = 1;
  for (double loss = 2;; loss = 1) {
    const auto norms = front.advance(next_sweeps(coefficients, count),
                                     [&](double part) { monitor.announce(part, count); });
    verdict = norms ? monitor.record(*norms, count) : Verdict::cancelled;
    if (verdict != Verdict::go_on) break;
    count = std::min(likely_sweeps(loss * monitor.excess(), coefficients.reduction()),
                     monitor.iterations_left());
  }
  front.copy_measured(x);
  if (monitor.passed_best(verdict)) {
    // The iteration is deterministic: its best point is found again by going there.
    wavefront_iteration_blind(rows, system, start, monitor.best().iteration - 1, x);
  }
  return verdict;
}

bool wavefront_iteration_blind(const OrderedRows& rows, const LinearSystem& system,
                               SemiIteration coefficients, unsigned sweeps, std::span<double> x) {
  Wavefront front(rows, system, x);
  for (unsigned done = 0; done < sweeps; done += kMostSweeps) {
    const unsigned count = std::min(kMostSweeps, sweeps - done);
    if (!front.advance(next_sweeps(coefficients, count))) return false;
  }
  front.copy_newest(x);
  return true;
}

}  // namespace surpass

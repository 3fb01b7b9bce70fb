// What a contender in a comparison is, and how it is run: prepared outside the clock, timed,
// judged outside the clock. Google Benchmark repeats and records.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "workload.hpp"

namespace surpass::bench {

/// Who does what, in the words of the table.
struct Entry {
  std::string step;     ///< contenders with the same step and size are compared
  std::string tool;     ///< "Surpass" is what the others are compared with
  std::string counted;  ///< what lies between start and stop of the clock, and what does not
  bool slow = false;    ///< takes seconds at the larger sizes, where it is run once
};

/// The outcome of a run, in figures that went with its result.
struct Verdict {
  double difference = 0;             ///< from the result that all contenders must reach
  double allowed = 0;                ///< more than that fails the whole run
  std::optional<double> error = {};  ///< of an interpolation: largest distance to a given point;
                                     ///< more than kTolerance fails the run as well
  std::optional<double> sweeps = {};
  std::optional<double> peak = {};  ///< bytes a vertex that a process of its own held at most

  [[nodiscard]] bool agrees() const {
    return difference <= allowed && (!error || *error <= kTolerance);
  }
};

/// Times that a contender runs: at least five, but slow ones once where the mesh is large.
[[nodiscard]] int repetitions(const Entry& entry, Index side);

/// Writes the figures of one run beside its time.
void record(benchmark::State& state, const Verdict& verdict, double processor_ms);

/// What all threads of the process and its children have used. Beside the wall clock it shows how
/// busy the machine was with other work.
[[nodiscard]] double processor_seconds();

class Harness {
 public:
  explicit Harness(Workloads& workloads) : workloads_(workloads) {}

  /// Enters a contender at one size. `prepare(workload)` gives the callable that is timed; what
  /// that returns is kept until the clock has stopped, and judged by `judge(workload, result)`.
  /// Unless it runs only once, a first run that is judged but not timed warms it up.
  template <class Prepare, class Judge>
  void add(const Entry& entry, Index side, Prepare prepare, Judge judge);

  /// Hands all contenders to Google Benchmark, those who are compared next to each other so that
  /// they meet the machine in the same state.
  void schedule();

  /// Contenders whose result was not what it must be.
  [[nodiscard]] int failures() const { return failures_; }

 private:
  void settle(const std::string& name, const Verdict& verdict);

  struct Contender {
    Index side;
    std::string step;
    std::string name;
    int repetitions;
    std::function<void(benchmark::State&)> measure;
  };

  Workloads& workloads_;
  std::vector<Contender> contenders_;
  int failures_ = 0;
};

template <class Prepare, class Judge>
void Harness::add(const Entry& entry, Index side, Prepare prepare, Judge judge) {
  using Run = decltype(prepare(std::declval<const Workload&>()));
  struct Session {
    std::optional<Run> run;
    std::optional<Verdict> verdict;
    int left;
  };
  const int times = repetitions(entry, side);
  auto session = std::make_shared<Session>(Session{{}, {}, times});
  const auto vertices = std::to_string(std::size_t{side} * side);
  const std::string name = entry.step + '/' + vertices + '/' + entry.tool;
  const auto measure = [=, this](benchmark::State& state) {
    const Workload& workload = workloads_[side];
    if (!session->run) {
      session->run.emplace(prepare(workload));
      if (times > 1) session->verdict = judge(workload, (*session->run)());
    }
    double processor_ms = 0;
    for (auto _ : state) {
      const double worked = processor_seconds();
      const auto start = std::chrono::steady_clock::now();
      const auto result = (*session->run)();
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      processor_ms = 1e3 * (processor_seconds() - worked);
      state.SetIterationTime(spent.count());
      if (!session->verdict) session->verdict = judge(workload, result);
    }
    state.SetLabel(entry.counted);
    record(state, *session->verdict, processor_ms);
    if (--session->left > 0) return;
    session->run.reset();
    settle(name, *session->verdict);
  };
  contenders_.push_back({side, entry.step, name, times, measure});
}

}  // namespace surpass::bench

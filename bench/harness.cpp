#include "harness.hpp"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>
#include <sys/resource.h>

namespace surpass::bench {

int repetitions(const Entry& entry, Index side) {
  constexpr Index kSmall =
      128;  // milliseconds even for the slow ones, so that more runs cost little
  if (side <= kSmall) return entry.slow ? 5 : 15;
  return entry.slow ? 1 : 5;
}

double processor_seconds() {
  timespec own = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
  rusage children = {};
  ::getrusage(RUSAGE_CHILDREN, &children);
  double seconds = static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec);
  for (const timeval& time : {children.ru_utime, children.ru_stime}) {
    seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

void Harness::schedule() {
  std::vector<std::string> steps;  // in the order of their first contender
  for (const Contender& c : contenders_) {
    if (std::find(steps.begin(), steps.end(), c.step) == steps.end()) steps.push_back(c.step);
  }
  const auto place = [&](const Contender& c) {
    return std::pair(c.side, std::find(steps.begin(), steps.end(), c.step));
  };
  std::stable_sort(contenders_.begin(), contenders_.end(),
                   [&](const Contender& a, const Contender& b) { return place(a) < place(b); });
  for (const Contender& c : contenders_) {
    benchmark::RegisterBenchmark(c.name.c_str(), c.measure)
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(c.repetitions)
        ->Unit(benchmark::kMillisecond);
  }
}

void record(benchmark::State& state, const Verdict& verdict, double processor_ms) {
  state.counters["processor_ms"] = processor_ms;
  state.counters["difference"] = verdict.difference;
  state.counters["allowed"] = verdict.allowed;
  state.counters["wrong"] = verdict.agrees() ? 0 : 1;
  if (verdict.error) state.counters["error"] = *verdict.error;
  if (verdict.sweeps) state.counters["sweeps"] = *verdict.sweeps;
  if (verdict.peak) state.counters["peak"] = *verdict.peak;
}

void Harness::settle(const std::string& name, const Verdict& verdict) {
  if (verdict.agrees()) return;
  ++failures_;
  fmt::print(stderr, "{}: the result differs by {:.1e}, allowed is {:.1e}; its error is {:.1e}\n",
             name, verdict.difference, verdict.allowed, verdict.error.value_or(0));
}

}  // namespace surpass::bench

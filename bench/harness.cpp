#include "harness.hpp"

#include <ctime>

namespace surpass::bench {

int repetitions(const Entry& entry, Index side) {
  if (side <= 128) return entry.slow ? 5 : 15;
  if (side <= 500) return entry.slow ? 1 : 9;
  return entry.slow ? 1 : 5;
}

double processor_seconds() {
  timespec time = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void Harness::record(benchmark::State& state, const Verdict& verdict, double processor_ms) {
  state.counters["processor_ms"] = processor_ms;
  state.counters["difference"] = verdict.difference;
  state.counters["allowed"] = verdict.allowed;
  if (verdict.error) state.counters["error"] = *verdict.error;
  if (verdict.sweeps) state.counters["sweeps"] = *verdict.sweeps;
  const bool accurate = !verdict.error || *verdict.error <= kTolerance;
  if (!accurate || !(verdict.difference <= verdict.allowed)) {
    ++failures_;
    state.SkipWithError("its result is not the one that all must reach");
  }
}

}  // namespace surpass::bench

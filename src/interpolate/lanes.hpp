// Eight numbers abreast, and registers of the width that the processor has to work on them. The
// same operations on wider registers have the same bits.
#pragma once

#include <cstddef>

namespace surpass {

inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kLaneAlignment = 64;

/// A number in each lane.
struct LaneNumbers {
  alignas(kLaneAlignment) double value[kLanes];
};

/// A vector in each lane.
struct LaneVectors {
  alignas(kLaneAlignment) double of[3][kLanes];  // by coordinate

  void set(std::size_t lane, const double* p) {
    for (std::size_t c = 0; c < 3; ++c) of[c][lane] = p[c];
  }
  void add_to(std::size_t lane, double* p) const {
    for (std::size_t c = 0; c < 3; ++c) p[c] += of[c][lane];
  }
};

/// Registers of two, four and eight numbers; Bits holds the outcomes of comparisons. Templates that
/// deduce such a type lose its alignment: their arrays have to say it.
struct TwoLanes {
  static constexpr std::size_t kCount = 2;
  using Numbers [[gnu::vector_size(16), gnu::aligned(16), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(16)]] = long long;
};
struct FourLanes {
  static constexpr std::size_t kCount = 4;
  using Numbers [[gnu::vector_size(32), gnu::aligned(32), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(32)]] = long long;
};
struct EightLanes {
  static constexpr std::size_t kCount = 8;
  using Numbers [[gnu::vector_size(64), gnu::aligned(64), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(64)]] = long long;
};

#if defined(__x86_64__)
template <class Task>
[[gnu::target("avx512f")]] void run_on_eight(const Task& task) {
  task(EightLanes());
}
template <class Task>
[[gnu::target("avx2")]] void run_on_four(const Task& task) {
  task(FourLanes());
}
#endif

/// task(EightLanes()), task(FourLanes()) or task(TwoLanes()), whichever fits the registers of this
/// processor. The task and what it calls must be always_inline, so that they are compiled for them.
template <class Task>
void run_on_lanes(const Task& task) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return run_on_eight(task);
  if (__builtin_cpu_supports("avx2")) return run_on_four(task);
#endif
  task(TwoLanes());
}

}  // namespace surpass

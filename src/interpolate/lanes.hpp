// Numbers abreast, 64 bytes of them, and registers of the width that the processor has to work on
// them. The same operations on wider registers have the same bits.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace surpass {

inline constexpr std::size_t kLaneAlignment = 64;

/// Eight in double precision, sixteen in single.
template <class Real>
inline constexpr std::size_t kLanes = kLaneAlignment / sizeof(Real);

/// A number in each lane.
struct LaneNumbers {
  alignas(kLaneAlignment) double value[kLanes<double>];
};

/// A vector in each lane.
template <class Real>
struct LaneVectors {
  alignas(kLaneAlignment) Real of[3][kLanes<Real>];  // by coordinate

  void clear(std::size_t lane) {
    for (auto& numbers : of) numbers[lane] = 0;
  }
  void add_to(std::size_t lane, Real* p) const {
    for (std::size_t c = 0; c < 3; ++c) p[c] += of[c][lane];
  }
};

/// Registers of two, four and eight numbers, and of twice as many in single precision; Bits holds
/// the outcomes of comparisons. Templates that deduce such a type lose its alignment: their arrays
/// have to say it.
struct TwoLanes {
  using Real = double;
  using Numbers [[gnu::vector_size(16), gnu::aligned(16), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(16)]] = long long;
};
struct FourLanes {
  using Real = double;
  using Numbers [[gnu::vector_size(32), gnu::aligned(32), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(32)]] = long long;
};
struct EightLanes {
  using Real = double;
  using Numbers [[gnu::vector_size(64), gnu::aligned(64), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(64)]] = long long;
};
struct FourSingleLanes {
  using Real = float;
  using Numbers [[gnu::vector_size(16), gnu::aligned(16), gnu::may_alias]] = float;
  using Bits [[gnu::vector_size(16)]] = int;
};
struct EightSingleLanes {
  using Real = float;
  using Numbers [[gnu::vector_size(32), gnu::aligned(32), gnu::may_alias]] = float;
  using Bits [[gnu::vector_size(32)]] = int;
};
struct SixteenSingleLanes {
  using Real = float;
  using Numbers [[gnu::vector_size(64), gnu::aligned(64), gnu::may_alias]] = float;
  using Bits [[gnu::vector_size(64)]] = int;
};

/// How many numbers a register has.
template <class Lanes>
inline constexpr std::size_t kCount = sizeof(typename Lanes::Numbers) /
                                      sizeof(typename Lanes::Real);

template <class Real>
inline constexpr bool kIsSingle = std::is_same_v<Real, float>;

/// What a register, or a number, is made of.
template <class T>
struct NumberOf {
  using Type = std::remove_cvref_t<decltype(std::declval<T>()[0])>;
};
template <>
struct NumberOf<double> {
  using Type = double;
};

#if defined(__x86_64__)
template <class Real, class Task>
[[gnu::target("avx512f")]] void run_on_512_bits(const Task& task) {
  task(std::conditional_t<kIsSingle<Real>, SixteenSingleLanes, EightLanes>());
}
template <class Real, class Task>
[[gnu::target("avx2")]] void run_on_256_bits(const Task& task) {
  task(std::conditional_t<kIsSingle<Real>, EightSingleLanes, FourLanes>());
}
#endif

/// Calls the task with the widest of these kinds of registers that this processor has, for numbers
/// of this precision. The task and what it calls must be always_inline, so that they are compiled
/// for them.
template <class Real, class Task>
void run_on_lanes(const Task& task) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return run_on_512_bits<Real>(task);
  if (__builtin_cpu_supports("avx2")) return run_on_256_bits<Real>(task);
#endif
  task(std::conditional_t<kIsSingle<Real>, FourSingleLanes, TwoLanes>());
}

}  // namespace surpass

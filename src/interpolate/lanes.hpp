// Eight numbers abreast. Spelt out because compilers leave short loops alone. A register of the
// newest processors holds all eight; for others the compiler cuts them up.
#pragma once

#include <cstddef>

namespace surpass {

inline constexpr std::size_t kLanes = 8;
/// Templates lose what is said of the alignment here: arrays of a deduced type need to say it, and
/// containers take one of the structs.
inline constexpr std::size_t kLaneAlignment = 64;
using Lanes [[gnu::vector_size(64), gnu::aligned(kLaneAlignment)]] = double;

/// A number in each lane.
struct LaneNumbers {
  Lanes value;
};

/// A vector in each lane.
struct LaneVectors {
  Lanes of[3];  // by coordinate

  void set(std::size_t lane, const double* p) {
    for (std::size_t c = 0; c < 3; ++c) of[c][lane] = p[c];
  }
  void add_to(std::size_t lane, double* p) const {
    for (std::size_t c = 0; c < 3; ++c) p[c] += of[c][lane];
  }
};

static_assert(alignof(LaneNumbers) == kLaneAlignment && alignof(LaneVectors) == kLaneAlignment);

}  // namespace surpass

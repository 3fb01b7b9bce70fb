// Four numbers abreast, in registers of two as every 64-bit processor has them. Spelt out because
// compilers leave short loops over four numbers alone.
#pragma once

#include <cstddef>

namespace surpass {

struct Lanes {
  using Pair = double __attribute__((vector_size(16)));
  static constexpr std::size_t kCount = 4;

  Pair low = {};
  Pair high = {};

  static Lanes all(double x) {
    const Pair pair = {x, x};
    return {pair, pair};
  }
  [[nodiscard]] double operator[](std::size_t lane) const {
    return lane < 2 ? low[lane] : high[lane - 2];
  }
  void set(std::size_t lane, double x) {
    if (lane < 2) {
      low[lane] = x;
    } else {
      high[lane - 2] = x;
    }
  }
  Lanes& operator+=(const Lanes& other) {
    low += other.low;
    high += other.high;
    return *this;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return {a.low - b.low, a.high - b.high};
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return {a.low * b.low, a.high * b.high};
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return {a.low / b.low, a.high / b.high};
  }
};

/// A vector in each lane.
struct LaneVectors {
  Lanes x;
  Lanes y;
  Lanes z;
  void set(std::size_t lane, const double* p) {
    x.set(lane, p[0]);
    y.set(lane, p[1]);
    z.set(lane, p[2]);
  }
  void add_to(std::size_t lane, double* p) const {
    p[0] += x[lane];
    p[1] += y[lane];
    p[2] += z[lane];
  }
  /// += factor * other.
  void add(const Lanes& factor, const LaneVectors& other) {
    x += factor * other.x;
    y += factor * other.y;
    z += factor * other.z;
  }
};

[[nodiscard]] inline Lanes dot(const LaneVectors& a, const LaneVectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace surpass

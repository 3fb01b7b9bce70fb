// Lists of vectors that are compared as sets.
#pragma once

#include <surpass/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace surpass::test {

using Values = std::vector<Point>;

/// a p + b q.
inline Point weighted_sum(double a, const Point& p, double b, const Point& q) {
  return {a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2]};
}

inline double size_of(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

/// The largest distance from one of the values to the nearest of the others, but for the sign.
inline double unlike(const Values& values, const Values& others) {
  double worst = 0;
  for (const Point& value : values) {
    double best = HUGE_VAL;
    for (const Point& other : others) {
      best = std::min({best, size_of(weighted_sum(1, value, -1, other)),
                       size_of(weighted_sum(1, value, 1, other))});
    }
    worst = std::max(worst, best);
  }
  return worst;
}

}  // namespace surpass::test

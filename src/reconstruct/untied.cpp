#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "reconstruct/advancing_front.hpp"
#include "reconstruct/local_fit.hpp"

namespace surpass::reconstruction {
namespace {

bool are_in_a_plane(std::span<const Point> points, double thickness) {
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  const LocalPlane plane = fit_plane(points, all);
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return std::abs(plane.local(p)[2]) <= thickness; });
}

// Even in [-1, 1): the mixing of Steele, Lea and Flood's SplitMix64.
double variate(std::uint64_t number) {
  std::uint64_t x = (number + 1) * 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  x ^= x >> 31U;
  return static_cast<double>(x >> 11U) * 0x1p-52 - 1;
}

}  // namespace

std::vector<Point> untied(std::span<const Point> points, double amount) {
  std::vector<Point> moved(points.begin(), points.end());
  if (are_in_a_plane(points, amount)) return moved;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) moved[i][k] += amount * variate(3 * i + k);
  }
  return moved;
}

}  // namespace surpass::reconstruction

#include "interpolate/lane_points.hpp"

#include <algorithm>

#include "interpolate/each_machine.hpp"

namespace surpass {
namespace {

// At any address that a double may have, and allowed to look at doubles.
using Point4 [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline Point4& point_at(double* place) {
  return *reinterpret_cast<Point4*>(place);
}
[[gnu::always_inline]] inline const Point4& point_at(const double* place) {
  return *reinterpret_cast<const Point4*>(place);
}

// Rows become columns.
[[gnu::always_inline]] inline void transpose(Point4& a, Point4& b, Point4& c, Point4& d) {
  const Point4 ac = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Point4 bd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Point4 eg = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Point4 fh = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ac, eg, 0, 1, 4, 5);
  b = __builtin_shufflevector(bd, fh, 0, 1, 4, 5);
  c = __builtin_shufflevector(ac, eg, 2, 3, 6, 7);
  d = __builtin_shufflevector(bd, fh, 2, 3, 6, 7);
}

}  // namespace

double dot_of_points(std::span<const double> a, std::span<const double> b) {
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void gather_points(const LocalIndex* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors* points) {
  if (lanes < kLanes) {
    std::fill_n(points, columns, LaneVectors{});
    for (std::size_t l = 0; l < lanes; ++l) {
      for (std::size_t c = 0; c < columns; ++c) {
        points[c].set(l, x + kPointStride * local[l * columns + c]);
      }
    }
    return;
  }
  for (std::size_t c = 0; c < columns; ++c) {
    double* to = points[c].of[0];
    for (std::size_t l = 0; l < kLanes; l += 4) {
      const LocalIndex* at = local + l * columns + c;
      Point4 a = point_at(x + kPointStride * at[0]);
      Point4 b = point_at(x + kPointStride * at[columns]);
      Point4 p = point_at(x + kPointStride * at[2 * columns]);
      Point4 q = point_at(x + kPointStride * at[3 * columns]);
      transpose(a, b, p, q);
      point_at(to + l) = a;
      point_at(to + kLanes + l) = b;
      point_at(to + 2 * kLanes + l) = p;
    }
  }
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void scatter_points(const LocalIndex* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors* points, double* y) {
  for (std::size_t l = 0; l < kLanes; l += 4) {
    const std::size_t count = lanes > l ? std::min<std::size_t>(4, lanes - l) : 0;
    if (count < 4) {
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t c = 0; c < columns; ++c) {
          points[c].add_to(l + k, y + kPointStride * local[(l + k) * columns + c]);
        }
      }
      continue;
    }
    for (std::size_t c = 0; c < columns; ++c) {
      const double* from = points[c].of[0];
      Point4 a = point_at(from + l);
      Point4 b = point_at(from + kLanes + l);
      Point4 p = point_at(from + 2 * kLanes + l);
      Point4 q = {};
      transpose(a, b, p, q);
      const LocalIndex* at = local + l * columns + c;
      point_at(y + kPointStride * at[0]) += a;
      point_at(y + kPointStride * at[columns]) += b;
      point_at(y + kPointStride * at[2 * columns]) += p;
      point_at(y + kPointStride * at[3 * columns]) += q;
    }
  }
}

}  // namespace surpass

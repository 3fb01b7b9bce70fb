#include "interpolate/lane_points.hpp"

#include <algorithm>

#include "interpolate/each_machine.hpp"

namespace surpass {
namespace {

// At any address that such a number may have, and allowed to look at numbers.
template <class Real>
struct FourOf;
template <>
struct FourOf<double> {
  using Type [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
};
template <>
struct FourOf<float> {
  using Type [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
};
template <class Real>
using Point4 = typename FourOf<Real>::Type;

template <class Real>
[[gnu::always_inline]] inline Point4<Real>& point_at(Real* place) {
  return *reinterpret_cast<Point4<Real>*>(place);
}
template <class Real>
[[gnu::always_inline]] inline const Point4<Real>& point_at(const Real* place) {
  return *reinterpret_cast<const Point4<Real>*>(place);
}

// Rows become columns.
template <class Real>
[[gnu::always_inline]] inline void transpose(Point4<Real> (&rows)[4]) {
  const Point4<Real> ac = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
  const Point4<Real> bd = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
  const Point4<Real> eg = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
  const Point4<Real> fh = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  rows[0] = __builtin_shufflevector(ac, eg, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(bd, fh, 0, 1, 4, 5);
  rows[2] = __builtin_shufflevector(ac, eg, 2, 3, 6, 7);
  rows[3] = __builtin_shufflevector(bd, fh, 2, 3, 6, 7);
}

template <class Real>
[[gnu::always_inline]] inline double dot(std::span<const double> a, std::span<const Real> b) {
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * double{b[i + k]};
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * double{b[i]};
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Points as single precision sees them from the first of their patch, and as they are otherwise.
template <class Real>
[[gnu::always_inline]] inline void see_from(const Point4<double>& first, const double* point,
                                            Point4<Real>& seen) {
  if constexpr (kIsSingle<Real>) {
    seen = __builtin_convertvector(point_at(point) - first, Point4<float>);
  } else {
    seen = point_at(point);
  }
}

template <class Real>
[[gnu::always_inline]] inline void gather(const LocalIndex* local, std::size_t columns,
                                          std::size_t lanes, const double* x,
                                          LaneVectors<Real>* points) {
  if (lanes < kLanes<Real>) std::fill_n(points, columns, LaneVectors<Real>{});
  for (std::size_t l = 0; l < lanes; l += 4) {
    const LocalIndex* const at = local + l * columns;
    // Those that are missing are like the last one there is, and come to nothing below.
    const std::size_t last = std::min<std::size_t>(4, lanes - l) - 1;
    Point4<double> first[4];
    std::size_t row[4];
    for (std::size_t k = 0; k < 4; ++k) {
      row[k] = std::min(k, last) * columns;
      first[k] = point_at(x + kPointStride * at[row[k]]);
    }
    for (std::size_t c = 0; c < columns; ++c) {
      Point4<Real> four[4];
      for (std::size_t k = 0; k < 4; ++k) {
        see_from<Real>(first[k], x + kPointStride * at[row[k] + c], four[k]);
      }
      transpose<Real>(four);
      for (std::size_t k = 0; k < 3; ++k) point_at(points[c].of[k] + l) = four[k];
    }
    for (std::size_t c = 0; last < 3 && c < columns; ++c) {
      for (std::size_t k = l + last + 1; k < l + 4; ++k) points[c].clear(k);
    }
  }
}

template <class Real>
[[gnu::always_inline]] inline void scatter(const LocalIndex* local, std::size_t columns,
                                           std::size_t lanes, const LaneVectors<Real>* points,
                                           Real* y) {
  for (std::size_t l = 0; l < kLanes<Real>; l += 4) {
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
      Point4<Real> four[4] = {};
      for (std::size_t k = 0; k < 3; ++k) four[k] = point_at(points[c].of[k] + l);
      transpose<Real>(four);
      const LocalIndex* at = local + l * columns + c;
      for (std::size_t k = 0; k < 4; ++k) point_at(y + kPointStride * at[k * columns]) += four[k];
    }
  }
}

}  // namespace

double dot_of_points(std::span<const double> a, std::span<const double> b) { return dot(a, b); }
double dot_of_points(std::span<const double> a, std::span<const float> b) { return dot(a, b); }

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void gather_points(const LocalIndex* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors<double>* points) {
  gather(local, columns, lanes, x, points);
}
SURPASS_FOR_EACH_MACHINE("avx2", "default")
void gather_points(const LocalIndex* local, std::size_t columns, std::size_t lanes, const double* x,
                   LaneVectors<float>* points) {
  gather(local, columns, lanes, x, points);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void scatter_points(const LocalIndex* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors<double>* points, double* y) {
  scatter(local, columns, lanes, points, y);
}
SURPASS_FOR_EACH_MACHINE("avx2", "default")
void scatter_points(const LocalIndex* local, std::size_t columns, std::size_t lanes,
                    const LaneVectors<float>* points, float* y) {
  scatter(local, columns, lanes, points, y);
}

}  // namespace surpass

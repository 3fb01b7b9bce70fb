#include "interpolate/sweep_kernel.hpp"

#include <cmath>

#include "interpolate/each_machine.hpp"

namespace surpass {

namespace {

using Four [[gnu::vector_size(32)]] = double;
using Two [[gnu::vector_size(16)]] = double;

// At any address that a double may have, and allowed to look at doubles.
template <class Vector>
struct [[gnu::packed, gnu::may_alias]] Unaligned {
  Vector value;
};

const Unaligned<Four>& four_at(const double* place) {
  return *reinterpret_cast<const Unaligned<Four>*>(place);
}

// Where a place has three numbers, the fourth belongs to the next one.
template <bool kWide>
[[gnu::always_inline]] inline void store(double* place, const Four& value) {
  if (kWide) {
    reinterpret_cast<Unaligned<Four>*>(place)->value = value;
  } else {
    reinterpret_cast<Unaligned<Two>*>(place)->value = Two{value[0], value[1]};
    place[2] = value[2];
  }
}

template <bool kWide>
[[gnu::always_inline]] inline void include(ErrorNorms& norms, const Four& r, double scale) {
  const Four squares = (r * scale) * (r * scale);
  double squared = 0;
  for (std::size_t c = 0; c < (kWide ? 4 : 3); ++c) squared += squares[c];
  const double distance = std::sqrt(squared);
  if (distance > norms.max || std::isnan(distance)) norms.max = distance;
  norms.sum += distance;
}

template <class Column>
struct Run {
  const OrderedRows::Run& rows;
  const Column* columns;
  const double* weights;
  const double* origin;  // of the columns, in the current point
};

// With a constant kLength, the loop over a row's entries has no branch, and its first entry is the
// row's own place.
template <Index kLength, bool kWide, bool kMeasured, class Column>
[[gnu::always_inline]] inline void sweep_run(const Run<Column>& run, const SweepPoints& points,
                                             const SweepStep& sweep, double scale,
                                             ErrorNorms* norms) {
  constexpr std::size_t kTimes = kWide ? 2 : 1;
  constexpr std::size_t kStride = OrderedRows::kStride * kTimes;
  const Index length = kLength != 0 ? kLength : run.rows.length;
  double kept[kLength != 0 ? kLength : 1];  // in registers
  for (Index k = 0; k < kLength; ++k) kept[k] = run.weights[k];
  const double* origin = run.origin;
  const Column* columns = run.columns;
  const double momentum = sweep.momentum;
  const double step = sweep.step;
  ErrorNorms found = kMeasured ? *norms : ErrorNorms{};  // nothing that a stored point might change
  for (std::size_t at = run.rows.begin * kStride; at < run.rows.end * kStride; at += kStride) {
    const Four x = four_at(points.current + at).value;
    Four product{};
    if (kLength != 0) product += kept[0] * x;
    for (Index k = kLength != 0 ? 1 : 0; k < length; ++k) {
      product +=
          (kLength != 0 ? kept[k] : run.weights[k]) * four_at(origin + kTimes * columns[k]).value;
    }
    columns += length;
    const Four r = four_at(points.target + at).value - product;
    store<kWide>(points.next + at,
                 x + momentum * (x - four_at(points.previous + at).value) + step * r);
    if (kMeasured) include<kWide>(found, r, scale);
  }
  if (kMeasured) *norms = found;
}

template <bool kMeasured, class Column>
[[gnu::always_inline]] inline void sweep_narrow(const Run<Column>& run, const SweepPoints& points,
                                                const SweepStep& sweep, double scale,
                                                ErrorNorms* norms) {
  switch (run.rows.own_first ? run.rows.length : 0) {
    case 4: return sweep_run<4, false, kMeasured>(run, points, sweep, scale, norms);
    case 5: return sweep_run<5, false, kMeasured>(run, points, sweep, scale, norms);
    case 6: return sweep_run<6, false, kMeasured>(run, points, sweep, scale, norms);
    case 7: return sweep_run<7, false, kMeasured>(run, points, sweep, scale, norms);
    case 8: return sweep_run<8, false, kMeasured>(run, points, sweep, scale, norms);
    case 9: return sweep_run<9, false, kMeasured>(run, points, sweep, scale, norms);
    case 10: return sweep_run<10, false, kMeasured>(run, points, sweep, scale, norms);
    case 11: return sweep_run<11, false, kMeasured>(run, points, sweep, scale, norms);
    case 13: return sweep_run<13, false, kMeasured>(run, points, sweep, scale, norms);
    default: return sweep_run<0, false, kMeasured>(run, points, sweep, scale, norms);
  }
}

template <bool kMeasured, class Column>
[[gnu::always_inline]] inline void sweep_any(const OrderedRows& rows, std::size_t level,
                                             std::size_t width, const std::vector<Column>& columns,
                                             const SweepPoints& points, const SweepStep& sweep,
                                             double scale, ErrorNorms* norms) {
  const bool wide = width > OrderedRows::kStride;
  const double* origin = points.current + rows.origin(level) * sweep_stride(width);
  for (Index i = rows.levels[level]; i < rows.levels[level + 1]; ++i) {
    const OrderedRows::Run& it = rows.runs[i];
    const Run<Column> run{it, columns.data() + it.columns, rows.weights.data() + it.weights,
                          origin};
    if (wide) {
      sweep_run<0, true, kMeasured>(run, points, sweep, scale, norms);
    } else {
      sweep_narrow<kMeasured>(run, points, sweep, scale, norms);
    }
  }
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void sweep_near(const OrderedRows& rows, std::size_t level, std::size_t width,
                const SweepPoints& points, const SweepStep& sweep) {
  sweep_any<false>(rows, level, width, rows.near, points, sweep, 1, nullptr);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void sweep_far(const OrderedRows& rows, std::size_t level, std::size_t width,
               const SweepPoints& points, const SweepStep& sweep) {
  sweep_any<false>(rows, level, width, rows.far, points, sweep, 1, nullptr);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void measure_near(const OrderedRows& rows, std::size_t level, std::size_t width,
                  const SweepPoints& points, const SweepStep& sweep, double scale,
                  ErrorNorms* norms) {
  sweep_any<true>(rows, level, width, rows.near, points, sweep, scale, norms);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void measure_far(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const SweepPoints& points, const SweepStep& sweep, double scale,
                 ErrorNorms* norms) {
  sweep_any<true>(rows, level, width, rows.far, points, sweep, scale, norms);
}

}  // namespace

void sweep_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const SweepPoints& points, const SweepStep& sweep, double scale,
                 ErrorNorms* norms) {
  if (norms != nullptr) {
    const auto measure = rows.is_near() ? measure_near : measure_far;
    return measure(rows, level, width, points, sweep, scale, norms);
  }
  const auto plain = rows.is_near() ? sweep_near : sweep_far;
  plain(rows, level, width, points, sweep);
}

}  // namespace surpass

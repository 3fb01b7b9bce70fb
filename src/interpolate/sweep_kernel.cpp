#include "interpolate/sweep_kernel.hpp"

#include <cmath>

#include "interpolate/each_machine.hpp"

namespace surpass {

namespace {

// Two and four of a kind of numbers.
template <class Number>
struct Vectors;
template <>
struct Vectors<double> {
  using Two [[gnu::vector_size(16)]] = double;
  using Four [[gnu::vector_size(32)]] = double;
};
template <>
struct Vectors<float> {
  using Two [[gnu::vector_size(8)]] = float;
  using Four [[gnu::vector_size(16)]] = float;
};
using Four = Vectors<double>::Four;
using FourSingle = Vectors<float>::Four;

// At any address that a number may have, and allowed to look at numbers.
template <class Vector>
struct [[gnu::packed, gnu::may_alias]] Unaligned {
  Vector value;
};

template <class Number>
const Unaligned<typename Vectors<Number>::Four>& four_at(const Number* place) {
  return *reinterpret_cast<const Unaligned<typename Vectors<Number>::Four>*>(place);
}

// Where a place has three numbers, the fourth belongs to the next one.
template <bool kWide, class Number>
[[gnu::always_inline]] inline void store(Number* place,
                                         const typename Vectors<Number>::Four& value) {
  using Two = typename Vectors<Number>::Two;
  if (kWide) {
    reinterpret_cast<Unaligned<typename Vectors<Number>::Four>*>(place)->value = value;
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

template <class Column, class Number>
struct Run {
  const OrderedRows::Run& rows;
  const Column* columns;
  const double* weights;
  const Number* origin;  // of the columns, in the point or correction
};

// The weights of rows of known length, in registers.
template <Index kLength, class Number>
struct KeptWeights {
  explicit KeptWeights(const double* weights) {
    for (Index k = 0; k < kLength; ++k) kept[k] = static_cast<Number>(weights[k]);
  }
  Number kept[kLength];
};
template <class Number>
struct KeptWeights<0, Number> {
  explicit KeptWeights(const double* weights) : kept(weights) {}
  const double* kept;
};

// A row's entries times what they are for, one after the other. With a constant kLength there is no
// branch, and the first entry is the row's own place, `own`.
template <Index kLength, bool kWide, class Number, class Vector, class Column>
[[gnu::always_inline]] inline void multiply(const KeptWeights<kLength, Number>& weights,
                                            const Vector& own, const Column* columns, Index length,
                                            const Number* origin, Vector& product) {
  constexpr std::size_t kTimes = kWide ? 2 : 1;
  const auto* kept = weights.kept;
  product = static_cast<Number>(kept[0]) *
            (kLength != 0 ? own : four_at(origin + kTimes * columns[0]).value);
  for (Index k = 1; k < length; ++k) {
    product += static_cast<Number>(kept[k]) * four_at(origin + kTimes * columns[k]).value;
  }
}

// The same for weights alike.
template <Index kLength, bool kWide, class Number, class Vector, class Column>
[[gnu::always_inline]] inline void multiply_alike(const KeptWeights<kLength, Number>& weights,
                                                  const Vector& own, const Column* columns,
                                                  Index length, const Number* origin,
                                                  Vector& product) {
  constexpr std::size_t kTimes = kWide ? 2 : 1;
  Vector sum = four_at(origin + kTimes * columns[1]).value;
  for (Index k = 2; k < length; ++k) sum += four_at(origin + kTimes * columns[k]).value;
  product = static_cast<Number>(weights.kept[0]) *
                (kLength != 0 ? own : four_at(origin + kTimes * columns[0]).value) +
            static_cast<Number>(weights.kept[1]) * sum;
}

template <bool kFresh, bool kLast, bool kAlike>
struct Correcting {
  template <Index kLength, bool kWide, class Column>
  [[gnu::always_inline]] static inline void run(const Run<Column, float>& run,
                                                const CorrectionSweep& sweep) {
    constexpr std::size_t kStride = OrderedRows::kStride * (kWide ? 2 : 1);
    const KeptWeights<kLength, float> weights(run.weights);
    const Index length = kLength != 0 ? kLength : run.rows.length;
    const Column* columns = run.columns;
    const auto momentum = static_cast<float>(sweep.step.momentum);
    const auto step = static_cast<float>(sweep.step.step);
    const float* residual = sweep.residual;
    const float* current = sweep.current;
    float* next = sweep.next;
    const double* from = sweep.from;
    double* to = sweep.to;
    const double unit = sweep.unit;
    const std::size_t end = run.rows.end * kStride;
    for (std::size_t at = run.rows.begin * kStride; at < end; at += kStride) {
      const FourSingle z = four_at(current + at).value;
      FourSingle product;
      if (kAlike) {
        multiply_alike<kLength, kWide>(weights, z, columns, length, run.origin, product);
      } else {
        multiply<kLength, kWide>(weights, z, columns, length, run.origin, product);
      }
      columns += length;
      const FourSingle moved = kFresh ? z : z - four_at(next + at).value;
      const FourSingle newest =
          z + momentum * moved + step * (four_at(residual + at).value - product);
      if (kLast) {
        store<kWide>(next + at, newest - z);
        store<kWide>(to + at,
                     four_at(from + at).value + __builtin_convertvector(newest, Four) * unit);
      } else {
        store<kWide>(next + at, newest);
      }
    }
  }
};

template <bool kFresh, bool kLast>
struct CorrectingRows {
  template <Index kLength, bool kWide, class Column>
  [[gnu::always_inline]] static inline void run(const Run<Column, float>& run,
                                                const CorrectionSweep& sweep) {
    if (run.rows.alike) {
      Correcting<kFresh, kLast, true>::template run<kLength, kWide>(run, sweep);
    } else {
      Correcting<kFresh, kLast, false>::template run<kLength, kWide>(run, sweep);
    }
  }
};

template <bool kFresh>
struct Measuring {
  template <Index kLength, bool kWide, class Column>
  [[gnu::always_inline]] static inline void run(const Run<Column, double>& run,
                                                const ResidualSweep& sweep, ErrorNorms& norms) {
    constexpr std::size_t kStride = OrderedRows::kStride * (kWide ? 2 : 1);
    const KeptWeights<kLength, double> weights(run.weights);
    const Index length = kLength != 0 ? kLength : run.rows.length;
    const Column* columns = run.columns;
    const auto momentum = static_cast<float>(sweep.step.momentum);
    const auto step = static_cast<float>(sweep.step.step);
    const double* point = sweep.point;
    const double* target = sweep.target;
    float* residual = sweep.residual;
    float* correction = sweep.correction;
    const double norm_scale = sweep.norm_scale;
    const double scale = sweep.scale;
    ErrorNorms found = norms;  // nothing that a stored number might change
    const std::size_t end = run.rows.end * kStride;
    for (std::size_t at = run.rows.begin * kStride; at < end; at += kStride) {
      const Four x = four_at(point + at).value;
      Four product;
      multiply<kLength, kWide>(weights, x, columns, length, run.origin, product);
      product += Four{};  // a plain row starts from 0, which tells where all its entries are -0
      columns += length;
      const Four r = four_at(target + at).value - product;
      include<kWide>(found, r, norm_scale);
      const FourSingle rounded = __builtin_convertvector(r * scale, FourSingle);
      const FourSingle moved = kFresh ? FourSingle{} : momentum * four_at(correction + at).value;
      store<kWide>(residual + at, rounded);
      store<kWide>(correction + at, moved + step * rounded);
    }
    norms = found;
  }
};

template <class Stage, class Run, class... More>
[[gnu::always_inline]] inline void run_narrow(const Run& run, More&... more) {
  switch (run.rows.own_first ? run.rows.length : 0) {
    case 4: return Stage::template run<4, false>(run, more...);
    case 5: return Stage::template run<5, false>(run, more...);
    case 6: return Stage::template run<6, false>(run, more...);
    case 7: return Stage::template run<7, false>(run, more...);
    case 8: return Stage::template run<8, false>(run, more...);
    case 9: return Stage::template run<9, false>(run, more...);
    case 10: return Stage::template run<10, false>(run, more...);
    case 11: return Stage::template run<11, false>(run, more...);
    case 13: return Stage::template run<13, false>(run, more...);
    default: return Stage::template run<0, false>(run, more...);
  }
}

template <class Stage, class Column, class Number, class... More>
[[gnu::always_inline]] inline void run_level(const OrderedRows& rows, std::size_t level,
                                             std::size_t width, const std::vector<Column>& columns,
                                             const Number* numbers, More&... more) {
  const Number* origin = numbers + rows.origin(level) * sweep_stride(width);
  for (Index i = rows.levels[level]; i < rows.levels[level + 1]; ++i) {
    const OrderedRows::Run& it = rows.runs[i];
    const Run<Column, Number> run{it, columns.data() + it.columns, rows.weights.data() + it.weights,
                                  origin};
    if (width > OrderedRows::kStride) {
      Stage::template run<0, true>(run, more...);
    } else {
      run_narrow<Stage>(run, more...);
    }
  }
}

template <class Column>
[[gnu::always_inline]] inline void sweep_any(const OrderedRows& rows, std::size_t level,
                                             std::size_t width, const std::vector<Column>& columns,
                                             const CorrectionSweep& sweep) {
  const float* numbers = sweep.current;
  if (sweep.to == nullptr) {
    if (sweep.fresh)
      return run_level<CorrectingRows<true, false>>(rows, level, width, columns, numbers, sweep);
    return run_level<CorrectingRows<false, false>>(rows, level, width, columns, numbers, sweep);
  }
  if (sweep.fresh)
    return run_level<CorrectingRows<true, true>>(rows, level, width, columns, numbers, sweep);
  run_level<CorrectingRows<false, true>>(rows, level, width, columns, numbers, sweep);
}

template <class Column>
[[gnu::always_inline]] inline void measure_any(const OrderedRows& rows, std::size_t level,
                                               std::size_t width,
                                               const std::vector<Column>& columns,
                                               const ResidualSweep& sweep, ErrorNorms& norms) {
  if (sweep.fresh) {
    return run_level<Measuring<true>>(rows, level, width, columns, sweep.point, sweep, norms);
  }
  run_level<Measuring<false>>(rows, level, width, columns, sweep.point, sweep, norms);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void sweep_near(const OrderedRows& rows, std::size_t level, std::size_t width,
                const CorrectionSweep& sweep) {
  sweep_any(rows, level, width, rows.near, sweep);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void sweep_far(const OrderedRows& rows, std::size_t level, std::size_t width,
               const CorrectionSweep& sweep) {
  sweep_any(rows, level, width, rows.far, sweep);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void measure_near(const OrderedRows& rows, std::size_t level, std::size_t width,
                  const ResidualSweep& sweep, ErrorNorms& norms) {
  measure_any(rows, level, width, rows.near, sweep, norms);
}

SURPASS_FOR_EACH_MACHINE("avx2", "default")
void measure_far(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const ResidualSweep& sweep, ErrorNorms& norms) {
  measure_any(rows, level, width, rows.far, sweep, norms);
}

}  // namespace

void sweep_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                 const CorrectionSweep& sweep) {
  const auto run = rows.is_near() ? sweep_near : sweep_far;
  run(rows, level, width, sweep);
}

void measure_level(const OrderedRows& rows, std::size_t level, std::size_t width,
                   const ResidualSweep& sweep, ErrorNorms& norms) {
  const auto run = rows.is_near() ? measure_near : measure_far;
  run(rows, level, width, sweep, norms);
}

}  // namespace surpass

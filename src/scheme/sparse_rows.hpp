// Sparse rows of weights: the limit operator, refinement stencils. Gathered, never scattered.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <array>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "parallel/parallel.hpp"
#include "scheme/row_product.hpp"
#include "scheme/weight_lists.hpp"

namespace surpass {

/// Compressed rows: row i is the sum over its entries k of row_weights(i)[k] *
/// x[row_columns(i)[k]]. Rows with equal weights share them, so that nearly all that a sweep reads
/// are the columns.
class SparseRows {
 public:
  [[nodiscard]] Index row_count() const { return static_cast<Index>(rows_.size() - 1); }
  [[nodiscard]] Index row_length(Index i) const { return rows_[i + 1].columns - rows_[i].columns; }
  [[nodiscard]] std::span<const Index> row_columns(Index i) const {
    return {columns_.data() + rows_[i].columns, row_length(i)};
  }
  [[nodiscard]] std::span<const double> row_weights(Index i) const {
    return {weights_.data() + rows_[i].weights, row_length(i)};
  }

  /// The distinct lists of weights, one after the other, and where that of row i starts. Rows have
  /// the same weights, bit by bit, if and only if theirs start at the same place.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  [[nodiscard]] Index weights_start(Index i) const { return rows_[i].weights; }

  /// Hints for walks in an order that the processor cannot foresee: first where row i lies, then,
  /// some time later, its columns.
  void prefetch_row(Index i) const { __builtin_prefetch(&rows_[i]); }
  void prefetch_columns(Index i) const {
    __builtin_prefetch(columns_.data() + rows_[i].columns);
    __builtin_prefetch(columns_.data() + rows_[i + 1].columns - 1);
  }

  /// Builds n rows in two passes: length(i), then fill(i, columns, weights) with spans that long.
  /// It may return a number, kNone or a small one: rows with the same small number have the same
  /// weights and are not compared.
  template <class Length, class Fill>
  static SparseRows build(const Context& context, Index n, Length&& length, Fill&& fill);

  [[nodiscard]] RowView row(Index i) const {
    return {row_columns(i), weights_.data() + rows_[i].weights};
  }
  /// Row i times three right-hand sides; see RowView.
  [[nodiscard]] std::array<double, 3> row_times_3(Index i, const double* x) const {
    return row(i).times_3(x);
  }
  /// use(c, row i times right-hand side c) for each of `width`; x: #columns by width.
  template <class Use>
  void row_times(Index i, std::size_t width, const double* x, Use&& use) const {
    row(i).times(width, x, use);
  }

  /// y = rows * x for row-major values of `width` numbers each. x: #columns by width, y: #rows by
  /// width.
  void apply(const Context& context, std::size_t width, std::span<const double> x,
             std::span<double> y) const {
    parallel::for_ranges(context, row_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        row_times(static_cast<Index>(i), width, x.data(),
                  [&](std::size_t c, double product) { y[i * width + c] = product; });
      }
    });
  }

  [[nodiscard]] std::vector<Point> apply(const Context& context,
                                         std::span<const Point> points) const {
    std::vector<Point> result(row_count());
    apply(context, 3, flat(points), flat(std::span(result)));
    return result;
  }

 private:
  // `part` holds the lists of the rows from `begin` to `end`, which know them by number.
  void adopt_lists(std::size_t begin, std::size_t end, const WeightLists& part, WeightLists& all);

  struct Row {
    Index columns = 0;  ///< where they start; they end where the next row's start
    Index weights = 0;
  };

  std::vector<Row> rows_ = {{}};
  std::vector<Index> columns_;
  std::vector<double> weights_;
};

template <class Length, class Fill>
SparseRows SparseRows::build(const Context& context, Index n, Length&& length, Fill&& fill) {
  SparseRows rows;
  rows.rows_.resize(static_cast<std::size_t>(n) + 1);
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      rows.rows_[i + 1].columns = length(static_cast<Index>(i));
    }
  });
  for (Index i = 0; i < n; ++i) rows.rows_[i + 1].columns += rows.rows_[i].columns;
  rows.columns_.resize(rows.rows_.back().columns);
  // Each chunk keeps its own lists; they are joined in the order of chunks, the same for any number
  // of threads.
  std::vector<WeightLists> parts((n + parallel::kChunk - 1) / parallel::kChunk);
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    WeightLists lists;
    std::vector<double> weights;
    std::vector<Index> known;  // lists, by the numbers that `fill` has for them
    for (std::size_t k = begin; k < end; ++k) {
      const auto i = static_cast<Index>(k);
      weights.resize(rows.row_length(i));
      const std::span<Index> columns(rows.columns_.data() + rows.rows_[i].columns, weights.size());
      Index alike = kNone;
      if constexpr (std::is_void_v<decltype(fill(i, columns, std::span(weights)))>) {
        fill(i, columns, std::span(weights));
      } else {
        alike = fill(i, columns, std::span(weights));
      }
      if (alike < known.size() && known[alike] != kNone) {
        rows.rows_[i].weights = known[alike];
        continue;
      }
      rows.rows_[i].weights = lists.number_of(weights);
      if (alike == kNone) continue;
      if (alike >= known.size()) known.resize(std::size_t{alike} + 1, kNone);
      known[alike] = rows.rows_[i].weights;
    }
    parts[begin / parallel::kChunk] = std::move(lists);
  });
  WeightLists all;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const std::size_t begin = c * parallel::kChunk;
    rows.adopt_lists(begin, std::min<std::size_t>(n, begin + parallel::kChunk), parts[c], all);
  }
  rows.weights_ = std::move(all).take_weights();
  return rows;
}

inline void SparseRows::adopt_lists(std::size_t begin, std::size_t end, const WeightLists& part,
                                    WeightLists& all) {
  std::vector<Index> starts(part.size());
  for (Index number = 0; number < part.size(); ++number) {
    starts[number] = all.start(all.number_of(part[number]));
  }
  for (std::size_t i = begin; i < end; ++i) rows_[i].weights = starts[rows_[i].weights];
}

}  // namespace surpass

// Sparse rows of weights: the limit operator, refinement stencils. Gathered, never scattered.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "parallel/parallel.hpp"

namespace surpass {

/// Compressed rows: row i is sum over k in offsets[i]..offsets[i+1] of weights[k] * x[columns[k]].
struct SparseRows {
  std::vector<Index> offsets = {0};
  std::vector<Index> columns;
  std::vector<double> weights;

  [[nodiscard]] Index row_count() const { return static_cast<Index>(offsets.size() - 1); }
  [[nodiscard]] std::span<const Index> row_columns(Index i) const {
    return std::span(columns).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  [[nodiscard]] std::span<const double> row_weights(Index i) const {
    return std::span(weights).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }

  /// Builds n rows in two passes: length(i), then fill(i, columns, weights) with spans that long.
  template <class Length, class Fill>
  static SparseRows build(const Context& context, Index n, Length&& length, Fill&& fill) {
    SparseRows rows;
    rows.offsets.assign(static_cast<std::size_t>(n) + 1, 0);
    parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) rows.offsets[i + 1] = length(static_cast<Index>(i));
    });
    std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
    rows.columns.resize(rows.offsets.back());
    rows.weights.resize(rows.offsets.back());
    parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t at = rows.offsets[i];
        const std::size_t size = rows.offsets[i + 1] - at;
        fill(static_cast<Index>(i), std::span(rows.columns).subspan(at, size),
             std::span(rows.weights).subspan(at, size));
      }
    });
    return rows;
  }

  /// y = rows * x for row-major values of `width` numbers each. x: #columns by width, y: #rows by
  /// width.
  void apply(const Context& context, std::size_t width, std::span<const double> x,
             std::span<double> y) const {
    parallel::for_ranges(context, row_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < width; ++c) {
          double sum = 0;
          for (Index k = offsets[i]; k < offsets[i + 1]; ++k) {
            sum += weights[k] * x[columns[k] * width + c];
          }
          y[i * width + c] = sum;
        }
      }
    });
  }

  [[nodiscard]] std::vector<Point> apply(const Context& context,
                                         std::span<const Point> points) const {
    std::vector<Point> result(row_count());
    apply(context, 3, flat(points), flat(std::span(result)));
    return result;
  }
};

}  // namespace surpass

// L x = target on a block of unknowns: products, errors and sums with the same bits on any threads.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "interpolate/blocks.hpp"

namespace surpass {

/// Distances |target - L x| over a block, times the system's scale.
struct ErrorNorms {
  double max = 0;
  double sum = 0;
};

/// The system restricted to a block. Arrays are #V by width, row after row; entries outside the
/// block are read (as known values of x) and never written.
struct LinearSystem {
  const LimitOperator& op;
  const Block& block;
  std::size_t width;  ///< right-hand sides
  std::span<const double> target;
  double scale;  ///< a power of two that brings the data near 1: squares stay finite
  const Context& context;

  [[nodiscard]] std::size_t values() const { return op.rows.row_count() * width; }

  /// r = target - L x on the block.
  ErrorNorms residual(std::span<const double> x, std::span<double> r) const;

  /// y = L p on the block; p must be zero outside it.
  void product(std::span<const double> p, std::span<double> y) const;

  /// The norms of values that are residuals already.
  [[nodiscard]] ErrorNorms block_norms(std::span<const double> r) const;

  /// next = x + momentum * (x - previous) + step * (target - L x), where `previous` is overwritten
  /// by next. Returns the errors of x where they are asked for.
  ErrorNorms sweep(std::span<const double> x, std::span<double> previous, double momentum,
                   double step, bool measure) const;

  /// Per right-hand side: sum over the block of weight_v * a_v * b_v, scaled by scale^2. Without
  /// weights they are 1.
  [[nodiscard]] std::vector<double> dot(std::span<const double> a, std::span<const double> b,
                                        const std::vector<double>* weights) const;

  /// body(value) for every number of the block: `value` indexes arrays, `c` its right-hand side.
  template <class Body>
  void for_values(Body&& body) const {
    parallel::for_ranges(context, block.vertices.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < width; ++c) body(block.vertices[i] * width + c, c);
      }
    });
  }
};

/// A power of two near 1 / unit, within the range of doubles.
[[nodiscard]] double power_of_two_scale(double unit);

}  // namespace surpass

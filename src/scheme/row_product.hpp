// A row of weights times values, the plain way: what every faster way must equal bit by bit.
#pragma once

#include <surpass/mesh.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace surpass {

/// The entries of a row: as many weights as columns.
struct RowView {
  std::span<const Index> columns;
  const double* weights;

  /// Times three right-hand sides, the case that matters; x: #columns of the matrix by 3.
  [[nodiscard]] std::array<double, 3> times_3(const double* x) const {
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    const double* w = weights;
    for (const Index column : columns) {
      const double* p = x + std::size_t{3} * column;
      s0 += *w * p[0];
      s1 += *w * p[1];
      s2 += *w * p[2];
      ++w;
    }
    return {s0, s1, s2};
  }

  /// use(c, row times right-hand side c) for each of `width`; x: #columns of the matrix by width.
  template <class Use>
  void times(std::size_t width, const double* x, Use&& use) const {
    if (width == 3) {
      const auto product = times_3(x);
      for (std::size_t c = 0; c < 3; ++c) use(c, product[c]);
      return;
    }
    for (std::size_t c = 0; c < width; ++c) {
      double sum = 0;
      const double* w = weights;
      for (const Index column : columns) sum += *w++ * x[column * width + c];
      use(c, sum);
    }
  }
};

}  // namespace surpass

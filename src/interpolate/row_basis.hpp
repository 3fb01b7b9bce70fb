// Rows that others are expressed by.
#pragma once

#include <surpass/context.hpp>

#include <optional>
#include <vector>

#include "interpolate/independent_rows.hpp"
#include "interpolate/sparse_cholesky.hpp"

namespace surpass {

/// Of shares: what is less is rounding.
constexpr double kNoShare = 1e-12;

/// Added to the squares of rows keeps their decomposition going past dependent ones, whose pivots
/// become this times the sum of their squared shares: far above the rounding of products, and for
/// shares up to 1000 below what is suspect.
constexpr double kShift = 1e-14;

[[nodiscard]] Symmetric products_of(const RowMatrix& rows);

[[nodiscard]] RowMatrix picked(const RowMatrix& rows, const std::vector<int>& which);

/// The rows and the list must outlive it.
class RowBasis {
 public:
  RowBasis(const RowMatrix& rows, const std::vector<int>& independent, const Context& context);

  /// Nothing where the basis is itself so close to dependent that too few digits are left, or where
  /// shares are larger than `largest`: their sum loses as many digits.
  [[nodiscard]] std::optional<DependentRow> express(int row, double largest = 100) const;

 private:
  [[nodiscard]] std::optional<Eigen::VectorXd> shares_in(Eigen::VectorXd& rest,
                                                         double largest) const;

  const RowMatrix& rows_;
  const std::vector<int>& independent_;
  RowMatrix basis_;
  SparseCholesky products_;
  bool decomposed_ = false;
};

}  // namespace surpass

// Which rows of a sparse matrix are independent, and how the others follow from them.
#pragma once

#include <surpass/context.hpp>

#include <utility>
#include <vector>

#include <Eigen/SparseCore>

namespace surpass {

/// A row that is a sum of independent ones, but for `distance`.
struct DependentRow {
  int row;
  double distance;
  std::vector<std::pair<int, double>> shares;  ///< of independent rows, what rounding is left out
};

/// Of this distance on a row is nearly dependent, and not dependent.
constexpr double kDependent = 1e-9;

/// Lists are cut short where the context was cancelled, or where rows could not be decomposed.
struct IndependentRows {
  std::vector<int> independent;         ///< ascending
  std::vector<DependentRow> dependent;  ///< ascending
};

/// Rows have length 1, or 0. Those are listed as dependent that lie within about 1e-4 of the span
/// of the independent ones; how close is told to 1e-13 or so. Where that is more than kDependent,
/// all shares are there.
/// Method: the pivots of a Cholesky decomposition of the rows' products are the squared distances
/// from the span of the rows before; it stays as sparse as the mesh, which a QR decomposition does
/// not (on 3000 rows that took minutes). The few rows that look dependent are then expressed by the
/// others - of repeated ones the later by the earlier - and the difference taken from the rows
/// themselves, which loses no digits by squaring. More rows than columns are looked at in parts,
/// with those that were found before: what takes part at once is never more than twice the columns.
[[nodiscard]] IndependentRows independent_rows(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows, const Context& context);

}  // namespace surpass

// Which rows of a sparse matrix are independent, and how the others follow from them.
#pragma once

#include <surpass/context.hpp>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

namespace surpass {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using RowNumbers = std::vector<int>;  // ascending

/// A row that is a sum of others that are kept, but for `distance`.
struct DependentRow {
  int row;
  double distance;
  std::vector<std::pair<int, double>> shares;  ///< of kept rows, ascending, without rounding
};

/// Of this distance on a row is nearly dependent, and not dependent. What a surface within some box
/// sides makes of less is within kRequirementTolerance.
constexpr double kDependent = 1e-11;

struct IndependentRows {
  std::vector<int> independent;  ///< ascending
  /// Kept, too, for what they have of their own: (row - shares) / distance, of length 1. Shares are
  /// of independent rows and of each other.
  std::vector<DependentRow> near;
  std::vector<DependentRow> dependent;  ///< ascending
};

/// Whether a dependent row, as it was found, makes it needless to look at more.
using Suffices = std::function<bool(const DependentRow&)>;

/// Of the `list` of rows, ascending. They have length 1, or 0. Those are looked at that lie within
/// about 1e-4 of the span of the independent ones, or within a third where rows lie so densely that
/// many are nearly dependent; how close is told to 1e-13 or so. Nothing where the context was
/// cancelled, where a row sufficed, and where rows are so nearly dependent that they cannot be told
/// apart. Method: the pivots of a Cholesky decomposition of the rows' products are the squared
/// distances from the span of the rows before; it stays as sparse as the mesh, which a QR
/// decomposition does not (on 3000 rows that took minutes). The few rows that look dependent are
/// then expressed by the others - of repeated ones the later by the earlier - and the difference
/// taken from the rows themselves, which loses no digits by squaring. Where it does not settle the
/// others are nearly dependent themselves, though none on those before it, and more are looked at.
/// Those that are nearly dependent go through near_rows(). More rows than columns are looked at in
/// parts, with those that were kept before: what takes part at once is never more than twice the
/// columns. Each is expressed in the time of two to six solutions; whether a dependent one suffices
/// is asked at once, of the later row of a sum as far as is known by then.
[[nodiscard]] std::optional<IndependentRows> independent_rows(const RowMatrix& rows,
                                                              const RowNumbers& list,
                                                              const Suffices& suffices,
                                                              const Context& context);

/// The matrix that makes of all rows those that are kept, the independent ones and the own parts of
/// the near ones.
[[nodiscard]] RowMatrix pick_of(const IndependentRows& found, Eigen::Index rows);

}  // namespace surpass

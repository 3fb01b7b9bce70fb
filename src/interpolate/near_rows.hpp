// What rows have of their own that lie close to the span of others, but not in it.
#pragma once

#include <span>

#include "interpolate/independent_rows.hpp"

namespace surpass {

/// The own part of a kept row is (row - its shares) / distance: of length 1, and orthogonal to
/// those of the others. Shares are of independent rows, and of those kept.
struct NearRows {
  std::vector<DependentRow> kept;
  std::vector<DependentRow> dropped;  ///< of these no more than kDependent is left
};

/// Of `near`, rows that independent ones leave at a distance. Method: Gram-Schmidt with pivoting,
/// the row with the most of its own first, on what the independent ones leave of each; so that
/// nothing is divided by a small length before it is known which are small. Parts that have no
/// column in common are done apart: O(#rows^2 #columns) of each, with as much memory as its matrix.
/// Cut short where the context was cancelled.
[[nodiscard]] NearRows near_rows(const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows,
                                 std::span<const DependentRow> near, const Context& context);

}  // namespace surpass

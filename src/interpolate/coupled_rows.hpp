// Rows that share the columns that they are to be solved for.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "scheme/sparse_rows.hpp"

namespace surpass {

/// x[pivot] = sum of shares * targets - sum of others * x.
struct CoupledRow {
  std::vector<std::pair<Index, double>> others;  ///< columns, none of which is a pivot
  std::vector<std::pair<Index, double>> shares;  ///< rows
};

/// Solves the rows numbered `which` for the columns `pivots` (as many) together; other rows do not
/// have these. Empty if that is impossible. By sparse LU decomposition; what is sparse of the
/// inverse stays sparse.
[[nodiscard]] std::vector<CoupledRow> coupled_rows(const SparseRows& rows,
                                                   std::span<const Index> which,
                                                   std::span<const Index> pivots,
                                                   Index column_count);

}  // namespace surpass

#include "interpolate/balanced_values.hpp"

#include <vector>

#include "interpolate/row_basis.hpp"

namespace surpass {
namespace {

// #dropped by #rows.
RowMatrix shares_of(const std::vector<DependentRow>& dropped, Eigen::Index rows) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    for (const auto& [row, share] : dropped[i].shares) {
      entries.emplace_back(static_cast<int>(i), row, share);
    }
  }
  RowMatrix shares(static_cast<Eigen::Index>(dropped.size()), rows);
  shares.setFromTriplets(entries.begin(), entries.end());
  return shares;
}

}  // namespace

Eigen::VectorXd balanced_values(const std::vector<DependentRow>& dropped,
                                const Eigen::VectorXd& values, const Context& context) {
  const RowMatrix shares = shares_of(dropped, values.size());
  SparseCholesky factor;
  if (!factor.compute(products_of(shares), 1, context)) return values;
  Eigen::VectorXd missed = -(shares * values);
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    missed[static_cast<Eigen::Index>(i)] += values[dropped[i].row];
  }
  Eigen::VectorXd left = factor.solve(missed);
  // Once more for the digits that squaring took.
  left += factor.solve(missed - left - shares * (shares.transpose() * left));
  return values + shares.transpose() * left;
}

}  // namespace surpass

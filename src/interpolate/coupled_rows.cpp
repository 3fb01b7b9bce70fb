#include "interpolate/coupled_rows.hpp"

#include <cmath>

#include <Eigen/SparseLU>

namespace surpass {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr double kRounding = 1e-17;
constexpr double kLargest = 1e6;  // of the inverse; rows that are really apart stay far below

}  // namespace

std::vector<CoupledRow> coupled_rows(const SparseRows& rows, std::span<const Index> which,
                                     std::span<const Index> pivots, Index column_count) {
  std::vector<Index> place(column_count, kNone);  // of a pivot
  for (std::size_t k = 0; k < pivots.size(); ++k) place[pivots[k]] = static_cast<Index>(k);
  const auto for_each = [&](std::size_t k, auto&& use) {
    const auto columns = rows.row_columns(which[k]);
    const auto weights = rows.row_weights(which[k]);
    for (std::size_t i = 0; i < columns.size(); ++i) use(columns[i], weights[i]);
  };
  const auto size = static_cast<Eigen::Index>(which.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < which.size(); ++k) {
    for_each(k, [&](Index column, double w) {
      if (place[column] == kNone) return;
      entries.emplace_back(static_cast<int>(k), static_cast<int>(place[column]), w);
    });
  }
  Matrix square(size, size);
  square.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Matrix> lu;
  lu.compute(square);
  if (lu.info() != Eigen::Success) return {};

  std::vector<CoupledRow> found(which.size());
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size);
  for (Eigen::Index from = 0; from < size; ++from) {
    unit[from] = 1;
    const Eigen::VectorXd column = lu.solve(unit);
    unit[from] = 0;
    if (!(column.cwiseAbs().maxCoeff() < kLargest)) return {};
    for (Eigen::Index to = 0; to < size; ++to) {
      const double share = column[to];
      if (std::abs(share) <= kRounding) continue;
      CoupledRow& row = found[static_cast<std::size_t>(to)];
      row.shares.emplace_back(which[static_cast<std::size_t>(from)], share);
      for_each(static_cast<std::size_t>(from), [&](Index j, double w) {
        if (place[j] == kNone) row.others.emplace_back(j, share * w);
      });
    }
  }
  return found;
}

}  // namespace surpass

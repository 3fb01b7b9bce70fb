#include "interpolate/row_basis.hpp"

#include <cmath>

namespace surpass {

Symmetric products_of(const RowMatrix& rows) {
  const Symmetric columns = rows.transpose();
  return rows * columns;
}

RowMatrix picked(const RowMatrix& rows, const std::vector<int>& which) {
  std::vector<Eigen::Triplet<double>> ones;
  for (std::size_t k = 0; k < which.size(); ++k)
    ones.emplace_back(static_cast<int>(k), which[k], 1);
  RowMatrix pick(static_cast<Eigen::Index>(which.size()), rows.rows());
  pick.setFromTriplets(ones.begin(), ones.end());
  return pick * rows;
}

RowBasis::RowBasis(const RowMatrix& rows, const std::vector<int>& independent,
                   const Context& context)
    : rows_(rows), independent_(independent), basis_(picked(rows, independent)) {
  decomposed_ = independent.empty() || products_.compute(products_of(basis_), 0, context);
}

std::optional<DependentRow> RowBasis::express(int row, double largest) const {
  if (!decomposed_) return std::nullopt;
  Eigen::VectorXd rest = Eigen::VectorXd(rows_.row(row).transpose());
  DependentRow dependent{row, rest.norm(), {}};
  if (independent_.empty() || dependent.distance == 0) return dependent;
  const auto shares = shares_in(rest, largest);
  if (!shares) return std::nullopt;
  dependent.distance = rest.norm();
  const double rounding = dependent.distance > kDependent ? 0 : kNoShare;
  for (Eigen::Index k = 0; k < shares->size(); ++k) {
    const double share = (*shares)[k];
    if (std::abs(share) > rounding) {
      dependent.shares.emplace_back(independent_[static_cast<std::size_t>(k)], share);
    }
  }
  return dependent;
}

// Takes from the row what lies in the span.
std::optional<Eigen::VectorXd> RowBasis::shares_in(Eigen::VectorXd& rest, double largest) const {
  constexpr int kMostRounds = 6;  // each gives back digits that squaring took, if it gives any
  constexpr double kSettled = 1e-13;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(basis_.rows());
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd more = products_.solve(Eigen::VectorXd(basis_ * rest));
    const Eigen::VectorXd change = basis_.transpose() * more;
    shares += more;
    rest -= change;
    if (!(shares.cwiseAbs().maxCoeff() <= largest)) return std::nullopt;
    if (change.norm() <= kSettled) return shares;
  }
  return std::nullopt;
}

}  // namespace surpass

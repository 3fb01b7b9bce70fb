#include "interpolate/independent_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "interpolate/sparse_cholesky.hpp"

namespace surpass {
namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double kSuspect = 1e-8;  // a squared distance
// Keeps the decomposition going past dependent rows, whose pivots become this times the sum of
// their squared shares: far above the rounding of products, and for shares up to 1000 below what is
// suspect.
constexpr double kShift = 1e-14;
constexpr double kNoShare = 1e-12;

Symmetric products_of(const Rows& rows) {
  const Symmetric columns = rows.transpose();
  return rows * columns;
}

Rows picked(const Rows& rows, const std::vector<int>& which) {
  std::vector<Eigen::Triplet<double>> ones;
  for (std::size_t k = 0; k < which.size(); ++k)
    ones.emplace_back(static_cast<int>(k), which[k], 1);
  Rows pick(static_cast<Eigen::Index>(which.size()), rows.rows());
  pick.setFromTriplets(ones.begin(), ones.end());
  return pick * rows;
}

// The row as a sum of the independent ones.
DependentRow expressed(const Rows& rows, int row, const std::vector<int>& independent,
                       const Rows& basis, const SparseCholesky& factor) {
  Eigen::VectorXd rest = Eigen::VectorXd(rows.row(row).transpose());
  DependentRow dependent{row, rest.norm(), {}};
  if (independent.empty() || dependent.distance == 0) return dependent;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(basis.rows());
  for (int round = 0; round < 3; ++round) {  // each gives back the digits that squaring took
    const Eigen::VectorXd more = factor.solve(Eigen::VectorXd(basis * rest));
    shares += more;
    rest -= basis.transpose() * more;
  }
  dependent.distance = rest.norm();
  const double rounding = dependent.distance > kDependent ? 0 : kNoShare;
  for (Eigen::Index k = 0; k < shares.size(); ++k) {
    if (std::abs(shares[k]) > rounding) {
      dependent.shares.emplace_back(independent[static_cast<std::size_t>(k)], shares[k]);
    }
  }
  return dependent;
}

// Where a dependent row can change places with a later one of its sum, it does: of rows that repeat
// each other, the first is to be kept.
void prefer_earlier(IndependentRows& found) {
  constexpr double kSound = 1e-3;  // as a divisor
  for (std::size_t at = 0; at < found.dependent.size(); ++at) {
    DependentRow& d = found.dependent[at];
    if (d.distance > kDependent) continue;  // it is kept anyway
    std::size_t latest = d.shares.size();
    for (std::size_t k = 0; k < d.shares.size(); ++k) {
      if (d.shares[k].first < d.row || std::abs(d.shares[k].second) < kSound) continue;
      if (latest == d.shares.size() || d.shares[k].first > d.shares[latest].first) latest = k;
    }
    if (latest == d.shares.size()) continue;
    const auto [row, share] = d.shares[latest];
    std::replace(found.independent.begin(), found.independent.end(), row, d.row);
    d.shares[latest].first = std::exchange(d.row, row);
    for (std::size_t k = 0; k < d.shares.size(); ++k) {
      d.shares[k].second = k == latest ? 1 / share : -d.shares[k].second / share;
    }
    for (DependentRow& other : found.dependent) {
      if (&other == &d) continue;
      const auto in = std::find_if(other.shares.begin(), other.shares.end(),
                                   [&, gone = row](const auto& s) { return s.first == gone; });
      if (in == other.shares.end()) continue;
      const double factor = in->second;
      std::map<int, double> sum(other.shares.begin(), other.shares.end());
      sum.erase(row);
      for (const auto& [basis, weight] : d.shares) sum[basis] += factor * weight;
      other.shares.assign(sum.begin(), sum.end());
    }
  }
  std::sort(found.independent.begin(), found.independent.end());
  std::sort(found.dependent.begin(), found.dependent.end(),
            [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
}

// Those that are nearly dependent, by the rows that are now kept: their small difference would not
// survive that of a row from its sum.
void express_again(const Rows& rows, const Context& context, IndependentRows& found) {
  const auto near = [](const DependentRow& d) { return d.distance > kDependent; };
  if (found.independent.empty() ||
      std::none_of(found.dependent.begin(), found.dependent.end(), near)) {
    return;
  }
  const Rows basis = picked(rows, found.independent);
  SparseCholesky factor;
  if (!factor.compute(products_of(basis), 0, context)) {
    found = {};
    return;
  }
  for (DependentRow& d : found.dependent) {
    if (near(d)) d = expressed(rows, d.row, found.independent, basis, factor);
  }
}

// Those among `which`, ascending. Of dependent ones the shares are of independent ones there.
IndependentRows independent_among(const Rows& rows, const std::vector<int>& which,
                                  const Context& context) {
  IndependentRows found;
  const Rows some = picked(rows, which);
  SparseCholesky factor;
  if (!factor.compute(products_of(some), kShift, context)) return found;
  const Eigen::VectorXd pivots = factor.pivots();
  std::vector<int> suspects;
  for (int i = 0; i < static_cast<int>(which.size()); ++i) {
    (pivots[i] < kSuspect ? suspects : found.independent)
        .push_back(which[static_cast<std::size_t>(i)]);
  }
  if (suspects.empty()) return found;
  const Rows basis = picked(rows, found.independent);
  if (!found.independent.empty() && !factor.compute(products_of(basis), 0, context)) return found;
  for (const int row : suspects) {
    if (context.cancelled()) break;
    found.dependent.push_back(expressed(rows, row, found.independent, basis, factor));
  }
  prefer_earlier(found);
  return found;
}

// As many rows as can be independent of each other.
std::size_t most_independent(const Rows& rows) {
  std::vector<unsigned char> used(static_cast<std::size_t>(rows.cols()), 0);
  for (Eigen::Index i = 0; i < rows.outerSize(); ++i) {
    for (Rows::InnerIterator k(rows, i); k; ++k) used[static_cast<std::size_t>(k.col())] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

}  // namespace

IndependentRows independent_rows(const Rows& rows, const Context& context) {
  IndependentRows found;
  const auto count = static_cast<std::size_t>(rows.rows());
  const std::size_t part = std::max<std::size_t>(1, most_independent(rows));
  for (std::size_t begin = 0; begin < count && !context.cancelled(); begin += part) {
    std::vector<int> which = found.independent;
    for (std::size_t i = begin; i < std::min(count, begin + part); ++i) {
      which.push_back(static_cast<int>(i));
    }
    IndependentRows more = independent_among(rows, which, context);
    found.independent = std::move(more.independent);
    found.dependent.insert(found.dependent.end(), more.dependent.begin(), more.dependent.end());
  }
  std::sort(found.dependent.begin(), found.dependent.end(),
            [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
  if (!context.cancelled()) express_again(rows, context, found);
  return found;
}

}  // namespace surpass

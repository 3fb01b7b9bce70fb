#include "interpolate/independent_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "interpolate/near_rows.hpp"
#include "interpolate/sparse_cholesky.hpp"

namespace surpass {
namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Squared distances: rows that are no closer to those before them are taken to be independent. The
// next holds where the one before left too few digits, which is seen soon.
constexpr std::array kSuspect = {1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1};
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

// Independent rows, to express others by.
class Basis {
 public:
  Basis(const Rows& rows, const std::vector<int>& independent, const Context& context)
      : rows_(rows), independent_(independent), basis_(picked(rows, independent)) {
    decomposed_ = independent.empty() || products_.compute(products_of(basis_), 0, context);
  }

  // Nothing where the basis is itself so close to dependent that too few digits are left.
  [[nodiscard]] std::optional<DependentRow> express(int row) const {
    if (!decomposed_) return std::nullopt;
    Eigen::VectorXd rest = Eigen::VectorXd(rows_.row(row).transpose());
    DependentRow dependent{row, rest.norm(), {}};
    if (independent_.empty() || dependent.distance == 0) return dependent;
    const auto shares = shares_in(rest);
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

 private:
  // Takes from the row what lies in the span.
  [[nodiscard]] std::optional<Eigen::VectorXd> shares_in(Eigen::VectorXd& rest) const {
    constexpr int kMostRounds = 6;  // each gives back digits that squaring took, if it gives any
    constexpr double kSettled = 1e-13;
    constexpr double kLarge = 100;
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(basis_.rows());
    for (int round = 0; round < kMostRounds; ++round) {
      const Eigen::VectorXd more = products_.solve(Eigen::VectorXd(basis_ * rest));
      const Eigen::VectorXd change = basis_.transpose() * more;
      shares += more;
      rest -= change;
      if (!(shares.cwiseAbs().maxCoeff() <= kLarge)) return std::nullopt;
      if (change.norm() <= kSettled) return shares;
    }
    return std::nullopt;
  }

  const Rows& rows_;
  const std::vector<int>& independent_;
  Rows basis_;
  SparseCholesky products_;
  bool decomposed_ = false;
};

// Of the rows in the sum, the last behind the dependent one that can change places with it.
std::optional<std::size_t> last_behind(const DependentRow& d) {
  constexpr double kSound = 0.5;  // as a divisor
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < d.shares.size(); ++k) {
    if (d.shares[k].first < d.row || std::abs(d.shares[k].second) < kSound) continue;
    if (!last || d.shares[k].first > d.shares[*last].first) last = k;
  }
  return last;
}

// The same sum, for the row whose share is the k-th.
void change_places(DependentRow& d, std::size_t k) {
  const double share = d.shares[k].second;
  std::swap(d.row, d.shares[k].first);
  for (std::size_t i = 0; i < d.shares.size(); ++i) {
    d.shares[i].second = i == k ? 1 / share : -d.shares[i].second / share;
  }
  std::sort(d.shares.begin(), d.shares.end());
}

// Puts in the place of d.row, which was independent, what it is the sum of.
void substitute(const DependentRow& d, DependentRow& other) {
  const auto before = [](const auto& share, int row) { return share.first < row; };
  const auto in = std::lower_bound(other.shares.begin(), other.shares.end(), d.row, before);
  if (in == other.shares.end() || in->first != d.row) return;
  const double factor = in->second;
  other.shares.erase(in);
  std::vector<std::pair<int, double>> sum;
  sum.reserve(other.shares.size() + d.shares.size());
  auto own = other.shares.begin();
  for (const auto& [row, weight] : d.shares) {
    while (own != other.shares.end() && own->first < row) sum.push_back(*own++);
    const bool both = own != other.shares.end() && own->first == row;
    sum.emplace_back(row, (both ? own++->second : 0) + factor * weight);
  }
  sum.insert(sum.end(), own, other.shares.end());
  other.shares = std::move(sum);
}

// Where a dependent row can change places with a later one of its sum, it does: of rows that repeat
// each other, the first is to be kept.
void prefer_earlier(IndependentRows& found) {
  for (DependentRow& d : found.dependent) {
    if (d.distance > kDependent) continue;  // it is kept anyway
    const auto last = last_behind(d);
    if (!last) continue;
    std::replace(found.independent.begin(), found.independent.end(), d.shares[*last].first, d.row);
    change_places(d, *last);
    for (DependentRow& other : found.dependent) {
      if (&other != &d) substitute(d, other);
    }
  }
  std::sort(found.independent.begin(), found.independent.end());
  std::sort(found.dependent.begin(), found.dependent.end(),
            [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
}

// Those that are nearly dependent, by the rows that are now kept: their small difference would not
// survive that of a row from its sum. False where it could not be done.
bool express_again(const Rows& rows, const Context& context, IndependentRows& found) {
  const auto near = [](const DependentRow& d) { return d.distance > kDependent; };
  if (std::none_of(found.dependent.begin(), found.dependent.end(), near)) return true;
  const Basis basis(rows, found.independent, context);
  for (DependentRow& d : found.dependent) {
    if (!near(d)) continue;
    auto again = context.cancelled() ? std::nullopt : basis.express(d.row);
    if (!again) return false;
    d = std::move(*again);
  }
  return true;
}

// The dispensable rows that a row is expressed by, if it is not dispensable itself.
std::vector<int> in_the_way(const DependentRow& d, const RowChoice& choice) {
  std::vector<int> rows;
  if (choice.is_dispensable(d.row)) return rows;
  for (const auto& [row, share] : d.shares) {
    if (std::abs(share) > kNoShare && choice.is_dispensable(row)) rows.push_back(row);
  }
  return rows;
}

// False where that was not possible, or was not needed.
bool express_all(const Rows& rows, const std::vector<int>& suspects, const RowChoice& choice,
                 const Context& context, IndependentRows& found) {
  const Basis basis(rows, found.independent, context);
  for (const int row : suspects) {
    auto dependent = context.cancelled() ? std::nullopt : basis.express(row);
    if (!dependent) return false;
    found.dependent.push_back(*dependent);
    if (dependent->distance > kDependent) continue;
    if (const auto last = last_behind(*dependent)) change_places(*dependent, *last);
    if (choice.suffices(*dependent)) return false;
  }
  prefer_earlier(found);
  return express_again(rows, context, found);
}

// Of those that are nearly dependent the ones with something of their own are kept.
bool keep_near(const Rows& rows, const RowChoice& choice, const Context& context,
               IndependentRows& found) {
  const auto first = std::stable_partition(
      found.dependent.begin(), found.dependent.end(), [&](const DependentRow& d) {
        return d.distance <= kDependent || choice.is_dispensable(d.row);
      });
  const std::vector<DependentRow> near(first, found.dependent.end());
  found.dependent.erase(first, found.dependent.end());
  NearRows parts = near_rows(rows, near, context);
  found.near = std::move(parts.kept);
  for (DependentRow& d : parts.dropped) {
    if (choice.suffices(d)) return false;
    found.dependent.push_back(std::move(d));
  }
  return !context.cancelled();
}

// Those among `which`, ascending.
std::optional<IndependentRows> independent_among(const Rows& rows, const std::vector<int>& which,
                                                 const RowChoice& choice, const Context& context) {
  const Rows some = picked(rows, which);
  SparseCholesky factor;
  if (!factor.compute(products_of(some), kShift, context)) return std::nullopt;
  const Eigen::VectorXd pivots = factor.pivots();
  bool stopped = false;
  const RowChoice heard{[&](const DependentRow& d) {
                          return stopped = in_the_way(d, choice).empty() && choice.suffices(d);
                        },
                        choice.is_dispensable};
  for (const double least : kSuspect) {
    IndependentRows found;
    std::vector<int> suspects;
    for (int i = 0; i < static_cast<int>(which.size()); ++i) {
      (pivots[i] < least ? suspects : found.independent)
          .push_back(which[static_cast<std::size_t>(i)]);
    }
    if (express_all(rows, suspects, heard, context, found)) {
      if (!keep_near(rows, heard, context, found)) break;
      return found;
    }
    if (stopped || context.cancelled()) break;
  }
  return std::nullopt;
}

// As many rows as can be independent of each other.
std::size_t most_independent(const Rows& rows) {
  std::vector<unsigned char> used(static_cast<std::size_t>(rows.cols()), 0);
  for (Eigen::Index i = 0; i < rows.outerSize(); ++i) {
    for (Rows::InnerIterator k(rows, i); k; ++k) used[static_cast<std::size_t>(k.col())] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

// Those of `list`, ascending.
std::optional<IndependentRows> in_parts(const Rows& rows, const std::vector<int>& list,
                                        const RowChoice& choice, const Context& context) {
  IndependentRows found;
  const std::size_t part = std::max<std::size_t>(1, most_independent(rows));
  for (std::size_t begin = 0; begin < list.size(); begin += part) {
    std::vector<int> which = found.independent;
    for (const DependentRow& d : found.near) which.push_back(d.row);
    std::sort(which.begin(), which.end());
    for (std::size_t i = begin; i < std::min(list.size(), begin + part); ++i) {
      which.push_back(list[i]);
    }
    auto more = independent_among(rows, which, choice, context);
    if (!more) return std::nullopt;
    std::move(found.dependent.begin(), found.dependent.end(), std::back_inserter(more->dependent));
    found = std::move(*more);
  }
  return found;
}

// Dispensable rows that one which is not has been expressed by.
std::set<int> all_in_the_way(const IndependentRows& found, const RowChoice& choice) {
  std::set<int> rows;
  for (const auto* list : {&found.near, &found.dependent}) {
    for (const DependentRow& d : *list) {
      for (const int row : in_the_way(d, choice)) rows.insert(row);
    }
  }
  return rows;
}

// What the rows that were left out would have been.
bool express_left_out(const Rows& rows, const std::vector<int>& left_out, const Context& context,
                      IndependentRows& found) {
  if (left_out.empty()) return true;
  const Basis basis(rows, found.independent, context);
  for (const int row : left_out) {
    auto dependent = context.cancelled() ? std::nullopt : basis.express(row);
    if (!dependent) return false;
    found.dependent.push_back(std::move(*dependent));
  }
  return true;
}

}  // namespace

std::optional<IndependentRows> independent_rows(const Rows& rows, const RowChoice& choice,
                                                const Context& context) {
  std::vector<int> list(static_cast<std::size_t>(rows.rows()));
  std::iota(list.begin(), list.end(), 0);
  std::vector<int> left_out;
  std::optional<IndependentRows> found;
  while ((found = in_parts(rows, list, choice, context))) {
    const std::set<int> obstacles = all_in_the_way(*found, choice);
    if (obstacles.empty()) break;
    left_out.insert(left_out.end(), obstacles.begin(), obstacles.end());
    std::erase_if(list, [&](int row) { return obstacles.contains(row); });
  }
  if (!found || !express_left_out(rows, left_out, context, *found)) return std::nullopt;
  std::sort(found->dependent.begin(), found->dependent.end(),
            [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
  return found;
}

}  // namespace surpass

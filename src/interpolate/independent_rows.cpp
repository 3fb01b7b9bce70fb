#include "interpolate/independent_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "interpolate/near_rows.hpp"
#include "interpolate/row_basis.hpp"

namespace surpass {
namespace {

using Rows = RowMatrix;

// Squared distances: rows that are no closer to those before them are taken to be independent. The
// next holds where the one before left too few digits, which is seen soon.
constexpr std::array kSuspect = {1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1};

bool by_row(const DependentRow& a, const DependentRow& b) { return a.row < b.row; }

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
  std::sort(found.dependent.begin(), found.dependent.end(), by_row);
}

// Those that are nearly dependent, by the rows that are now kept: their small difference would not
// survive that of a row from its sum. False where it could not be done.
bool express_again(const Rows& rows, const Context& context, IndependentRows& found) {
  const auto near = [](const DependentRow& d) { return d.distance > kDependent; };
  if (std::none_of(found.dependent.begin(), found.dependent.end(), near)) return true;
  const RowBasis basis(rows, found.independent, context);
  for (DependentRow& d : found.dependent) {
    if (!near(d)) continue;
    auto again = context.cancelled() ? std::nullopt : basis.express(d.row);
    if (!again) return false;
    d = std::move(*again);
  }
  return true;
}

// False where that was not possible, or was not needed.
bool express_all(const Rows& rows, const std::vector<int>& suspects, const Suffices& suffices,
                 const Context& context, IndependentRows& found) {
  const RowBasis basis(rows, found.independent, context);
  for (const int row : suspects) {
    auto dependent = context.cancelled() ? std::nullopt : basis.express(row);
    if (!dependent) return false;
    found.dependent.push_back(*dependent);
    if (dependent->distance > kDependent) continue;
    if (const auto last = last_behind(*dependent)) change_places(*dependent, *last);
    if (suffices(*dependent)) return false;
  }
  prefer_earlier(found);
  return express_again(rows, context, found);
}

// Of those that are nearly dependent the ones with something of their own are kept.
bool keep_near(const Rows& rows, const Suffices& suffices, const Context& context,
               IndependentRows& found) {
  const auto first =
      std::stable_partition(found.dependent.begin(), found.dependent.end(),
                            [&](const DependentRow& d) { return d.distance <= kDependent; });
  const std::vector<DependentRow> near(first, found.dependent.end());
  found.dependent.erase(first, found.dependent.end());
  NearRows parts = near_rows(rows, near, context);
  found.near = std::move(parts.kept);
  for (DependentRow& d : parts.dropped) {
    if (suffices(d)) return false;
    found.dependent.push_back(std::move(d));
  }
  return !context.cancelled();
}

// Whether none of those that are kept depends on others after all: of shares so large that what
// kShift makes of them is not suspect, the first decomposition knows nothing.
bool stay_independent(const Rows& rows, const std::vector<int>& kept, const Context& context) {
  const Symmetric products = products_of(picked(rows, kept));
  SparseCholesky factor;
  return factor.compute(products, 0, context) && factor.is_accurate(products);
}

// Those among `which`, ascending.
std::optional<IndependentRows> independent_among(const Rows& rows, const std::vector<int>& which,
                                                 const Suffices& suffices, const Context& context) {
  const Rows some = picked(rows, which);
  const Symmetric products = products_of(some);
  SparseCholesky factor;
  if (!factor.compute(products, kShift, context)) return std::nullopt;
  const Eigen::VectorXd pivots = factor.pivots();
  // Where they are all independent it is seen here already.
  const bool far = factor.is_accurate(products);
  bool stopped = false;
  const Suffices heard = [&](const DependentRow& d) { return stopped = suffices(d); };
  std::optional<std::size_t> looked_at;
  for (const double least : kSuspect) {
    IndependentRows found;
    std::vector<int> suspects;
    for (int i = 0; i < static_cast<int>(which.size()); ++i) {
      (pivots[i] < least ? suspects : found.independent)
          .push_back(which[static_cast<std::size_t>(i)]);
    }
    if (looked_at == suspects.size()) continue;
    looked_at = suspects.size();
    if (express_all(rows, suspects, heard, context, found) &&
        (far || stay_independent(rows, found.independent, context))) {
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

}  // namespace

Rows pick_of(const IndependentRows& found, Eigen::Index rows) {
  std::vector<Eigen::Triplet<double>> picked;
  int place = 0;
  for (const int row : found.independent) picked.emplace_back(place++, row, 1);
  for (const DependentRow& d : found.near) {
    picked.emplace_back(place, d.row, 1 / d.distance);
    for (const auto& [other, share] : d.shares) {
      picked.emplace_back(place, other, -share / d.distance);
    }
    ++place;
  }
  Rows pick(place, rows);
  pick.setFromTriplets(picked.begin(), picked.end());
  return pick;
}

std::optional<IndependentRows> independent_rows(const Rows& rows, const std::vector<int>& list,
                                                const Suffices& suffices, const Context& context) {
  IndependentRows found;
  const std::size_t part = std::max<std::size_t>(1, most_independent(rows));
  for (std::size_t begin = 0; begin < list.size(); begin += part) {
    std::vector<int> which = found.independent;
    for (const DependentRow& d : found.near) which.push_back(d.row);
    std::sort(which.begin(), which.end());
    for (std::size_t i = begin; i < std::min(list.size(), begin + part); ++i) {
      which.push_back(list[i]);
    }
    auto more = independent_among(rows, which, suffices, context);
    if (!more) return std::nullopt;
    std::move(found.dependent.begin(), found.dependent.end(), std::back_inserter(more->dependent));
    found = std::move(*more);
  }
  std::sort(found.dependent.begin(), found.dependent.end(), by_row);
  return found;
}

}  // namespace surpass

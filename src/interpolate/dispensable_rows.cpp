#include "interpolate/dispensable_rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "interpolate/near_rows.hpp"
#include "interpolate/row_basis.hpp"

namespace surpass {
namespace {

RowMatrix stacked(const RowMatrix& above, const RowMatrix& below) {
  RowMatrix all(above.rows() + below.rows(), above.cols());
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [part, first] :
       {std::pair{&above, 0}, {&below, static_cast<int>(above.rows())}}) {
    for (Eigen::Index i = 0; i < part->outerSize(); ++i) {
      for (RowMatrix::InnerIterator k(*part, i); k; ++k) {
        entries.emplace_back(first + static_cast<int>(i), static_cast<int>(k.col()), k.value());
      }
    }
  }
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

constexpr double kLargestShare = 1e6;  // few digits are needed to know what is far

RowNumbers from_to(int begin, int end) {
  RowNumbers numbers(static_cast<std::size_t>(end - begin));
  std::iota(numbers.begin(), numbers.end(), begin);
  return numbers;
}

// Of the rows from `first` on, which are dispensable, those that may be near to the span of others,
// or others by them. Those before are independent, but may be near each other.
RowNumbers in_doubt(const RowMatrix& rows, int first, const Context& context) {
  const int count = static_cast<int>(rows.rows());
  SparseCholesky factor;
  if (!factor.compute(products_of(rows), kShift, context)) return from_to(first, count);
  const Eigen::VectorXd pivots = factor.pivots();
  RowNumbers near;
  RowNumbers others;
  for (int i = 0; i < count; ++i)
    (pivots[i] < kFarFromOthers * kFarFromOthers ? near : others).push_back(i);
  std::set<int> doubtful;
  const RowBasis basis(rows, others, context);
  for (const int row : near) {
    if (row >= first) doubtful.insert(row);
    const auto expressed = context.cancelled() ? std::nullopt : basis.express(row, kLargestShare);
    if (!expressed) return from_to(first, count);
    for (const auto& [other, share] : expressed->shares) {
      // With less of it the row would be no farther without it.
      const bool matters = std::abs(share) > std::max(kNoShare, expressed->distance);
      if (other >= first && matters) doubtful.insert(other);
    }
  }
  return {doubtful.begin(), doubtful.end()};
}

RowNumbers difference(const RowNumbers& all, const RowNumbers& without) {
  RowNumbers rest;
  std::set_difference(all.begin(), all.end(), without.begin(), without.end(),
                      std::back_inserter(rest));
  return rest;
}

// Of the rows from `first` on those that are far from the others that are kept.
RowNumbers far_rows(const RowMatrix& rows, int first, const Context& context) {
  const int count = static_cast<int>(rows.rows());
  const RowNumbers doubtful = in_doubt(rows, first, context);
  RowNumbers kept = difference(from_to(first, count), doubtful);
  if (doubtful.empty()) return kept;
  const RowNumbers sure = difference(from_to(0, count), doubtful);
  const RowBasis basis(rows, sure, context);
  std::vector<DependentRow> far;
  for (const int row : doubtful) {
    auto expressed = context.cancelled() ? std::nullopt : basis.express(row, kLargestShare);
    if (expressed && expressed->distance > kFarFromOthers) far.push_back(std::move(*expressed));
  }
  for (const DependentRow& d : near_rows(rows, far, context).kept) {
    if (d.distance > kFarFromOthers) kept.push_back(d.row);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace

void add_dispensable(const RowMatrix& rows, const RowNumbers& dispensable, const Context& context,
                     IndependentRows& found) {
  const RowMatrix needed = pick_of(found, rows.rows()) * rows;
  const int first = static_cast<int>(needed.rows());
  RowNumbers kept = far_rows(stacked(needed, picked(rows, dispensable)), first, context);
  for (int& row : kept) row = dispensable[static_cast<std::size_t>(row - first)];
  found.independent.insert(found.independent.end(), kept.begin(), kept.end());
  std::sort(found.independent.begin(), found.independent.end());
  const RowNumbers others = difference(dispensable, kept);
  if (others.empty()) return;
  const RowBasis basis(rows, found.independent, context);
  for (const int row : others) {
    auto dependent = context.cancelled() ? std::nullopt : basis.express(row);
    found.dependent.push_back(dependent ? std::move(*dependent) : DependentRow{row, 1, {}});
  }
}

}  // namespace surpass

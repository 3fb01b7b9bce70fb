#include "interpolate/dispensable_rows.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
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

// Whether no row is near to those that are decomposed before it.
bool are_far_apart(const RowMatrix& rows, double least, const Context& context) {
  SparseCholesky factor;
  return factor.compute(products_of(rows), kShift, context) &&
         (factor.pivots().array() >= least * least).all();
}

// Those of `rest` that are far from all that is kept, and from each other.
std::vector<int> independent_of(const IndependentRows& found, const RowMatrix& rows,
                                const std::vector<int>& rest, const Context& context) {
  // Of the length of a row. For the sake of a nearer one a surface would go farther than it asks by
  // the inverse.
  constexpr double kFar = 0.03;
  constexpr double kLargest = 1e6;  // few digits are needed to know what is far
  const RowMatrix kept = pick_of(found, rows.rows()) * rows;
  const RowMatrix all = stacked(kept, picked(rows, rest));
  if (all.rows() <= all.cols() && are_far_apart(all, kFar, context)) return rest;
  std::vector<int> needed(static_cast<std::size_t>(kept.rows()));
  std::iota(needed.begin(), needed.end(), 0);
  const RowBasis basis(all, needed, context);
  std::vector<DependentRow> far;
  for (int row = static_cast<int>(kept.rows()); row < all.rows(); ++row) {
    auto expressed = context.cancelled() ? std::nullopt : basis.express(row, kLargest);
    if (expressed && expressed->distance > kFar) far.push_back(std::move(*expressed));
  }
  std::vector<int> independent;
  for (const DependentRow& d : near_rows(all, far, context).kept) {
    if (d.distance > kFar)
      independent.push_back(rest[static_cast<std::size_t>(d.row) - needed.size()]);
  }
  std::sort(independent.begin(), independent.end());
  return independent;
}

}  // namespace

void add_dispensable(const RowMatrix& rows, const std::vector<int>& dispensable,
                     const Context& context, IndependentRows& found) {
  const std::vector<int> kept = independent_of(found, rows, dispensable, context);
  found.independent.insert(found.independent.end(), kept.begin(), kept.end());
  std::sort(found.independent.begin(), found.independent.end());
  std::vector<int> others;
  std::set_difference(dispensable.begin(), dispensable.end(), kept.begin(), kept.end(),
                      std::back_inserter(others));
  if (others.empty()) return;
  const RowBasis basis(rows, found.independent, context);
  for (const int row : others) {
    auto dependent = context.cancelled() ? std::nullopt : basis.express(row);
    found.dependent.push_back(dependent ? std::move(*dependent) : DependentRow{row, 1, {}});
  }
}

}  // namespace surpass

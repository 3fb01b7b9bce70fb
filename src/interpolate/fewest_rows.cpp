#include "interpolate/fewest_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "interpolate/row_basis.hpp"

namespace surpass {
namespace {

std::vector<int> by_share(const DependentRow& d) {
  auto shares = d.shares;
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) > std::abs(b.second);
  });
  std::vector<int> rows;
  rows.reserve(shares.size());
  for (const auto& [row, share] : shares) rows.push_back(row);
  return rows;
}

std::vector<int> without(const std::vector<int>& rows, std::size_t begin, std::size_t count) {
  std::vector<int> rest(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(begin));
  const std::size_t end = std::min(rows.size(), begin + count);
  rest.insert(rest.end(), rows.begin() + static_cast<std::ptrdiff_t>(end), rows.end());
  return rest;
}

}  // namespace

DependentRow by_fewest_rows(const RowMatrix& rows, const DependentRow& d, const Suffices& suffices,
                            const Context& context) {
  const auto expressed_by = [&](std::vector<int> some) -> std::optional<DependentRow> {
    std::sort(some.begin(), some.end());
    if (context.cancelled()) return std::nullopt;
    auto expressed = RowBasis(rows, some, context).express(d.row);
    if (expressed && suffices(*expressed)) return expressed;
    return std::nullopt;
  };
  const std::vector<int> all = by_share(d);
  std::vector<int> some;
  std::optional<DependentRow> found;
  for (std::size_t count = 1; !found; count *= 2) {
    some.assign(all.begin(),
                all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size())));
    found = expressed_by(some);
    if (!found && some.size() == all.size()) return d;
  }
  for (std::size_t part = (some.size() + 1) / 2; part > 0; part /= 2) {
    for (std::size_t begin = 0; begin < some.size();) {
      const std::vector<int> fewer = without(some, begin, part);
      if (auto better = expressed_by(fewer)) {
        found = std::move(better);
        some = fewer;
      } else {
        begin += part;
      }
    }
  }
  return *found;
}

}  // namespace surpass

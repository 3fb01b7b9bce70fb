#include "interpolate/fewest_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "interpolate/leave_out.hpp"
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
  (void)leave_out(some, [&](std::vector<int> fewer) -> std::optional<std::vector<int>> {
    auto better = expressed_by(fewer);
    if (!better) return std::nullopt;
    found = std::move(better);
    return fewer;
  });
  return *found;
}

}  // namespace surpass

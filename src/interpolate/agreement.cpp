#include "interpolate/agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "interpolate/balanced_values.hpp"
#include "interpolate/contradiction.hpp"
#include "interpolate/dispensable_rows.hpp"
#include "interpolate/requirement_places.hpp"

namespace surpass {

Agreement::Agreement(const FreeEquations& equations, const RequirementRows& rows,
                     std::span<const Requirement> requirements, const FreeSystem& system,
                     std::span<const double> targets, const ConstraintUnits& units)
    : equations_(equations),
      requirements_(requirements),
      context_(system.context),
      check_(equations, rows, system, targets, units) {}

void Agreement::take_all() {
  found_.independent.resize(static_cast<std::size_t>(equations_.factor.size()));
  std::iota(found_.independent.begin(), found_.independent.end(), 0);
}

Result<void> Agreement::check_fixed() const {
  for (int row = 0; row < equations_.factor.size(); ++row) {
    const std::size_t number = check_.requirement_of(row);
    if (!(std::abs(equations_.in_units[row]) <= kFarthest)) {
      return refuse_requirement(requirements_[number], number, kTooLarge, ErrorCode::not_finite);
    }
    const double missed = check_.is_chosen(row) ? 0 : check_.fixed_missed(row);
    if (missed > 0) return contradiction(std::array{number}, missed, requirements_);
  }
  return {};
}

Result<void> Agreement::choose() {
  const RowMatrix scaled = equations_.factor.asDiagonal() * equations_.free;
  RowNumbers needed;
  RowNumbers chosen;
  for (int row = 0; row < scaled.rows(); ++row) {
    (check_.is_chosen(row) ? chosen : needed).push_back(row);
  }
  auto [independent, other] = check_.look_at(scaled, needed);
  if (context_.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  if (other) return contradiction_of(*other, check_, scaled, requirements_, context_);
  if (!independent) return not_told_apart();
  found_ = std::move(*independent);
  if (!chosen.empty()) add_dispensable(scaled, chosen, context_, found_);
  constexpr double kMatters = 1e-6;
  for (const DependentRow& d : found_.dependent) {
    if (!check_.is_chosen(d.row) || !check_.is_missed(d)) continue;
    for (const auto& [row, share] : d.shares) {
      if (std::abs(share) > kMatters) opposed_.insert(check_.requirement_of(row));
    }
  }
  return {};
}

FreeEquations::Rows Agreement::picked_rows() const {
  return pick_of(found_, equations_.factor.size()) * equations_.factor.asDiagonal();
}

Eigen::VectorXd Agreement::values() const {
  constexpr double kMatters = 0.1;  // of what is allowed
  const auto is_dropped = [&](const DependentRow& d) {
    return !check_.is_chosen(d.row) && equations_.factor[d.row] != 0;
  };
  const auto& dependent = found_.dependent;
  if (std::none_of(dependent.begin(), dependent.end(), [&](const DependentRow& d) {
        return is_dropped(d) && check_.missed_by(d) > kMatters * check_.holds();
      })) {
    return equations_.in_units;
  }
  std::vector<DependentRow> dropped;
  std::copy_if(dependent.begin(), dependent.end(), std::back_inserter(dropped), is_dropped);
  const Eigen::VectorXd wanted = check_.missed().cwiseProduct(equations_.factor);
  const Eigen::VectorXd balanced = balanced_values(dropped, wanted, context_);
  Eigen::VectorXd values = equations_.in_units;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (equations_.factor[i] != 0) values[i] += (balanced[i] - wanted[i]) / equations_.factor[i];
  }
  return values;
}

RowFates Agreement::fates() const {
  RowFates fates{std::vector<unsigned char>(requirements_.size(), 0),
                 std::vector<unsigned char>(requirements_.size(), 0), opposed_};
  for (int row = 0; row < equations_.factor.size(); ++row) {
    fates.redundant[check_.requirement_of(row)] = 1;
  }
  const auto take = [&](int row) {
    const std::size_t number = check_.requirement_of(row);
    if (check_.is_chosen(row)) {
      fates.with_lengths[number] = 1;
    } else {
      fates.redundant[number] = 0;
    }
  };
  for (const int row : found_.independent) take(row);
  for (const DependentRow& d : found_.near) take(d.row);
  return fates;
}

}  // namespace surpass

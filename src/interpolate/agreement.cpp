#include "interpolate/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "interpolate/balanced_values.hpp"
#include "interpolate/dispensable_rows.hpp"
#include "interpolate/fewest_rows.hpp"
#include "interpolate/requirement_places.hpp"

namespace surpass {
namespace {

// In box sides: how far from the origin of the solve surfaces are taken to be.
constexpr double kReach = 3;

// `amount`: in units of the box side.
tl::unexpected<Error> contradiction(const std::set<std::size_t>& numbers, double amount,
                                    std::span<const Requirement> requirements) {
  const std::vector<std::size_t> all(numbers.begin(), numbers.end());
  const std::string what =
      all.size() == 1
          ? fmt::format("requirement {} contradicts itself or the given vertices",
                        names_of(all, requirements))
          : fmt::format("requirements contradict each other: {}", names_of(all, requirements));
  const Requirement& r = requirements[all.front()];
  const bool at_vertex = all.size() == 1 && r.kind == Requirement::Kind::position &&
                         r.vertex == kNone && corner_at(r.place) != kNone;
  return fail(ErrorCode::contradictory,
              fmt::format("{}; {} by {:.3g} of the box side{}", what,
                          all.size() == 1 ? "it misses" : "together they miss", amount,
                          at_vertex ? "; a given vertex lies there, which a position at the vertex "
                                      "moves"
                                    : ""),
              place_of(r));
}

}  // namespace

Agreement::Agreement(const FreeEquations& equations, const RequirementRows& rows,
                     std::span<const Requirement> requirements, const FreeSystem& system,
                     std::span<const double> targets, const ConstraintUnits& units)
    : equations_(equations),
      rows_(rows),
      requirements_(requirements),
      system_(system),
      side_(units.side * units.scale),
      rounding_(units.rounding),
      holds_(std::max(kRequirementTolerance, units.rounding)) {
  std::vector<double> fixed(system.size(), 0.0);
  system.elimination.meet(system.context, 3, targets, fixed);
  missed_ = equations.in_units -
            equations.all * Eigen::Map<const Eigen::VectorXd>(
                                fixed.data(), static_cast<Eigen::Index>(fixed.size()));
}

void Agreement::take_all() {
  found_.independent.resize(rows_.rows.size());
  std::iota(found_.independent.begin(), found_.independent.end(), 0);
}

Result<void> Agreement::check_fixed() const {
  for (Eigen::Index i = 0; i < equations_.factor.size(); ++i) {
    const double missed = std::abs(missed_[i]) / side_;
    const int row = static_cast<int>(i);
    if (!(std::abs(equations_.in_units[i]) <= kFarthest)) {
      const std::size_t number = requirement_of(row);
      return refuse_requirement(requirements_[number], number, kTooLarge, ErrorCode::not_finite);
    }
    if (equations_.factor[i] != 0 || is_chosen(row)) continue;
    if (missed > holds_ + kReach * equations_.free.row(i).norm()) {
      return contradiction({requirement_of(row)}, missed, requirements_);
    }
  }
  return {};
}

Result<void> Agreement::choose() {
  scaled_ = equations_.factor.asDiagonal() * equations_.free;
  std::vector<int> needed;
  std::vector<int> chosen;
  for (int row = 0; row < scaled_.rows(); ++row) (is_chosen(row) ? chosen : needed).push_back(row);
  std::optional<DependentRow> other;
  auto found = consistent_rows(needed, other);
  if (system_.context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  if (other) return contradicts(*other);
  if (!found) return not_told_apart();
  found_ = std::move(*found);
  if (chosen.empty()) return {};
  add_dispensable(scaled_, chosen, system_.context, found_);
  constexpr double kMatters = 1e-6;
  for (const DependentRow& d : found_.dependent) {
    if (is_chosen(d.row) && is_missed(d)) opposed_.merge(partners(d, kMatters));
  }
  return {};
}

// Which of them are independent, if none contradicts others; if one does it is `other`.
std::optional<IndependentRows> Agreement::consistent_rows(
    const RowNumbers& rows, std::optional<DependentRow>& other) const {
  const Suffices suffices = [&](const DependentRow& d) {
    if (surely_contradicts(d)) other = d;
    return other.has_value();
  };
  auto found = independent_rows(scaled_, rows, suffices, system_.context);
  if (!found) return found;
  const auto missed = std::find_if(found->dependent.begin(), found->dependent.end(),
                                   [&](const DependentRow& d) { return is_missed(d); });
  if (missed == found->dependent.end()) return found;
  other = *missed;
  return std::nullopt;
}

// By how much of the box side it is missed where those hold that it is a sum of.
double Agreement::missed_by(const DependentRow& d) const {
  const auto wanted = [&](int row) { return equations_.factor[row] * missed_[row]; };
  double rest = wanted(d.row);
  for (const auto& [other, share] : d.shares) rest -= share * wanted(other);
  return std::abs(rest) / equations_.factor[d.row] / side_;
}

// How much of what others are missed by it is missed by.
double Agreement::weight_of(const DependentRow& d) const {
  double weight = 0;
  for (const auto& [other, share] : d.shares) weight += std::abs(share) * equations_.factor[other];
  return weight / equations_.factor[d.row];
}

// By how much it may be missed for what is left of it apart from its sum, of which it is not known
// what the surface makes, and for numbers that were rounded before they came here.
double Agreement::allowed_to(const DependentRow& d) const {
  return holds_ + kReach * d.distance / equations_.factor[d.row] + rounding_ * weight_of(d);
}

// Whether it is missed even if all others are, too, by as much as is allowed.
bool Agreement::surely_contradicts(const DependentRow& d) const {
  if (equations_.factor[d.row] == 0) return false;
  return missed_by(d) > allowed_to(d) + holds_ * weight_of(d);
}

bool Agreement::is_missed(const DependentRow& d) const {
  return equations_.factor[d.row] != 0 && missed_by(d) > allowed_to(d);
}

std::set<std::size_t> Agreement::partners(const DependentRow& d, double least) const {
  std::set<std::size_t> others;
  for (const auto& [other, share] : d.shares) {
    if (std::abs(share) > least) others.insert(requirement_of(other));
  }
  return others;
}

// By as few others as say something else.
DependentRow Agreement::shortest(const DependentRow& d) const {
  const Suffices contradicts = [&](const DependentRow& e) {
    return e.distance <= kDependent && is_missed(e);
  };
  return by_fewest_rows(scaled_, d, contradicts, system_.context);
}

std::set<std::size_t> Agreement::taking_part(const DependentRow& d) const {
  std::set<std::size_t> all = partners(d, 0);
  all.insert(requirement_of(d.row));
  return all;
}

// Where one can be left out because the others contradict each other by other equations of theirs,
// it is.
DependentRow Agreement::by_fewest_requirements(DependentRow d) const {
  constexpr std::size_t kMostTries = 100;  // each is a decomposition
  std::set<std::size_t> needed;
  for (bool fewer = true; fewer;) {
    fewer = false;
    for (const std::size_t number : taking_part(d)) {
      if (needed.contains(number) || needed.size() == kMostTries) continue;
      std::set<std::size_t> rest = taking_part(d);
      rest.erase(number);
      std::optional<DependentRow> other;
      (void)consistent_rows(rows_of(rest), other);
      if (other) {
        d = shortest(*other);
        fewer = true;
        break;
      }
      needed.insert(number);
    }
  }
  return d;
}

RowNumbers Agreement::rows_of(const std::set<std::size_t>& numbers) const {
  RowNumbers rows;
  for (int row = 0; row < scaled_.rows(); ++row) {
    if (!is_chosen(row) && numbers.contains(requirement_of(row))) rows.push_back(row);
  }
  return rows;
}

tl::unexpected<Error> Agreement::contradicts(const DependentRow& d) const {
  const DependentRow few = by_fewest_requirements(shortest(d));
  return contradiction(taking_part(few), missed_by(few), requirements_);
}

FreeEquations::Rows Agreement::picked_rows() const {
  return pick_of(found_, equations_.factor.size()) * equations_.factor.asDiagonal();
}

Eigen::VectorXd Agreement::values() const {
  constexpr double kMatters = 0.1;  // of what is allowed
  std::vector<DependentRow> dropped;
  bool matters = false;
  for (const DependentRow& d : found_.dependent) {
    if (is_chosen(d.row) || equations_.factor[d.row] == 0) continue;
    dropped.push_back(d);
    matters = matters || missed_by(d) > kMatters * holds_;
  }
  if (!matters) return equations_.in_units;
  const Eigen::VectorXd wanted = missed_.cwiseProduct(equations_.factor);
  const Eigen::VectorXd balanced = balanced_values(dropped, wanted, system_.context);
  Eigen::VectorXd values = equations_.in_units;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (equations_.factor[i] != 0) values[i] += (balanced[i] - wanted[i]) / equations_.factor[i];
  }
  return values;
}

std::vector<unsigned char> Agreement::redundant() const {
  std::vector<unsigned char> redundant(requirements_.size(), 0);
  for (const RequirementRow& row : rows_.rows) redundant[row.requirement] = 1;
  const auto is_needed = [&](int row) {
    if (!is_chosen(row)) redundant[requirement_of(row)] = 0;
  };
  for (const int row : found_.independent) is_needed(row);
  for (const DependentRow& d : found_.near) is_needed(d.row);
  return redundant;
}

std::vector<unsigned char> Agreement::with_lengths() const {
  std::vector<unsigned char> with(requirements_.size(), 0);
  for (const int row : found_.independent) {
    if (is_chosen(row)) with[requirement_of(row)] = 1;
  }
  return with;
}

tl::unexpected<Error> not_told_apart() {
  return fail(ErrorCode::contradictory,
              "the requirements are too nearly dependent to be told apart; leave some of them out");
}

}  // namespace surpass

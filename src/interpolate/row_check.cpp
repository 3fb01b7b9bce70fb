#include "interpolate/row_check.hpp"

#include <algorithm>
#include <cmath>

namespace surpass {
namespace {

// In box sides: how far from the origin of the solve surfaces are taken to be.
constexpr double kReach = 3;

}  // namespace

RowCheck::RowCheck(const FreeEquations& equations, const RequirementRows& rows,
                   const FreeSystem& system, std::span<const double> targets,
                   const ConstraintUnits& units)
    : equations_(equations),
      rows_(rows),
      context_(system.context),
      side_(units.side * units.scale),
      rounding_(units.rounding),
      holds_(std::max(kRequirementTolerance, units.rounding)) {
  std::vector<double> fixed(system.size(), 0.0);
  system.elimination.meet(system.context, 3, targets, fixed);
  missed_ = equations.in_units -
            equations.all * Eigen::Map<const Eigen::VectorXd>(
                                fixed.data(), static_cast<Eigen::Index>(fixed.size()));
}

double RowCheck::fixed_missed(int row) const {
  if (equations_.factor[row] != 0) return 0;
  const double missed = std::abs(missed_[row]) / side_;
  return missed > holds_ + kReach * equations_.free.row(row).norm() ? missed : 0;
}

double RowCheck::missed_by(const DependentRow& d) const {
  const auto wanted = [&](int row) { return equations_.factor[row] * missed_[row]; };
  double rest = wanted(d.row);
  for (const auto& [other, share] : d.shares) rest -= share * wanted(other);
  return std::abs(rest) / equations_.factor[d.row] / side_;
}

// How much of what others are missed by it is missed by.
double RowCheck::weight_of(const DependentRow& d) const {
  double weight = 0;
  for (const auto& [other, share] : d.shares) weight += std::abs(share) * equations_.factor[other];
  return weight / equations_.factor[d.row];
}

// By how much it may be missed for what is left of it apart from its sum, of which it is not known
// what the surface makes, and for numbers that were rounded before they came here.
double RowCheck::allowed_to(const DependentRow& d) const {
  return holds_ + kReach * d.distance / equations_.factor[d.row] + rounding_ * weight_of(d);
}

bool RowCheck::is_missed(const DependentRow& d) const {
  return equations_.factor[d.row] != 0 && missed_by(d) > allowed_to(d);
}

// Whether it is missed even if all others are, too, by as much as is allowed.
bool RowCheck::surely_contradicts(const DependentRow& d) const {
  return equations_.factor[d.row] != 0 && missed_by(d) > allowed_to(d) + holds_ * weight_of(d);
}

RowCheck::Look RowCheck::look_at(const RowMatrix& scaled, const RowNumbers& rows) const {
  Look look;
  const Suffices suffices = [&](const DependentRow& d) {
    if (surely_contradicts(d)) look.contradicts = d;
    return look.contradicts.has_value();
  };
  auto found = independent_rows(scaled, rows, suffices, context_);
  if (!found) return look;
  const auto missed = std::find_if(found->dependent.begin(), found->dependent.end(),
                                   [&](const DependentRow& d) { return is_missed(d); });
  if (missed == found->dependent.end()) {
    look.independent = std::move(found);
  } else {
    look.contradicts = std::move(*missed);
  }
  return look;
}

}  // namespace surpass

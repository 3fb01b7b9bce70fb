// Which equations of requirements are solved for: whether they agree with each other and with the
// given vertices, and which of them say it all.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "interpolate/row_check.hpp"

namespace surpass {

/// What became of the requirements' equations.
struct RowFates {
  std::vector<unsigned char> redundant;     ///< #requirements: 1 where none was taken
  std::vector<unsigned char> with_lengths;  ///< 1 where a chosen one was (RequirementRow::chosen)
  std::set<std::size_t> opposed;            ///< requirements that left no room to chosen ones
};

/// All that is passed must outlive it.
class Agreement {
 public:
  /// `targets`: of the given vertices in the units of the solve, #given by 3.
  Agreement(const FreeEquations& equations, const RequirementRows& rows,
            std::span<const Requirement> requirements, const FreeSystem& system,
            std::span<const double> targets, const ConstraintUnits& units);

  /// Fails with `not_finite` if values are too large to be computed with, and with `contradictory`
  /// if an equation of which free points say nothing does not hold.
  [[nodiscard]] Result<void> check_fixed() const;

  /// Takes it that none depends on others, which is nearly always so.
  void take_all();

  /// Finds those that do not, once it is sure that the others agree with them. Fails as
  /// LinearConstraints::build does. The cost is that of independent_rows().
  [[nodiscard]] Result<void> choose();

  /// The equations to solve for, as sums of all. What a nearly dependent one has of its own takes
  /// its place, at full length.
  [[nodiscard]] FreeEquations::Rows picked_rows() const;

  /// What all equations are to be, in the units of the solve: made to agree where dropped ones
  /// would be missed by rounding.
  [[nodiscard]] Eigen::VectorXd values() const;

  [[nodiscard]] RowFates fates() const;

 private:
  const FreeEquations& equations_;
  std::span<const Requirement> requirements_;
  const Context& context_;
  RowCheck check_;
  IndependentRows found_;
  std::set<std::size_t> opposed_;
};

}  // namespace surpass

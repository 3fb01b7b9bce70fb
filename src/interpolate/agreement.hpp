// Whether equations agree with each other and with the given vertices, and which of them say it
// all.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "interpolate/free_equations.hpp"
#include "interpolate/free_system.hpp"
#include "interpolate/independent_rows.hpp"

namespace surpass {

/// Of the requirements' equations. All that is passed must outlive it.
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

  /// #requirements: 1 where none of its equations was taken.
  [[nodiscard]] std::vector<unsigned char> redundant() const;

  /// #requirements: 1 where an equation that was chosen for it was taken.
  [[nodiscard]] std::vector<unsigned char> with_lengths() const;

  /// Requirements whose equations left no room to chosen ones (RequirementRow::chosen).
  [[nodiscard]] const std::set<std::size_t>& opposed() const { return opposed_; }

 private:
  [[nodiscard]] std::size_t requirement_of(int row) const {
    return rows_.rows[static_cast<std::size_t>(row)].requirement;
  }
  [[nodiscard]] bool is_chosen(int row) const {
    return rows_.rows[static_cast<std::size_t>(row)].chosen;
  }
  [[nodiscard]] double missed_by(const DependentRow& d) const;
  [[nodiscard]] double weight_of(const DependentRow& d) const;
  [[nodiscard]] double allowed_to(const DependentRow& d) const;
  [[nodiscard]] bool surely_contradicts(const DependentRow& d) const;
  [[nodiscard]] bool is_missed(const DependentRow& d) const;
  [[nodiscard]] std::optional<IndependentRows> consistent_rows(
      const RowNumbers& rows, std::optional<DependentRow>& other) const;
  [[nodiscard]] std::set<std::size_t> partners(const DependentRow& d, double least) const;
  [[nodiscard]] std::set<std::size_t> taking_part(const DependentRow& d) const;
  [[nodiscard]] DependentRow shortest(const DependentRow& d) const;
  [[nodiscard]] DependentRow by_fewest_requirements(DependentRow d) const;
  [[nodiscard]] RowNumbers rows_of(const std::set<std::size_t>& numbers) const;
  [[nodiscard]] tl::unexpected<Error> contradicts(const DependentRow& d) const;

  const FreeEquations& equations_;
  const RequirementRows& rows_;
  std::span<const Requirement> requirements_;
  const FreeSystem& system_;
  double side_;                 // of the box, in the units of the solve
  double rounding_;             // relative to it
  double holds_;                // relative to it: dropped equations must hold to this
  Eigen::VectorXd missed_;      // by each, in the units of the solve, where all free points are 0
  FreeEquations::Rows scaled_;  // to length 1, once choose() was called
  IndependentRows found_;
  std::set<std::size_t> opposed_;
};

/// `contradictory`, for equations that only rounding tells apart.
[[nodiscard]] tl::unexpected<Error> not_told_apart();

}  // namespace surpass

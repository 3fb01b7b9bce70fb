// Whether equations that follow from others say what these do.
#pragma once

#include <optional>
#include <span>

#include "interpolate/free_equations.hpp"
#include "interpolate/free_system.hpp"
#include "interpolate/independent_rows.hpp"

namespace surpass {

/// Of the requirements' equations, and what the given vertices leave of their values. Amounts are
/// relative to the box side. All that is passed must outlive it.
class RowCheck {
 public:
  /// `targets`: of the given vertices in the units of the solve, #given by 3.
  RowCheck(const FreeEquations& equations, const RequirementRows& rows, const FreeSystem& system,
           std::span<const double> targets, const ConstraintUnits& units);

  [[nodiscard]] std::size_t requirement_of(int row) const {
    return rows_.rows[static_cast<std::size_t>(row)].requirement;
  }
  [[nodiscard]] bool is_chosen(int row) const {
    return rows_.rows[static_cast<std::size_t>(row)].chosen;
  }

  /// What each is missed by where all free points are 0, in the units of the solve.
  [[nodiscard]] const Eigen::VectorXd& missed() const { return missed_; }

  /// To this equations must hold that are dropped: kRequirementTolerance, or what rounding did to
  /// the given points where that is more.
  [[nodiscard]] double holds() const { return holds_; }

  /// By how much an equation of which free points say next to nothing does not hold; 0 if it does.
  [[nodiscard]] double fixed_missed(int row) const;

  /// By how much it is missed where those hold that it is a sum of.
  [[nodiscard]] double missed_by(const DependentRow& d) const;

  /// Whether that is more than is allowed to rounding and to what is left of it apart from the sum.
  [[nodiscard]] bool is_missed(const DependentRow& d) const;

  /// Neither where independent_rows() found nothing.
  struct Look {
    std::optional<IndependentRows> independent;  ///< where none contradicts others
    std::optional<DependentRow> contradicts;
  };
  /// Which of these rows, of length 1, are independent, if they say the same.
  [[nodiscard]] Look look_at(const RowMatrix& scaled, const RowNumbers& rows) const;

 private:
  [[nodiscard]] double weight_of(const DependentRow& d) const;
  [[nodiscard]] double allowed_to(const DependentRow& d) const;
  [[nodiscard]] bool surely_contradicts(const DependentRow& d) const;

  const FreeEquations& equations_;
  const RequirementRows& rows_;
  const Context& context_;
  double side_;  // of the box, in the units of the solve
  double rounding_;
  double holds_;
  Eigen::VectorXd missed_;
};

}  // namespace surpass

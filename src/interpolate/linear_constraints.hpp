// Further linear equations of the control points, beside those of the given vertices: rid of what
// repeats or contradicts, and kept to while an energy is made small.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "interpolate/agreement.hpp"
#include "interpolate/free_preconditioner.hpp"

namespace surpass {

/// Numbers of control points are #control by 3. Equations that follow from others are dropped.
class LinearConstraints {
 public:
  struct Contents;  // for its own file

  /// Fails with `contradictory` if equations contradict each other or the given vertices, naming
  /// the requirements, and where only rounding tells equations apart; with `not_finite` if values
  /// are too large to be computed with; with `cancelled`. Of those that nearly
  /// depend on others only what they have of their own is solved for, at full length; of chosen
  /// ones nothing. `targets` are those of the given vertices in the units, #given by 3. Cost: a
  /// sparse Cholesky decomposition of the equations' products, and that of independent_rows() where
  /// some depend on others, or nearly. The elimination must outlive it.
  static Result<LinearConstraints> build(const RequirementRows& rows,
                                         std::span<const Requirement> requirements,
                                         const FreeSystem& system, std::span<const double> targets,
                                         const ConstraintUnits& units);
  LinearConstraints(LinearConstraints&&) noexcept;
  LinearConstraints& operator=(LinearConstraints&&) noexcept;
  LinearConstraints(const LinearConstraints&) = delete;
  LinearConstraints& operator=(const LinearConstraints&) = delete;
  ~LinearConstraints();

  /// Takes from a gradient what the equations forbid to follow: the preconditioned rest changes
  /// none of them.
  void clear(std::span<double> gradient) const;

  /// Takes from a change of the free points, the least by the preconditioner, what alters the
  /// equations; the transpose of clear().
  void keep(std::span<double> change) const;

  /// The least change, by the preconditioner, after which the equations hold; the limits of the
  /// given vertices stay. x is in the units of the solve.
  void meet(const Context& context, std::span<double> x) const;

  /// Which of the equations were taken.
  [[nodiscard]] const RowFates& fates() const;

 private:
  explicit LinearConstraints(std::unique_ptr<Contents> contents);
  std::unique_ptr<Contents> contents_;
};

}  // namespace surpass

// Requirements' equations as matrices over control points, and over those that are free.
#pragma once

#include <span>

#include <Eigen/SparseCore>

#include "interpolate/elimination.hpp"
#include "interpolate/requirement_rows.hpp"

namespace surpass {

/// `origin` and `scale` take control points p to (p - origin) * scale, the units of the solve.
struct ConstraintUnits {
  Point origin;
  double scale;
  double side;      ///< of the given points' box, which what is missed is relative to
  double rounding;  ///< of the given coordinates, relative to the side
};

/// #equations rows; columns are the numbers of control points, #control by 3.
struct FreeEquations {
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  Rows all;                  ///< over all control points
  Rows free;                 ///< over the free ones, after elimination
  Eigen::VectorXd in_units;  ///< what the equations are to be, in the units of the solve
  Eigen::VectorXd factor;    ///< makes rows of `all` as long as 1; 0 where free points say nothing
};

[[nodiscard]] FreeEquations free_equations(const RequirementRows& equations,
                                           std::span<const Requirement> requirements,
                                           const Elimination& elimination,
                                           const ConstraintUnits& units);

}  // namespace surpass

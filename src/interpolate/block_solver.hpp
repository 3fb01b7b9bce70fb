// Solves one block of unknowns with the chosen solver, and knows what to do where it fails.
#pragma once

#include <string>
#include <vector>

#include "interpolate/solvers.hpp"

namespace surpass {

/// One set of right-hand sides: where it comes from, in which unit its errors are, and the result.
struct Task {
  std::span<const double> target;  ///< #V by width
  std::size_t width;
  double unit;
  double tolerance;     ///< relative to unit
  std::span<double> x;  ///< #V by width; enters holding the known values outside the block
};

struct BlockOutcome {
  bool converged = true;
  Iteration first = {};  ///< of the target
  Iteration final = {};
  std::vector<Iteration> history = {};
  Solver solver = Solver::automatic;  ///< that was used; automatic if there was nothing to solve
};

/// `notes` receives sentences for the user. Errors: cancelled, singular.
Result<BlockOutcome> solve_block(const InterpolateOptions& options, const LimitOperator& op,
                                 const Block& block, const Task& task, std::string_view stage,
                                 const Context& context, std::vector<std::string>& notes);

}  // namespace surpass

// The solve of one set of right-hand sides in its stages: curves, then the surface's blocks.
#pragma once

#include <surpass/topology.hpp>

#include <string>
#include <vector>

#include "interpolate/block_solver.hpp"
#include "interpolate/singular_parts.hpp"

namespace surpass {

/// Everything about a topology that its solves share.
struct Prepared {
  InterpolateOptions options;
  LimitOperator op;
  std::vector<unsigned char> listed;  ///< #V: 1 for those to be met
  Blocks blocks;
  std::vector<SingularPart> singular;
  Components components;  ///< filled where some part is singular
};

/// What became of the stages.
struct Solved {
  BlockOutcome curve;
  std::vector<BlockOutcome> surface;  ///< parallel to Blocks::surface

  [[nodiscard]] bool converged() const {
    return curve.converged && std::all_of(surface.begin(), surface.end(),
                                          [](const BlockOutcome& o) { return o.converged; });
  }
  /// The surface block that took longest.
  [[nodiscard]] const BlockOutcome* longest() const {
    const auto at = std::max_element(
        surface.begin(), surface.end(),
        [](const auto& a, const auto& b) { return a.final.iteration < b.final.iteration; });
    return at == surface.end() ? nullptr : &*at;
  }
};

/// Iterations are those of the longest surface block, errors those of all that is interpolated.
[[nodiscard]] Iteration final_error(const Solved& solved, const Blocks& blocks);

/// Errors of the targets themselves, taken as control points.
[[nodiscard]] Iteration initial_error(const Prepared& prepared, const Solved& solved,
                                      const Task& task, const Context& context);

/// Which solvers the surface took, or the curves where there was nothing else: "chebyshev".
[[nodiscard]] std::string solvers_used(const Solved& solved);

/// Errors: cancelled, singular (naming the components).
Result<Solved> solve_in_stages(const Prepared& prepared, const Task& task, const Context& context,
                               std::vector<std::string>& notes);

}  // namespace surpass

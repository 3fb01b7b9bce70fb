// Similarity interpolation with requirements: solved, with lengths for tangents that would have
// none, and judged by evaluating the surface.
#pragma once

#include "interpolate/similarity_solve.hpp"

namespace surpass {

struct RequiredTask {
  const SimilarityPrepared& prepared;
  std::span<const Requirement> requirements;  // canonical
  const Elimination& released;                // without the vertices that are let go
  std::span<const Point> reference;
};

/// Without channels. Fails where requirements contradict each other; a surface that misses some, by
/// rounding, has not converged. Time: a solve, and a second where tangents get lengths, seldom
/// more.
[[nodiscard]] Result<SimilaritySolution> solve_required_task(const RequiredTask& task,
                                                             RequirementRows equations,
                                                             const Context& context);

}  // namespace surpass

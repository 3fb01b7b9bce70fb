// Whether a surface does what is required of it, by evaluating it.
#pragma once

#include "interpolate/requirement_rows.hpp"

namespace surpass {

/// `control`: the refined mesh with its points; `limits` of the given vertices. `side` of the
/// targets' box; errors are relative to it. Nothing is said of what is redundant.
[[nodiscard]] Result<std::vector<RequirementOutcome>> requirement_outcomes(
    const Mesh& control, const Rules& rules, std::span<const Point> limits,
    const RequirementRows& equations, std::span<const Requirement> requirements, double side,
    const Context& context);

}  // namespace surpass

// How to solve, for `interpolate` and `predict`.
#pragma once

#include <surpass/interpolate.hpp>

#include "options.hpp"

namespace surpass::cli {

/// --solver and --tolerance, stored in `chosen`.
void add_solver_options(Options& options, InterpolateOptions& chosen);

/// --tolerance alone, for commands that judge.
void add_tolerance(Options& options, double& tolerance);

}  // namespace surpass::cli

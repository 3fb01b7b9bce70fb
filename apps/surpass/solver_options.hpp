// How to solve, for `interpolate` and `predict`.
#pragma once

#include <surpass/interpolate.hpp>

#include <CLI/App.hpp>

namespace surpass::cli {

/// --solver and --tolerance, stored in `options`.
void add_solver_options(CLI::App& app, InterpolateOptions& options);

/// --tolerance alone, for commands that judge.
void add_tolerance(CLI::App& app, double& tolerance);

}  // namespace surpass::cli

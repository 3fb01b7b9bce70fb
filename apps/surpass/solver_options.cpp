#include "solver_options.hpp"

#include "arguments.hpp"

namespace surpass::cli {

void add_solver_options(CLI::App& app, InterpolateOptions& options) {
  add_choice(
      app, "--solver", options.solver,
      {Solver::automatic, Solver::chebyshev, Solver::richardson, Solver::conjugate_gradient,
       Solver::gauss_seidel, Solver::minimal_residual, Solver::bicgstab},
      "How the equation is solved; auto chooses by what is proven of the mesh, richardson is the "
      "paper's iteration")
      ->default_str(name_of(options.solver))
      ->group("Solver");
  add_tolerance(app, options.tolerance);
}

void add_tolerance(CLI::App& app, double& tolerance) {
  app.add_option("--tolerance", tolerance,
                 "Largest distance allowed between a given vertex and the limit surface at it, "
                 "relative to the largest side of the given mesh's bounding box; never taken below "
                 "4 units in the last place of the coordinates")
      ->check(in_range(0.0, 1.0))
      ->type_name("T")
      ->default_str(fmt::format("{}", tolerance))
      ->group("Solver");
}

}  // namespace surpass::cli

#include "solver_options.hpp"

#include <fmt/format.h>

namespace surpass::cli {

void add_solver_options(Options& options, InterpolateOptions& chosen) {
  options
      .choice("--solver", chosen.solver,
              {Solver::automatic, Solver::chebyshev, Solver::richardson, Solver::conjugate_gradient,
               Solver::gauss_seidel, Solver::minimal_residual, Solver::bicgstab},
              "How the equation is solved; auto chooses by what is proven of the mesh, richardson "
              "is the "
              "paper's iteration")
      .default_text(name_of(chosen.solver))
      .group("Solver");
  add_tolerance(options, chosen.tolerance);
}

void add_tolerance(Options& options, double& tolerance) {
  options
      .add("--tolerance", tolerance,
           "Largest distance allowed between a given vertex and the limit surface at it, "
           "relative to the largest side of the given mesh's bounding box; never taken below "
           "4 units in the last place of the coordinates")
      .in_range(0.0, 1.0)
      .type_name("T")
      .default_text(fmt::format("{}", tolerance))
      .group("Solver");
}

}  // namespace surpass::cli

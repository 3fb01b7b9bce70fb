#include "interpolate/choose_solver.hpp"

namespace surpass {
namespace {

// Lower end of the Chebyshev interval where nothing is proven. Too large a value only slows the
// iteration down, and the monitor notices if it fails.
constexpr double kUnprovenLowest = 0.1;

}  // namespace

Solver choose_solver(const Block& block) {
  if (block.proven()) return Solver::chebyshev;
  if (block.symmetric)
    return block.lowest < 0 ? Solver::minimal_residual : Solver::conjugate_gradient;
  return block.lowest > 0 ? Solver::chebyshev : Solver::bicgstab;
}

Verdict run_solver(Solver solver, const LinearSystem& system, Monitor& monitor,
                   std::span<double> x) {
  const Block& block = system.block;
  switch (solver) {
    case Solver::richardson: return semi_iteration(system, SemiIteration::richardson(), monitor, x);
    case Solver::conjugate_gradient: return conjugate_gradient(system, monitor, x);
    case Solver::gauss_seidel: return gauss_seidel(system, monitor, x);
    case Solver::minimal_residual: return minimal_residual(system, monitor, x);
    case Solver::bicgstab: return bicgstab(system, monitor, x);
    case Solver::automatic:
    case Solver::chebyshev: break;
  }
  const double lowest = block.proven() ? block.lowest : kUnprovenLowest;
  return semi_iteration(system, SemiIteration::chebyshev(lowest), monitor, x);
}

}  // namespace surpass

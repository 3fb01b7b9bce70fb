#include "interpolate/choose_solver.hpp"

#include <algorithm>

#include "interpolate/chebyshev.hpp"

namespace surpass {
namespace {

// Lower end of Chebyshev's interval. A value above the smallest eigenvalue only slows the iteration
// down, so what is likely may take the place of a bound that holds for every mesh. On irregular
// meshes the spectrum was seen to begin at 0.8 to 1 times the mean of the rows' bounds.
double interval_begin(const Block& block, double share) {
  constexpr double kLeast = 0.05;
  const double likely = std::max(share * block.mean_lowest, kLeast);
  return block.proven() ? std::max(block.lowest, likely) : likely;
}

// Where nothing is proven, much of the spectrum may lie below the interval, where polynomials of
// the second kind are the larger ones. Elsewhere they take fewer sweeps, and with this share of the
// mean 125 meshes took few without one that took many more.
SemiIteration coefficients_for(const Block& block) {
  if (!block.proven()) return SemiIteration::chebyshev(interval_begin(block, 0.8));
  return SemiIteration::chebyshev_of_second_kind(interval_begin(block, 0.83));
}

Verdict chebyshev(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  const SemiIteration start = coefficients_for(system.block);
  return monitor.wants_each() ? semi_iteration(system, start, monitor, x)
                              : chebyshev_iteration(system, start, monitor, x);
}

}  // namespace

Solver choose_solver(const Block& block) {
  if (block.proven()) return Solver::chebyshev;
  if (block.symmetric)
    return block.lowest < 0 ? Solver::minimal_residual : Solver::conjugate_gradient;
  return block.lowest > 0 ? Solver::chebyshev : Solver::bicgstab;
}

bool is_worth_chebyshev(const Block& block) {
  constexpr std::size_t kLarge = 2048;
  return block.symmetric && block.lowest == 0 && !block.suspect && block.vertices.size() >= kLarge;
}

Verdict run_solver(Solver solver, const LinearSystem& system, Monitor& monitor,
                   std::span<double> x) {
  switch (solver) {
    case Solver::richardson: return semi_iteration(system, SemiIteration::richardson(), monitor, x);
    case Solver::conjugate_gradient: return conjugate_gradient(system, monitor, x);
    case Solver::gauss_seidel: return gauss_seidel(system, monitor, x);
    case Solver::minimal_residual: return minimal_residual(system, monitor, x);
    case Solver::bicgstab: return bicgstab(system, monitor, x);
    case Solver::automatic:
    case Solver::chebyshev: break;
  }
  return chebyshev(system, monitor, x);
}

void order_rows_for(const InterpolateOptions& options, const LimitOperator& op, Block& block) {
  if (block.vertices.empty()) return;
  const bool automatic = options.solver == Solver::automatic;
  const Solver solver = automatic ? choose_solver(block) : options.solver;
  const bool sweeps = solver == Solver::chebyshev || (automatic && is_worth_chebyshev(block));
  if (!sweeps || (options.full_history && !options.direct)) return;
  auto rows = order_rows(op.rows, block.vertices);
  if (!rows) return;
  block.spare = std::make_shared<SpareArrays>();
  block.ordered = std::make_shared<const OrderedRows>(std::move(*rows));
}

}  // namespace surpass

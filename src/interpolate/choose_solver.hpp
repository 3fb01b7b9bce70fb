// Which solver fits a block, and how each is started.
#pragma once

#include "interpolate/solvers.hpp"

namespace surpass {

/// The solver that what is known of the block's operator calls for.
[[nodiscard]] Solver choose_solver(const Block& block);

/// Runs a solver other than `automatic`.
Verdict run_solver(Solver solver, const LinearSystem& system, Monitor& monitor,
                   std::span<double> x);

/// Orders the block's rows if what the options ask for sweeps over them without a test after each.
void order_rows_for(const InterpolateOptions& options, const LimitOperator& op, Block& block);

/// True for large symmetric blocks whose eigenvalues are positive, though nothing is proven of how
/// small they are: Chebyshev's iteration converges there, with conjugate gradients for those on
/// which it is slow. They take somewhat fewer evaluations, but their sums over all unknowns keep
/// one evaluation from following another in the cache, so each takes several times as long.
[[nodiscard]] bool is_worth_chebyshev(const Block& block);

}  // namespace surpass

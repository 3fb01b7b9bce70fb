#include "interpolate/block_solver.hpp"

#include <fmt/format.h>

#include "interpolate/a_priori.hpp"

namespace surpass {
namespace {

// Lower end of the Chebyshev interval where nothing is proven. Too large a value only slows the
// iteration down, and the monitor notices if it fails.
constexpr double kUnprovenLowest = 0.1;

class BlockSolver {
 public:
  BlockSolver(const InterpolateOptions& options, const LimitOperator& op, const Block& block,
              const Task& task, std::string_view stage, const Context& context)
      : options_(options),
        task_(task),
        system_{op, block, task.width, task.target, power_of_two_scale(task.unit), context},
        rule_{task.tolerance,
              task.unit,
              options.max_iterations,
              options.full_history || options.solver == Solver::richardson,
              options.solver != Solver::richardson,
              stage} {}

  Result<BlockOutcome> solve(std::vector<std::string>& notes) {
    if (system_.block.vertices.empty()) return BlockOutcome{};
    if (options_.direct) return solve_blind();
    Monitor monitor(rule_, system_);
    Verdict verdict = iterate(monitor);
    const Block& block = system_.block;
    if (verdict == Verdict::stalled && !block.proven()) return second_try(monitor, notes);
    if (verdict == Verdict::exhausted && !block.proven() && block.symmetric) {
      if (auto ok = require_regular(system_); !ok) return tl::make_unexpected(ok.error());
    }
    return outcome(verdict, monitor);
  }

 private:
  Verdict iterate(Monitor& monitor) {
    const Block& block = system_.block;
    switch (options_.solver) {
      case Solver::richardson:
        return semi_iteration(system_, SemiIteration::richardson(), monitor, task_.x);
      case Solver::conjugate_gradient: return conjugate_gradient(system_, monitor, task_.x);
      case Solver::gauss_seidel: return gauss_seidel(system_, monitor, task_.x);
      case Solver::chebyshev: break;
    }
    const double lowest = block.proven() ? block.lowest : kUnprovenLowest;
    return semi_iteration(system_, SemiIteration::chebyshev(lowest), monitor, task_.x);
  }

  // Nothing is proven of this block and the solver failed. A symmetric one is decided by a
  // factorisation; for others Chebyshev, the default, gives way to BiCGSTAB.
  Result<BlockOutcome> second_try(const Monitor& first, std::vector<std::string>& notes) {
    Monitor monitor(rule_, system_);
    if (system_.block.symmetric) {
      const auto verdict = direct_solve(system_, monitor, task_.x);
      if (!verdict) return tl::make_unexpected(verdict.error());
      notes.push_back(fmt::format("{} did not converge here; a sparse factorisation solved it",
                                  name_of(options_.solver)));
      return outcome(*verdict, monitor);
    }
    if (options_.solver != Solver::chebyshev) return outcome(Verdict::stalled, first);
    notes.emplace_back(
        "Chebyshev's iteration did not converge on these creases; BiCGSTAB took over");
    return outcome(bicgstab(system_, monitor, task_.x), monitor);
  }

  Result<BlockOutcome> solve_blind() {
    const Block& block = system_.block;
    const SemiIteration start = options_.solver == Solver::richardson
                                    ? SemiIteration::richardson()
                                    : SemiIteration::chebyshev(block.lowest);
    const double tolerance = rule_.tolerance * rule_.unit * system_.scale;
    const unsigned sweeps = sweeps_needed(system_, options_.solver, task_.x, tolerance);
    if (!semi_iteration_blind(system_, start, sweeps, task_.x)) return cancelled();
    std::vector<double> r(system_.values(), 0.0);
    Monitor monitor(rule_, system_);
    BlockOutcome done;
    done.converged = monitor.record(system_.residual(task_.x, r)) == Verdict::reached;
    done.final = monitor.last();
    done.final.iteration = sweeps;
    return done;
  }

  static tl::unexpected<Error> cancelled() {
    return fail(ErrorCode::cancelled, "cancelled while solving");
  }

  static Result<BlockOutcome> outcome(Verdict verdict, const Monitor& monitor) {
    if (verdict == Verdict::cancelled) return cancelled();
    const bool reached = verdict == Verdict::reached;
    Iteration final = reached ? monitor.last() : monitor.best();
    final.iteration = monitor.iterations();
    return BlockOutcome{reached, final, monitor.history()};
  }

  const InterpolateOptions& options_;
  const Task& task_;
  LinearSystem system_;
  StopRule rule_;
};

}  // namespace

Result<BlockOutcome> solve_block(const InterpolateOptions& options, const LimitOperator& op,
                                 const Block& block, const Task& task, std::string_view stage,
                                 const Context& context, std::vector<std::string>& notes) {
  return BlockSolver(options, op, block, task, stage, context).solve(notes);
}

}  // namespace surpass

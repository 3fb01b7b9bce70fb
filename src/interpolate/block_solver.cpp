#include "interpolate/block_solver.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "interpolate/a_priori.hpp"
#include "interpolate/chebyshev.hpp"
#include "interpolate/choose_solver.hpp"

namespace surpass {
namespace {

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
              stage},
        solver_(options.solver == Solver::automatic ? choose_solver(block) : options.solver) {}

  Result<BlockOutcome> solve(std::vector<std::string>& notes) {
    if (system_.block.vertices.empty()) return BlockOutcome{};
    if (options_.direct) return solve_blind();
    if (options_.solver == Solver::automatic && is_worth_chebyshev(system_.block)) {
      if (auto quick = try_chebyshev()) return *std::move(quick);
    }
    Monitor monitor(rule_, system_);
    const Verdict verdict = run_solver(solver_, system_, monitor, task_.x);
    return verdict == Verdict::stalled && !system_.block.proven()
               ? second_try(monitor, notes)
               : outcome(verdict, monitor, solver_);
  }

 private:
  // Nothing if it is slow here. Its sweeps then count for the solver that comes after it.
  std::optional<Result<BlockOutcome>> try_chebyshev() {
    constexpr unsigned kMost = 64;  // a third more than were seen on any mesh of some size
    StopRule rule = rule_;
    rule.max_iterations = std::min(rule.max_iterations, kMost);
    Monitor monitor(rule, system_);
    const Verdict verdict = run_solver(Solver::chebyshev, system_, monitor, task_.x);
    const bool slow = verdict == Verdict::exhausted && rule_.max_iterations > kMost;
    if (!slow) return outcome(verdict, monitor, Solver::chebyshev);
    tried_ = monitor.iterations();
    rule_.max_iterations -= tried_;
    return std::nullopt;
  }

  // Nothing is proven of this block and the solver failed. Whoever left the choice to us gets the
  // best solver for such blocks; a factorisation then decides whether there is a solution at all.
  Result<BlockOutcome> second_try(const Monitor& first, std::vector<std::string>& notes) {
    if (options_.solver == Solver::automatic && solver_ == Solver::chebyshev) {
      Monitor monitor(rule_, system_);
      const Verdict better = bicgstab(system_, monitor, task_.x);
      if (better == Verdict::reached || better == Verdict::cancelled) {
        notes.emplace_back(
            "Chebyshev's iteration did not converge on these creases; BiCGSTAB took over");
        return outcome(better, monitor, Solver::bicgstab);
      }
    }
    const std::vector<double> best(task_.x.begin(), task_.x.end());
    StopRule rule = rule_;
    rule.max_iterations = std::max(kRefinements, rule.max_iterations);
    Monitor monitor(rule, system_);
    const auto direct = direct_solve(system_, monitor, task_.x);
    if (!direct) return tl::make_unexpected(direct.error());
    if (*direct != Verdict::reached) {
      std::copy(best.begin(), best.end(), task_.x.begin());
      return outcome(Verdict::stalled, first, solver_);
    }
    notes.push_back(fmt::format("{} did not converge here; a sparse factorisation solved it",
                                name_of(solver_)));
    return outcome(*direct, monitor, solver_);
  }

  Result<BlockOutcome> solve_blind() {
    const double tolerance = rule_.tolerance * rule_.unit * system_.scale;
    const unsigned sweeps = sweeps_needed(system_, solver_, task_.x, tolerance);
    const bool done =
        solver_ == Solver::richardson
            ? semi_iteration_blind(system_, SemiIteration::richardson(), sweeps, task_.x)
            : chebyshev_iteration_blind(system_, SemiIteration::chebyshev(system_.block.lowest),
                                        sweeps, task_.x);
    if (!done) return cancelled();
    std::vector<double> r(system_.values(), 0.0);
    Monitor monitor(rule_, system_);
    BlockOutcome outcome;
    outcome.solver = solver_;
    outcome.converged = monitor.record(system_.residual(task_.x, r)) == Verdict::reached;
    outcome.final = monitor.last();
    outcome.final.iteration = sweeps;
    return outcome;
  }

  static tl::unexpected<Error> cancelled() {
    return fail(ErrorCode::cancelled, "cancelled while solving");
  }

  [[nodiscard]] Result<BlockOutcome> outcome(Verdict verdict, const Monitor& monitor,
                                             Solver solver) const {
    if (verdict == Verdict::cancelled) return cancelled();
    const bool reached = verdict == Verdict::reached;
    Iteration final = reached ? monitor.last() : monitor.best();
    final.iteration = tried_ + monitor.iterations();
    return BlockOutcome{reached, monitor.first(), final, monitor.history(), solver};
  }

  static constexpr unsigned kRefinements = 10;  // of a factorisation's solution

  const InterpolateOptions& options_;
  const Task& task_;
  LinearSystem system_;
  StopRule rule_;
  Solver solver_;
  unsigned tried_ = 0;  // sweeps of a solver that was given up
};

}  // namespace

Result<BlockOutcome> solve_block(const InterpolateOptions& options, const LimitOperator& op,
                                 const Block& block, const Task& task, std::string_view stage,
                                 const Context& context, std::vector<std::string>& notes) {
  return BlockSolver(options, op, block, task, stage, context).solve(notes);
}

}  // namespace surpass

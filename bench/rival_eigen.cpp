// Eigen: conjugate gradients and LDLT on the symmetric system, and the limit as a matrix product.
#include <cmath>
#include <memory>
#include <optional>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include "contenders.hpp"
#include "judges.hpp"
#include "loop_system.hpp"

namespace surpass::bench {
namespace {

// Both triangles are stored, so that a product need not look for the other half.
using Iteration = Eigen::ConjugateGradient<ColumnMatrix, Eigen::Lower | Eigen::Upper>;

struct Solved {
  Columns control;
  Eigen::Index iterations = 0;
};

Solved iterate(Iteration& solver, const Columns& right, const Columns& guess) {
  Solved solved{Columns(right.rows(), 3)};
  for (Eigen::Index k = 0; k < 3; ++k) {
    solved.control.col(k) = solver.solveWithGuess(right.col(k), guess.col(k));
    solved.iterations = std::max(solved.iterations, solver.iterations());
  }
  return solved;
}

Solved solve_from_faces(const Mesh& mesh, double tolerance) {
  const ColumnMatrix system = symmetric_system(mesh);
  Iteration solver(system);
  solver.setTolerance(tolerance);
  return iterate(solver, right_hand_sides(system, mesh.points), as_rows(mesh.points));
}

// Eigen stops by the residual's norm relative to the right-hand side's. The loosest such tolerance
// that still brings every vertex within ours, in steps of about one iteration.
double loosest_tolerance(const Workload& workload) {
  double tolerance = kTolerance * 10;
  while (workload.interpolation_error(
             as_points(solve_from_faces(workload.mesh(), tolerance).control)) > kTolerance) {
    tolerance /= std::sqrt(10.0);
  }
  return tolerance;
}

Verdict judge(const Workload& workload, const Solved& solved) {
  Verdict verdict = judge_control(workload, as_points(solved.control));
  verdict.sweeps = static_cast<double>(solved.iterations);
  return verdict;
}

// Matrix and preconditioner, which refers to it.
struct Kept {
  ColumnMatrix system;
  Iteration solver;
};

std::shared_ptr<Kept> set_up(const Workload& workload, double tolerance) {
  auto kept = std::make_shared<Kept>();
  kept->system = symmetric_system(workload.mesh());
  kept->solver.compute(kept->system);
  kept->solver.setTolerance(tolerance);
  return kept;
}

void add_cg(Harness& harness, Index side) {
  const auto found = std::make_shared<std::optional<double>>();  // once for both steps
  const auto tolerance = [found](const Workload& w) {
    if (!*found) *found = loosest_tolerance(w);
    return **found;
  };
  harness.add(
      {.step = "solve from faces",
       .tool = "Eigen CG",
       .counted = "assembly of S, Jacobi preconditioner, 3 right-hand sides one after the "
                  "other from the given points, to the same error"},
      side,
      [tolerance](const Workload& w) {
        return [&mesh = w.mesh(), t = tolerance(w)] { return solve_from_faces(mesh, t); };
      },
      judge);
  harness.add(
      {.step = "solve again",
       .tool = "Eigen CG",
       .counted = "right-hand sides and 3 solves, matrix and preconditioner kept"},
      side,
      [tolerance](const Workload& w) {
        return [&mesh = w.mesh(), kept = set_up(w, tolerance(w))] {
          return iterate(kept->solver, right_hand_sides(kept->system, mesh.points),
                         as_rows(mesh.points));
        };
      },
      judge);
}

void add_ldlt(Harness& harness, Index side) {
  using Factor = Eigen::SimplicialLDLT<ColumnMatrix>;
  harness.add(
      {.step = "solve from faces",
       .tool = "Eigen LDLT",
       .counted = "assembly of S, AMD ordering, factorisation and solve for 3 right-hand "
                  "sides",
       .slow = true},
      side,
      [](const Workload& w) {
        return [&mesh = w.mesh()] {
          const ColumnMatrix system = symmetric_system(mesh);
          const Columns right = right_hand_sides(system, mesh.points);
          return Solved{Factor(system).solve(right)};
        };
      },
      [](const Workload& w, const Solved& solved) {
        return judge_control(w, as_points(solved.control));
      });
}

void add_product(Harness& harness, Index side) {
  harness.add(
      {.step = "sweep",
       .tool = "Eigen product",
       .counted = "row-major sparse L times the points, 3 columns at once, into a new array"},
      side,
      [](const Workload& w) {
        return [matrix = limit_matrix(w.mesh()), rows = as_rows(w.mesh().points)] {
          return Rows(matrix * rows);
        };
      },
      [](const Workload& w, const Rows& limits) { return judge_limits(w, as_points(limits)); });
}

}  // namespace

void add_eigen(Harness& harness, Index side) {
  add_product(harness, side);
  add_cg(harness, side);
  constexpr Index kLargestLdlt = 500;  // beyond it CHOLMOD speaks for the direct methods
  if (side <= kLargestLdlt) add_ldlt(harness, side);
}

}  // namespace surpass::bench

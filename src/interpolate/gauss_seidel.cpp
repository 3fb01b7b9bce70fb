// Gauss-Seidel: every vertex uses its neighbours' newest positions, so the order matters and one
// thread does it all.
#include <algorithm>

#include "interpolate/solvers.hpp"

namespace surpass {
namespace {

// One sweep in place; returns the residuals met on the way, which are not those of one iterate.
ErrorNorms sweep(const LinearSystem& system, std::span<double> x) {
  const SparseRows& rows = system.op.rows;
  ErrorNorms met;
  for (const Index v : system.block.vertices) {
    const auto columns = rows.row_columns(v);
    const auto weights = rows.row_weights(v);
    double squared = 0;
    for (std::size_t c = 0; c < system.width; ++c) {
      const std::size_t at = v * system.width + c;
      double diagonal = 0;
      double sum = 0;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        sum += weights[k] * x[columns[k] * system.width + c];
        if (columns[k] == v) diagonal = weights[k];
      }
      const double r = system.target[at] - sum;
      x[at] += r / diagonal;
      squared += (r * system.scale) * (r * system.scale);
    }
    const double distance = std::sqrt(squared);
    if (!(distance <= met.max)) met.max = distance;
    met.sum += distance;
  }
  return met;
}

}  // namespace

Verdict gauss_seidel(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  std::vector<double> r(system.values(), 0.0);
  Verdict verdict = monitor.record(system.residual(x, r));
  while (verdict == Verdict::go_on) {
    verdict = monitor.record(sweep(system, x));
    // What was met on the way is larger than what is left; ask the iterate itself before stopping.
    if (verdict == Verdict::reached) verdict = monitor.record(system.residual(x, r));
  }
  return verdict;
}

}  // namespace surpass

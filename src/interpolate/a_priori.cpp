#include "interpolate/a_priori.hpp"

#include <algorithm>
#include <cmath>

namespace surpass {
namespace {

double reduction(Solver solver, double lo, unsigned sweeps) {
  const double k = sweeps;
  if (solver == Solver::richardson) return std::pow(1 - lo, k);
  const double s = (1 - std::sqrt(lo)) / (1 + std::sqrt(lo));
  return 2 * std::pow(s, k) / (1 + std::pow(s, 2 * k));
}

}  // namespace

unsigned sweeps_needed(const LinearSystem& system, Solver solver, std::span<const double> x,
                       double tolerance) {
  if (system.block.vertices.empty()) return 0;
  std::vector<double> r(system.values(), 0.0);
  system.residual(x, r);
  const std::vector<double>& d = system.op.symmetric_weight;
  double squared = 0;
  for (const double part : system.dot(r, r, &d)) squared += part;
  double least = d[system.block.vertices.front()];
  for (const Index v : system.block.vertices) least = std::min(least, d[v]);
  const double start = std::sqrt(squared / least);
  constexpr unsigned kMost = 1000000;
  unsigned sweeps = 0;
  while (sweeps < kMost && reduction(solver, system.block.lowest, sweeps) * start > tolerance) {
    ++sweeps;
  }
  return sweeps;
}

}  // namespace surpass

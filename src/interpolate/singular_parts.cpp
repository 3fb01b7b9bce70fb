#include "interpolate/singular_parts.hpp"

#include <cmath>

#include "interpolate/choose_solver.hpp"

namespace surpass {
namespace {

// A number in [-1, 1] that depends on v alone, without pattern (the finaliser of SplitMix64).
double irregular(Index v) {
  std::uint64_t z = (v + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

// r less the solution of L y = L r.
std::vector<double> what_is_lost(const LimitOperator& op, const Block& block,
                                 const std::vector<double>& r, const Context& context) {
  std::vector<double> image(r.size(), 0.0);
  const LinearSystem maker{op, block, 1, r, 1, context};
  maker.product(r, image);
  std::vector<double> y(r.size(), 0.0);
  const LinearSystem system{op, block, 1, image, 1, context};
  constexpr unsigned kMost = 20000;
  Monitor monitor({.tolerance = 1e-13,
                   .max_iterations = kMost,
                   .stop_when_stalled = true,
                   .stage = "singularity"},
                  system);
  run_solver(choose_solver(block), system, monitor, y);
  for (const Index v : block.vertices) y[v] = r[v] - y[v];
  return y;
}

}  // namespace

std::vector<SingularPart> find_singular_parts(const LimitOperator& op, const Blocks& blocks,
                                              const Context& context) {
  std::vector<SingularPart> found;
  for (std::size_t b = 0; b < blocks.surface.size(); ++b) {
    const Block& block = blocks.surface[b];
    if (!block.suspect) continue;
    std::vector<double> r(op.rows.row_count(), 0.0);
    for (const Index v : block.vertices) r[v] = irregular(v);
    // The second time removes what the first solve left of the regular part.
    std::vector<double> lost = what_is_lost(op, block, r, context);
    lost = what_is_lost(op, block, lost, context);
    for (std::vector<Index>& part : connected_parts(op.rows, block.vertices)) {
      double largest = 0;
      for (const Index v : part) {
        if (std::abs(lost[v]) > std::abs(largest)) largest = lost[v];
      }
      constexpr double kPresent = 1e-4;  // of r's size; a regular part leaves rounding only
      if (std::abs(largest) < kPresent) continue;
      std::vector<double> null_vector;
      null_vector.reserve(part.size());
      for (const Index v : part) null_vector.push_back(lost[v] / largest);
      found.push_back({b, std::move(part), std::move(null_vector)});
    }
  }
  return found;
}

}  // namespace surpass

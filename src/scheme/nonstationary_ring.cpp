// A ring whose edges have parameters of their own: the vertex leaves the line to the centroid, but
// one ring still makes the next, so its limit is a row over one ring. Later levels are composed
// with earlier ones, backwards from the level at which every rule is Loop's.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scheme/nonstationary_state.hpp"

namespace surpass::nonstationary {
namespace {

/// The rules of one level around the vertex.
struct RingStep {
  double moved = 0;       ///< weight of the ring in the vertex rule
  std::vector<double> d;  ///< by spoke
};

Mask composed(const Mask& later, const RingStep& step) {
  const std::size_t n = step.d.size();
  Mask mask(n + 1, step.moved / static_cast<double>(n) * later[0]);
  mask[0] = (1 - step.moved) * later[0];
  for (std::size_t j = 0; j < n; ++j) {
    const double w = later[1 + j];
    mask[0] += (0.5 - step.d[j]) * w;
    mask[1 + j] += (0.5 - step.d[j]) * w;
    mask[1 + (j + 1) % n] += step.d[j] * w;
    mask[1 + (j + n - 1) % n] += step.d[j] * w;
  }
  return mask;
}

std::vector<RingStep> ring_steps(double alpha, std::vector<double> spokes,
                                 const NonstationaryOptions& options) {
  const double ring = ring_weight(static_cast<Index>(spokes.size()), options.weights);
  std::vector<RingStep> steps;
  for (int level = 0; level < settling_levels(options); ++level) {
    RingStep& step = steps.emplace_back();
    step.moved = ring * in_mask(alpha, options);
    for (double& spoke : spokes) {
      const double edge = (alpha + spoke) / 2;
      step.d.push_back(in_mask(edge, options) / 8);
      spoke = iterated(edge, 1, options);
    }
    alpha = iterated(alpha, 1, options);
  }
  return steps;
}

}  // namespace

RingLimit ring_limit(double alpha, const std::vector<double>& spokes,
                     const NonstationaryOptions& options) {
  const std::size_t n = spokes.size();
  auto steps = ring_steps(alpha, spokes, options);
  std::reverse(steps.begin(), steps.end());
  const double ring = ring_weight(static_cast<Index>(n), options.weights);
  const double share = ring / (ring + 3.0 / 8);
  RingLimit limit{Mask(n + 1, share / static_cast<double>(n)),
                  {Mask(n + 1, 0.0), Mask(n + 1, 0.0)}};
  limit.position[0] = 1 - share;
  for (std::size_t j = 0; j < n; ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    limit.tangents.first[1 + j] = std::cos(angle);
    limit.tangents.second[1 + j] = std::sin(angle);
  }
  const double shrunk = 3.0 / 8 + std::cos(2 * std::numbers::pi / static_cast<double>(n)) / 4;
  for (const RingStep& step : steps) {
    limit.position = composed(limit.position, step);
    for (Mask* tangent : {&limit.tangents.first, &limit.tangents.second}) {
      *tangent = composed(*tangent, step);
      for (double& w : *tangent) w /= shrunk;
      // What rounding has left of the position would grow from level to level.
      const double sum = std::accumulate(tangent->begin(), tangent->end(), 0.0);
      for (std::size_t i = 0; i <= n; ++i) (*tangent)[i] -= sum * limit.position[i];
    }
  }
  return limit;
}

}  // namespace surpass::nonstationary

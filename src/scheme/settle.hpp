// Follows a ring through refinement until its rules change no more: how limits and tangents near
// fading sharpness are found exactly.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace surpass {

/// Weights over the points of a ring.
using Mask = std::vector<double>;

/// mask * weights: a mask over the points that `weights` makes, expressed in those they are made
/// of.
[[nodiscard]] inline Mask compose(const Mask& mask, const std::vector<Mask>& weights) {
  Mask composed(weights.front().size(), 0.0);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    for (std::size_t k = 0; k < composed.size(); ++k) composed[k] += mask[i] * weights[i][k];
  }
  return composed;
}

/// into = share * into + (1 - share) * other.
inline void blend(Mask& into, double share, const Mask& other) {
  for (std::size_t i = 0; i < into.size(); ++i) into[i] = share * into[i] + (1 - share) * other[i];
}

/// A later ring, and a mask for each of its points over the points of the first.
template <class R>
struct Settled {
  R ring;
  std::vector<Mask> weights;
};

/// R has point_count(), child() and child_masks(), a mask for each point of the child.
template <class R, class Done>
[[nodiscard]] Settled<R> settle(const R& ring, Done&& done) {
  const std::size_t n = ring.point_count();
  Settled<R> settled{ring, std::vector<Mask>(n, Mask(n, 0.0))};
  for (std::size_t i = 0; i < n; ++i) settled.weights[i][i] = 1;
  while (!done(settled.ring)) {
    std::vector<Mask> next;
    for (const Mask& mask : settled.ring.child_masks()) {
      next.push_back(compose(mask, settled.weights));
    }
    settled.weights = std::move(next);
    settled.ring = settled.ring.child();
  }
  return settled;
}

}  // namespace surpass

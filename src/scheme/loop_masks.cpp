#include "scheme/loop_masks.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "scheme/crease_masks.hpp"

namespace surpass::loop {
namespace {

Mask even_mask(const LoopRing& ring, double center) {
  Mask mask(ring.size() + 1, (1 - center) / static_cast<double>(ring.size()));
  mask[0] = center;
  return mask;
}

// The six limit masks of boundary vertices under `hoppe`, built up from their two neighbours.
Mask hoppe_limit_mask(const LoopRing& ring) {
  Mask mask(ring.size() + 1, 0.0);
  mask[0] = ring.center_regular ? 1.0 / 2 : 9.0 / 20;
  const std::array<std::size_t, 2> ends = {1, ring.size()};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool regular = ring.end_regular[i];
    if (ring.center_regular) {
      mask[0] += (regular ? 4.0 : 5.0) / 48;
      mask[ends[i]] = (regular ? 8.0 : 7.0) / 48;
    } else {
      mask[0] += (regular ? 3.0 : 4.0) / 40;
      mask[ends[i]] = (regular ? 8.0 : 7.0) / 40;
    }
  }
  return mask;
}

// The exact limit at the end of a crease, by invariance under refinement. OpenSubdiv uses the
// smooth mask there, to which its own refined points do not converge.
Mask dart_limit_mask(const LoopRing& ring) {
  const std::size_t n = ring.size();
  const std::size_t end = ring.sharp_spokes().front();
  const double c = alpha(n) / static_cast<double>(n);
  const double r = (5 - std::sqrt(21.0)) / 2;
  const auto power = [&](std::size_t j) { return std::pow(r, static_cast<double>(j)); };
  Mask mask(n + 1, 0.0);
  mask[0] = 1;
  for (std::size_t j = 1; j < n; ++j) {
    mask[1 + (end + j) % n] = 8 * c / 3 * (1 - (power(j) + power(n - j)) / (1 + power(n)));
  }
  mask[1 + end] = 2 * c + mask[1 + (end + 1) % n] / 2;
  const double sum = std::accumulate(mask.begin(), mask.end(), 0.0);
  for (double& w : mask) w /= sum;
  return mask;
}

// Limit mask of a ring whose sharpnesses are all 0 or infinite.
Mask settled_limit_mask(const LoopRing& ring) {
  switch (ring.rule()) {
    case VertexRule::corner: return corner_mask(ring.point_count());
    case VertexRule::crease:
      return ring.is_hoppe_curve() ? hoppe_limit_mask(ring)
                                   : curve_mask(ring, ring.point_count(), 2.0 / 3);
    case VertexRule::dart: return dart_limit_mask(ring);
    default: return even_mask(ring, beta(ring.size()));
  }
}

}  // namespace

double alpha(std::size_t n) {
  const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / static_cast<double>(n)) / 4;
  return 5.0 / 8 - c * c;
}

double beta(std::size_t n) {
  const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / static_cast<double>(n)) / 4;
  return 3 / (11 - 8 * (3.0 / 8 + c * c));
}

LoopRing LoopRing::around(const Topology& topology, const Sharpness& sharpness, Boundary boundary,
                          Index v) {
  LoopRing ring;
  static_cast<Ring&>(ring) = Ring::around(topology, sharpness, v);
  ring.boundary = boundary;
  if (boundary == Boundary::hoppe && ring.open) {
    constexpr Index kRegular = 4;
    ring.center_regular = ring.size() == kRegular;
    ring.end_regular = {topology.valence(ring.spokes.front()) == kRegular,
                        topology.valence(ring.spokes.back()) == kRegular};
  }
  return ring;
}

bool LoopRing::is_hoppe_curve() const {
  return boundary == Boundary::hoppe && open && rule() == VertexRule::crease;
}

bool LoopRing::is_settled() const {
  return !is_semi_sharp() && (!is_hoppe_curve() || (end_regular[0] && end_regular[1]));
}

LoopRing LoopRing::child() const {
  LoopRing ring = *this;
  static_cast<Ring&>(ring) = Ring::child();
  ring.end_regular = {true, true};  // a new boundary vertex has valence 4
  return ring;
}

Mask vertex_mask(const LoopRing& ring) {
  return refined_mask(ring, ring.point_count(),
                      [&] { return even_mask(ring, 1 - alpha(ring.size())); });
}

double boundary_edge_share(Boundary boundary, bool first_regular, bool second_regular) {
  if (boundary != Boundary::hoppe || first_regular == second_regular) return 1.0 / 2;
  return first_regular ? 5.0 / 8 : 3.0 / 8;
}

Mask spoke_mask(const LoopRing& ring, std::size_t j) {
  const std::size_t n = ring.size();
  Mask mask(n + 1, 0.0);
  if (ring.open && (j == 0 || j + 1 == n)) {
    mask[0] =
        boundary_edge_share(ring.boundary, ring.center_regular, ring.end_regular[j == 0 ? 0 : 1]);
    mask[1 + j] = 1 - mask[0];
    return mask;
  }
  const double crease = std::min(1.0, static_cast<double>(ring.spoke_sharpness[j]));
  mask[0] = mask[1 + j] = crease / 2 + (1 - crease) * 3 / 8;
  mask[1 + (j + 1) % n] += (1 - crease) / 8;
  mask[1 + (j + n - 1) % n] += (1 - crease) / 8;
  return mask;
}

std::vector<Mask> LoopRing::child_masks() const {
  std::vector<Mask> masks = {vertex_mask(*this)};
  for (std::size_t j = 0; j < size(); ++j) masks.push_back(spoke_mask(*this, j));
  return masks;
}

Mask limit_mask(const LoopRing& ring) {
  if (ring.boundary == Boundary::interior && ring.open && ring.sharpness <= 0) {
    return even_mask(ring, beta(ring.size()));
  }
  // A vertex that stays a corner for good is its own limit, however its neighbours move.
  if (is_infinite(ring.sharpness)) return corner_mask(ring.point_count());
  if (!ring.is_semi_sharp()) return settled_limit_mask(ring);
  const auto settled = settle(ring, [](const LoopRing& r) { return r.is_settled(); });
  return compose(settled_limit_mask(settled.ring), settled.weights);
}

}  // namespace surpass::loop

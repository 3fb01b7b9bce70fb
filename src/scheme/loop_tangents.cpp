// Tangent masks of Loop surfaces: left eigenvectors of the local subdivision matrix. Between two
// sharp spokes the matrix of a sector splits into cosine and sine modes, which gives them in closed
// form.
#include <cmath>
#include <numbers>

#include "scheme/loop_masks.hpp"

namespace surpass::loop {
namespace {

constexpr double kPi = std::numbers::pi;

double angle(std::size_t j, std::size_t n) {
  return 2 * kPi * static_cast<double>(j) / static_cast<double>(n);
}

Tangents smooth_tangents(const LoopRing& ring) {
  const std::size_t n = ring.size();
  Tangents t{Mask(n + 1, 0.0), Mask(n + 1, 0.0)};
  for (std::size_t j = 0; j < n; ++j) {
    t.first[1 + j] = std::cos(angle(j, n));
    t.second[1 + j] = std::sin(angle(j, n));
  }
  return t;
}

// The odd modes at a dart do not see the crease: they are the smooth ones.
Tangents dart_tangents(const LoopRing& ring) {
  const std::size_t n = ring.size();
  const std::size_t end = ring.sharp_spokes().front();
  std::vector<std::size_t> mirrored(n + 1, 0);
  Mask odd(n + 1, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    mirrored[1 + (end + j) % n] = 1 + (end + n - j) % n;
    odd[1 + (end + j) % n] = std::sin(angle(j, n));
  }
  return {even_dart_tangent(ring.child_masks(), mirrored, end, n), odd};
}

// Between two sharp spokes of a smooth curve: along the curve, and across it into the sector.
Tangents curve_tangents(const LoopRing& ring, const Sector& sector) {
  const std::size_t begin = sector.begin;
  const std::size_t faces = sector.faces;
  const std::size_t n = ring.size();
  const bool extraordinary = ring.is_hoppe_curve() && !ring.center_regular;
  // A point on a sharp spoke keeps this share of the neighbour and takes the rest from the center.
  const double kept = extraordinary ? 5.0 / 8 : 1.0 / 2;
  const auto at = [&](std::size_t j) { return 1 + (begin + j) % n; };
  Tangents t{Mask(n + 1, 0.0), Mask(n + 1, 0.0)};
  t.first[at(0)] = 1;
  t.first[at(faces)] = -1;
  if (faces == 1) {
    t.second[at(0)] = t.second[at(1)] = 1;
    t.second[0] = -2;
    return t;
  }
  const double step = kPi / static_cast<double>(faces);
  double inside = 0;
  for (std::size_t j = 1; j < faces; ++j) {
    t.second[at(j)] = std::sin(step * static_cast<double>(j));
    inside += t.second[at(j)];
  }
  // Weights of the two sharp spokes and of the center, from the eigenvalue of the sine mode.
  const double lambda = 3.0 / 8 + std::cos(step) / 4;
  const double spoke_row[3] = {lambda - kept, -1.0 / 8, std::sin(step) / 8};
  const double center_row[3] = {-2 * (1 - kept), lambda - 3.0 / 4, 3.0 / 8 * inside};
  const double det = spoke_row[0] * center_row[1] - spoke_row[1] * center_row[0];
  double spoke = 0;    // with two faces under `hoppe` the eigenvalue is double and any spoke
  double center = -1;  // weight will do: keep the plain difference
  if (std::abs(det) > 1e-9) {
    spoke = (spoke_row[2] * center_row[1] - spoke_row[1] * center_row[2]) / det;
    center = (spoke_row[0] * center_row[2] - spoke_row[2] * center_row[0]) / det;
  }
  t.second[at(0)] = t.second[at(faces)] = spoke;
  t.second[0] = center;
  return t;
}

}  // namespace

std::vector<Tangents> tangent_masks(const LoopRing& ring) {
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth) return {smooth_tangents(ring)};
  if (rule == VertexRule::dart) return {dart_tangents(ring)};
  return sector_tangents(ring, curve_tangents, corner_tangents<LoopRing>);
}

}  // namespace surpass::loop

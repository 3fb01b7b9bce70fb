// Tangent masks of Loop surfaces: left eigenvectors of the local subdivision matrix. Between two
// sharp spokes the matrix of a sector splits into cosine and sine modes, which gives them in closed
// form; at darts the even mode has none that we know, and its small eigenproblem is solved.
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

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

// The even tangent at a dart: unknowns are the center, the crease's spoke and the pairs of spokes
// j, n - j. The mode wanted is the one after the eigenvalue 1.
Mask even_dart_tangent(std::size_t n) {
  const auto pairs = static_cast<Eigen::Index>(n / 2);  // the last is a single spoke for even n
  const Eigen::Index size = pairs + 2;
  const double moved = alpha(n);
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(size, size);  // on center, crease spoke, pair means
  step(0, 0) = 1 - moved;
  step(0, 1) = moved / static_cast<double>(n);
  step(1, 0) = step(1, 1) = 1.0 / 2;
  const auto column = [&](Eigen::Index j) {  // of spoke j, folded about the crease
    const auto count = static_cast<Eigen::Index>(n);
    const Eigen::Index folded = std::min(j, count - j);
    return 1 + folded;
  };
  for (Eigen::Index j = 1; j < static_cast<Eigen::Index>(n); ++j) {
    step(0, column(j)) += moved / static_cast<double>(n);
  }
  for (Eigen::Index j = 1; j <= pairs; ++j) {
    step(1 + j, 0) += 3.0 / 8;
    step(1 + j, column(j)) += 3.0 / 8;
    step(1 + j, column(j - 1)) += 1.0 / 8;
    step(1 + j, column(j + 1)) += 1.0 / 8;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(step.transpose());
  const Eigen::VectorXd values = solver.eigenvalues().real();
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (values[i] < 1 - 1e-9 && (best < 0 || values[i] > values[best])) best = i;
  }
  const Eigen::VectorXd left = solver.eigenvectors().col(best).real();
  Mask mask(n + 1, 0.0);
  mask[0] = left[0];
  mask[1] = left[1];
  double along = mask[1];  // response to a flat ring, whose crease points along +x
  for (std::size_t j = 1; j < n; ++j) {
    const bool single = 2 * j == n;
    mask[1 + j] = left[column(static_cast<Eigen::Index>(j))] / (single ? 1 : 2);
    along += mask[1 + j] * std::cos(angle(j, n));
  }
  if (along < 0) {
    for (double& w : mask) w = -w;
  }
  return mask;
}

Tangents dart_tangents(const LoopRing& ring) {
  const std::size_t n = ring.size();
  const std::size_t end = ring.sharp_spokes().front();
  const Mask even = even_dart_tangent(n);
  Tangents t{Mask(n + 1, 0.0), Mask(n + 1, 0.0)};
  t.first[0] = even[0];
  for (std::size_t j = 0; j < n; ++j) {
    t.first[1 + (end + j) % n] = even[1 + j];
    t.second[1 + (end + j) % n] = std::sin(angle(j, n));
  }
  return t;
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

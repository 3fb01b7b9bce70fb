// Tangent masks of Catmull-Clark surfaces among quads: left eigenvectors of the local subdivision
// matrix, derived here. Between two sharp spokes the matrix of a sector splits into sine modes,
// which gives them in closed form.
#include <cmath>
#include <numbers>

#include "scheme/catmull_clark_masks.hpp"

namespace surpass::catmull_clark {
namespace {

constexpr double kPi = std::numbers::pi;

double angle(std::size_t j, std::size_t n) {
  return 2 * kPi * static_cast<double>(j) / static_cast<double>(n);
}

// The face's vertex across from the center.
std::size_t across(const FaceRing& ring, std::size_t j) { return ring.faces[j][2]; }

// The two modes of valence 2 along its spokes and across them. Its rules have no tangent plane: a
// further mode fades as fast and alternates.
Tangents doublet_tangents(const FaceRing& ring) {
  Tangents t{Mask(ring.point_count(), 0.0), Mask(ring.point_count(), 0.0)};
  t.first[1] = t.second[across(ring, 0)] = 1;
  t.first[2] = t.second[across(ring, 1)] = -1;
  return t;
}

// Halstead, Kass, DeRose 1993, appendix A.
Tangents smooth_tangents(const FaceRing& ring) {
  const std::size_t n = ring.size();
  if (n == 2) return doublet_tangents(ring);
  const double c = std::cos(angle(1, n));
  const double spoke = 1 + c + std::cos(angle(1, n) / 2) * std::sqrt(2 * (9 + c));
  Tangents t{Mask(ring.point_count(), 0.0), Mask(ring.point_count(), 0.0)};
  for (std::size_t j = 0; j < n; ++j) {
    t.first[1 + j] = spoke * std::cos(angle(j, n));
    t.second[1 + j] = spoke * std::sin(angle(j, n));
    t.first[across(ring, j)] = std::cos(angle(j, n)) + std::cos(angle(j + 1, n));
    t.second[across(ring, j)] = std::sin(angle(j, n)) + std::sin(angle(j + 1, n));
  }
  return t;
}

// The mirror image about the crease's spoke, as a permutation of the ring's points.
std::vector<std::size_t> mirrored(const FaceRing& ring, std::size_t end) {
  const std::size_t n = ring.size();
  std::vector<std::size_t> image(ring.point_count(), 0);
  for (std::size_t j = 0; j < n; ++j) {
    image[1 + (end + j) % n] = 1 + (end + n - j) % n;
    image[across(ring, (end + j) % n)] = across(ring, (end + n - 1 - j) % n);
  }
  return image;
}

// The odd modes at a dart do not see the crease: they are the smooth ones.
Tangents dart_tangents(const FaceRing& ring) {
  const std::size_t n = ring.size();
  const std::size_t end = ring.sharp_spokes().front();
  Tangents t{even_dart_tangent(ring.child_masks(), mirrored(ring, end), end, n),
             Mask(ring.point_count(), 0.0)};
  const Mask odd = smooth_tangents(ring).second;  // about spoke 0
  for (std::size_t j = 0; j < n; ++j) {
    t.second[1 + (end + j) % n] = odd[1 + j];
    t.second[across(ring, (end + j) % n)] = odd[across(ring, j)];
  }
  return t;
}

// Along the sharp curve, and across it into the sector. With w_j = sin(j pi / faces) on the spokes
// inside, the eigenvalue follows from the rows of spokes and faces; the weights of the two sharp
// spokes and of the center then from theirs.
Tangents curve_tangents(const FaceRing& ring, const Sector& sector) {
  const std::size_t n = ring.size();
  const auto spoke = [&](std::size_t j) { return 1 + (sector.begin + j) % n; };
  Tangents t{Mask(ring.point_count(), 0.0), Mask(ring.point_count(), 0.0)};
  t.first[spoke(0)] = 1;
  t.first[spoke(sector.faces)] = -1;
  const double step = kPi / static_cast<double>(sector.faces);
  if (sector.faces == 1) {  // no mode of order one half leads inside; the face's plane stands in
    t.second[spoke(0)] = t.second[spoke(1)] = 1;
    t.second[0] = -2;
    return t;
  }
  const double c = std::cos(step);
  // (x - 3/8)(x - 1/4) = c/8 (x - 1/4) + (1 + c)/32, the larger root.
  const double sum = 5.0 / 8 + c / 8;
  const double product = 3.0 / 32 + c / 32 - (1 + c) / 32;
  const double x = (sum + std::sqrt(sum * sum - 4 * product)) / 2;
  const auto weight = [&](std::size_t j) { return std::sin(step * static_cast<double>(j)); };
  double inside = 0;
  for (std::size_t j = 0; j < sector.faces; ++j) {
    const double face = (weight(j) + weight(j + 1)) / (16 * (x - 1.0 / 4));
    t.second[across(ring, (sector.begin + j) % n)] = face;
    if (j > 0) t.second[spoke(j)] = weight(j);
    inside += 3.0 / 8 * weight(j) + face / 4;
  }
  const double beside = weight(1) / 16 + t.second[across(ring, sector.begin % n)] / 4;
  const double half = x - 1.0 / 2;
  const double center = -(beside + inside * half) / ((3.0 / 4 - x) * half + 1.0 / 8);
  t.second[0] = center;
  t.second[spoke(0)] = t.second[spoke(sector.faces)] = -((3.0 / 4 - x) * center + inside);
  return t;
}

}  // namespace

std::vector<Tangents> tangent_masks(const FaceRing& ring) {
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth) return {smooth_tangents(ring)};
  if (rule == VertexRule::dart) return {dart_tangents(ring)};
  return sector_tangents(ring, curve_tangents, corner_tangents<FaceRing>);
}

}  // namespace surpass::catmull_clark

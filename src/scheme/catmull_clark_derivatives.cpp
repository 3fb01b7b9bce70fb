// Around a regular vertex the surface is a bicubic B-spline, and these are its derivatives at a
// knot. On a sharp curve it ends as a natural spline does: the rules there are those of a spline
// with mirrored control points, so that the second derivative across is 0.
//
// At extraordinary vertices: Halstead, Kass, DeRose, Efficient, fair interpolation using
// Catmull-Clark surfaces, 1993, appendix A. The second derivatives' leading part there is made of
// the same two tangents, so that its direction says nothing new: they are left out.
#include "scheme/catmull_clark_derivatives.hpp"

#include <cmath>
#include <numbers>

namespace surpass::catmull_clark {
namespace {

std::size_t spoke_at(const FaceRing& ring, std::size_t j) { return 1 + j % ring.size(); }
std::size_t across(const FaceRing& ring, std::size_t j) {
  return ring.faces[j % ring.faces.size()][2];
}

Mask zero(const FaceRing& ring) { return Mask(ring.point_count(), 0.0); }

// The second difference of each of three neighbouring rows, weighted 1 4 1.
SpokeDerivatives at_regular(const FaceRing& ring, std::size_t s) {
  Mask first = zero(ring);
  Mask second = zero(ring);
  for (const std::size_t side : {0U, 2U}) {
    const double sign = side == 0 ? 1 : -1;
    const std::size_t left = across(ring, s + side);
    const std::size_t right = across(ring, s + side + 3);
    first[spoke_at(ring, s + side)] = sign * 4 / 12;
    first[left] = first[right] = sign / 12;
    second[spoke_at(ring, s + side)] = 4.0 / 6;
    second[left] = second[right] = 1.0 / 6;
    second[spoke_at(ring, s + side + 1)] = -2.0 / 6;
  }
  second[0] = -8.0 / 6;
  return {first, second};
}

// Along the sharp curve, a cubic B-spline.
SpokeDerivatives along_curve(const FaceRing& ring) {
  const auto sharp = ring.sharp_spokes();
  Mask first = zero(ring);
  Mask second = zero(ring);
  first[1 + sharp[0]] = 1.0 / 2;
  first[1 + sharp[1]] = -1.0 / 2;
  second[0] = -2;
  second[1 + sharp[0]] = second[1 + sharp[1]] = 1;
  return {first, second};
}

// Away from the sharp curve, along the only spoke between two faces.
SpokeDerivatives across_curve(const FaceRing& ring, std::size_t s) {
  const std::size_t n = ring.size();
  Mask first = zero(ring);
  first[0] = -4.0 / 6;
  first[1 + s] = 4.0 / 6;
  first[spoke_at(ring, s + 1)] = first[spoke_at(ring, s + n - 1)] = -1.0 / 6;
  first[across(ring, s)] = first[across(ring, s + ring.faces.size() - 1)] = 1.0 / 6;
  return {first, zero(ring)};
}

SpokeDerivatives on_crease(const FaceRing& ring, std::size_t s) {
  for (const Sector& sector : sectors(ring)) {
    const std::size_t inside = (s + ring.size() - sector.begin) % ring.size();
    if (inside == 0 || inside == sector.faces) return along_curve(ring);
    if (sector.faces == 2 && inside == 1) return across_curve(ring, s);
  }
  return {};
}

bool is_sharp(const FaceRing& ring, std::size_t s) {
  return is_infinite(ring.spoke_sharpness[s % ring.size()]);
}

}  // namespace

SpokeDerivatives spoke_derivatives(const FaceRing& ring, std::size_t spoke) {
  if (ring.is_semi_sharp()) return {};
  switch (ring.rule()) {
    case VertexRule::smooth:
      if (ring.size() == 4) return at_regular(ring, spoke);
      break;
    case VertexRule::crease: return on_crease(ring, spoke);
    case VertexRule::corner:
      if (is_sharp(ring, spoke)) {
        Mask first = zero(ring);
        first[0] = -1;
        first[1 + spoke] = 1;
        return {first, {}};
      }
      break;
    case VertexRule::dart: break;
  }
  return {};
}

std::optional<Mask> mixed_derivative(const FaceRing& ring, std::size_t face) {
  const bool one_fan = ring.faces.size() + (ring.open ? 1 : 0) == ring.size();
  if (ring.is_semi_sharp() || !one_fan) return {};
  Mask mask = zero(ring);
  if (ring.rule() == VertexRule::smooth && ring.size() == 4) {
    for (std::size_t j = 0; j < 4; ++j) mask[across(ring, face + j)] = j % 2 == 0 ? 0.25 : -0.25;
    return mask;
  }
  const bool sharp_before = is_sharp(ring, face);
  const bool sharp_after = is_sharp(ring, face + 1);
  if (ring.rule() == VertexRule::corner) {
    if (!sharp_before || !sharp_after) return {};
    mask[0] = mask[across(ring, face)] = 1;
    mask[spoke_at(ring, face)] = mask[spoke_at(ring, face + 1)] = -1;
    return mask;
  }
  if (ring.rule() != VertexRule::crease) return {};
  for (const Sector& sector : sectors(ring)) {
    const std::size_t inside = (face + ring.size() - sector.begin) % ring.size();
    if (sector.faces != 2 || inside > 1) continue;
    mask[across(ring, sector.begin)] = mask[spoke_at(ring, sector.begin + 2)] = 0.5;
    mask[across(ring, sector.begin + 1)] = mask[spoke_at(ring, sector.begin)] = -0.5;
    return mask;
  }
  return {};
}

std::optional<Mask> tangent_along(const FaceRing& ring, std::size_t spoke) {
  const std::size_t n = ring.size();
  if (ring.rule() != VertexRule::smooth || n == 2) return {};
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  const double c = std::cos(step);
  const double weight = 1 + c + std::cos(step / 2) * std::sqrt(2 * (9 + c));
  const double scale = 1 / (3.0 * static_cast<double>(n));
  Mask mask = zero(ring);
  for (std::size_t j = 0; j < n; ++j) {
    const double angle = step * static_cast<double>(j);
    mask[spoke_at(ring, spoke + j)] = scale * weight * std::cos(angle);
    mask[across(ring, spoke + j)] = scale * (std::cos(angle) + std::cos(angle + step));
  }
  return mask;
}

}  // namespace surpass::catmull_clark

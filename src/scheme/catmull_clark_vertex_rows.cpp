#include "scheme/catmull_clark_vertex_rows.hpp"

#include "scheme/catmull_clark_derivatives.hpp"

namespace surpass::catmull_clark {
namespace {

// The derivative of the sharp curve that leaves along a spoke: the cubic B-spline of its points,
// which ends at a corner with the second derivative 0.
Mask curve_tangent(const FaceRing& ring, std::size_t spoke) {
  Mask mask(ring.point_count(), 0.0);
  if (ring.rule() == VertexRule::corner) {
    mask[0] = -1;
    mask[1 + spoke] = 1;
    return mask;
  }
  for (const std::size_t j : ring.sharp_spokes()) mask[1 + j] = j == spoke ? 0.5 : -0.5;
  return mask;
}

Mask spoke_tangent(const FaceRing& ring, std::size_t spoke) {
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth) return tangent_along(ring, spoke).value_or(Mask());
  if (rule == VertexRule::dart || ring.spoke_sharpness[spoke] <= 0) return {};
  return curve_tangent(ring, spoke);
}

struct Plane {
  Tangents tangents;
  bool exists;  // and the tangents are no stand-ins
};

// The tangents of the sector that the face lies in; of a corner's sector without a tangent plane,
// those of the face itself.
Plane plane(const RingPlace& corner) {
  const FaceRing& ring = corner.ring;
  const VertexRule rule = ring.rule();
  const std::vector<Tangents> all = tangent_masks(ring);
  const std::size_t n = ring.size();
  if (rule == VertexRule::smooth) return {all.front(), n > 2};
  if (rule == VertexRule::dart) return {all.front(), true};
  // A corner that no two sharp edges cut has a sector for each face, none of which has a plane.
  const bool is_cut = ring.sharp_spokes().size() >= 2;
  std::size_t at = 0;
  for (const Sector& sector : sectors(ring)) {
    const bool by_face = rule == VertexRule::corner && sector.faces > 2;
    const std::size_t offset = (corner.face + n - sector.begin) % n;
    if (offset < sector.faces) return {all[at + (by_face ? offset : 0)], is_cut && !by_face};
    at += by_face ? sector.faces : 1;
  }
  return {all.front(), true};
}

}  // namespace

PlaceRows vertex_rows(const RingPlace& corner, std::size_t points) {
  const FaceRing& ring = corner.ring;
  const auto spread = [&](const Mask& mask) {
    Mask wide(mask.empty() ? 0 : points, 0.0);
    for (std::size_t i = 0; i < mask.size(); ++i) wide[ring.columns[i]] += mask[i];
    return wide;
  };
  PlaceRows rows;
  rows.position = spread(limit_mask(ring));
  rows.du = spread(spoke_tangent(ring, corner.face));
  rows.dv = spread(spoke_tangent(ring, corner.next_spoke()));
  const Plane there = plane(corner);
  rows.tangent_u = spread(there.tangents.first);
  rows.tangent_v = spread(there.tangents.second);
  rows.has_plane = there.exists;
  return rows;
}

}  // namespace surpass::catmull_clark

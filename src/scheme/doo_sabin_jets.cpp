// Derivatives of a uniform biquadratic B-spline surface at the centre of a patch: tensor products
// of (1, 6, 1) / 8, (-1, 0, 1) / 2 and (1, -2, 1). The vertex in the middle of nine that regular
// faces join is the control point of one patch.
#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_dual.hpp"

namespace surpass::doo_sabin {

Spot DooSabin::spot(const Topology& topology, const Sharpness& sharpness, Index v) const {
  return spot_among_quads(topology, sharpness, v);
}

LimitJet DooSabin::jet(const Mesh& mesh, const Topology& topology, Index v) const {
  const QuadRing ring = quad_ring(mesh, topology, v);
  const auto& e = ring.spokes;
  const auto& f = ring.across;
  LimitJet jet;
  jet.position =
      (36 * ring.center + 6 * (e[0] + e[1] + e[2] + e[3]) + f[0] + f[1] + f[2] + f[3]) / 64;
  jet.u = (6 * (e[0] - e[2]) + (f[0] - f[1]) + (f[3] - f[2])) / 16;
  jet.v = (6 * (e[1] - e[3]) + (f[0] - f[3]) + (f[1] - f[2])) / 16;
  jet.uu =
      (6 * bend(e[0], ring.center, e[2]) + bend(f[0], e[1], f[1]) + bend(f[3], e[3], f[2])) / 8;
  jet.vv =
      (6 * bend(e[1], ring.center, e[3]) + bend(f[0], e[0], f[3]) + bend(f[1], e[2], f[2])) / 8;
  jet.uv = ((f[0] - f[1]) + (f[2] - f[3])) / 4;
  return jet;
}

Result<LimitSamples> DooSabin::limit_samples(const Mesh& control, const Rules& rules, int levels,
                                             const Context& context) const {
  Steps steps;
  auto level = refined_level(control, rules, levels, context, steps);
  if (!level) return tl::make_unexpected(level.error());
  const auto sharpness = Sharpness::build(level->mesh, *level->topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  const Dual dual(*level);
  Mesh polygons;
  polygons.points = dual.limit_rows(rules.weights, context).apply(context, level->mesh.points);
  const std::vector<Index> vertices = dual.put_faces(polygons);

  LimitSamples samples;
  samples.mesh = std::move(level->mesh);
  fill_jets(samples, *level->topology, *sharpness, context);
  std::vector<unsigned char> is_hole(polygons.face_count(), 0);
  for (const Index f : polygons.hole_faces) is_hole[f] = 1;
  for (Index f = 0; f < polygons.face_count(); ++f) {
    if (is_hole[f] != 0) continue;
    samples.add_patch(std::span(&vertices[f], 1), polygon_area(polygons.points, polygons.face(f)));
  }
  return samples;
}

}  // namespace surpass::doo_sabin

// Derivatives of a uniform bicubic B-spline surface at a knot: tensor products of (1, 4, 1) / 6,
// (-1, 0, 1) / 2 and (1, -2, 1). They read the one-ring of a vertex only, which subdivision maps to
// itself, so they are exact whatever the vertices around are.
#include "scheme/catmull_clark.hpp"

namespace surpass::catmull_clark {

Spot CatmullClark::spot(const Topology& topology, const Sharpness& sharpness, Index v) const {
  return spot_among_quads(topology, sharpness, v);
}

LimitJet CatmullClark::jet(const Mesh& mesh, const Topology& topology, Index v) const {
  const QuadRing ring = quad_ring(mesh, topology, v);
  const auto& e = ring.spokes;
  const auto& f = ring.across;
  LimitJet jet;
  jet.position =
      (16 * ring.center + 4 * (e[0] + e[1] + e[2] + e[3]) + f[0] + f[1] + f[2] + f[3]) / 36;
  jet.u = (4 * (e[0] - e[2]) + (f[0] - f[1]) + (f[3] - f[2])) / 12;
  jet.v = (4 * (e[1] - e[3]) + (f[0] - f[3]) + (f[1] - f[2])) / 12;
  jet.uu =
      (4 * bend(e[0], ring.center, e[2]) + bend(f[0], e[1], f[1]) + bend(f[3], e[3], f[2])) / 6;
  jet.vv =
      (4 * bend(e[1], ring.center, e[3]) + bend(f[0], e[0], f[3]) + bend(f[1], e[2], f[2])) / 6;
  jet.uv = ((f[0] - f[1]) + (f[2] - f[3])) / 4;
  return jet;
}

}  // namespace surpass::catmull_clark

// Derivatives of the quartic box spline of three directions at a lattice point. Its derivative
// along a direction is a difference of the box spline with that direction taken once; taking two
// off leaves the hat function of the other two, which is 1 at one lattice point: so the second
// derivative along each direction is the plain second difference, exactly. They read the one-ring
// of a vertex only, which subdivision maps to itself.
#include <array>
#include <cmath>

#include "scheme/loop.hpp"

namespace surpass::loop {

Spot Loop::spot(const Topology& topology, const Sharpness& sharpness, Index v) const {
  if (topology.is_isolated(v) || topology.is_bowtie(v)) return Spot::extraordinary;
  if (!sharpness.is_plain(v)) return spot_on_curve(topology, sharpness, v, 3, 0);
  return topology.faces_at(v) == 6 ? Spot::regular : Spot::extraordinary;
}

double Loop::patch_measure() const { return std::sqrt(3.0) / 4; }

LimitJet Loop::jet(const Mesh& mesh, const Topology& topology, Index v) const {
  const Eigen::Vector3d center = position_of(mesh, v);
  std::array<Eigen::Vector3d, 6> p;
  std::size_t j = 0;
  topology.for_each_outgoing(
      v, [&](Index h) { p[j++] = position_of(mesh, topology.head(h)) - center; });
  const double root = std::sqrt(3.0);
  LimitJet jet;
  jet.position = center + (p[0] + p[1] + p[2] + p[3] + p[4] + p[5]) / 12;
  jet.u = (2 * (p[0] - p[3]) + (p[1] - p[4]) + (p[5] - p[2])) / 6;
  jet.v = root / 6 * ((p[1] - p[4]) + (p[2] - p[5]));
  // Along the spokes at 0, 60 and 120 degrees.
  const Eigen::Vector3d a = p[0] + p[3];
  const Eigen::Vector3d b = p[1] + p[4];
  const Eigen::Vector3d c = p[2] + p[5];
  jet.uu = a;
  jet.uv = (b - c) / root;
  jet.vv = (2 * (b + c) - a) / 3;
  return jet;
}

}  // namespace surpass::loop

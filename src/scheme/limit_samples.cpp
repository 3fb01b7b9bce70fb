#include "scheme/limit_samples.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "scheme/ring.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {

Spot spot_on_curve(const Topology& topology, const Sharpness& sharpness, Index v,
                   std::size_t smooth, std::size_t sharp) {
  const Ring ring = Ring::around(topology, sharpness, v);
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth || rule == VertexRule::dart) return Spot::extraordinary;
  const std::size_t regular = rule == VertexRule::crease ? smooth : sharp;
  const std::vector<Sector> parts = sectors(ring);
  const bool all = std::all_of(parts.begin(), parts.end(),
                               [&](const Sector& sector) { return sector.faces == regular; });
  return all ? Spot::curve : Spot::extraordinary;
}

Spot spot_among_quads(const Topology& topology, const Sharpness& sharpness, Index v) {
  if (topology.is_isolated(v) || topology.is_bowtie(v)) return Spot::extraordinary;
  bool quads = true;
  topology.for_each_outgoing(
      v, [&](Index h) { quads = quads && topology.face_degree(topology.face(h)) == 4; });
  if (!quads) return Spot::extraordinary;
  if (!sharpness.is_plain(v)) return spot_on_curve(topology, sharpness, v, 2, 1);
  return topology.faces_at(v) == 4 ? Spot::regular : Spot::extraordinary;
}

QuadRing quad_ring(const Mesh& mesh, const Topology& topology, Index v) {
  QuadRing ring;
  ring.center = position_of(mesh, v);
  std::size_t j = 0;
  topology.for_each_outgoing(v, [&](Index h) {
    ring.spokes[j] = position_of(mesh, topology.head(h));
    ring.across[j++] = position_of(mesh, topology.head(topology.next(h)));
  });
  return ring;
}

double polygon_area(std::span<const Point> points, std::span<const Index> polygon) {
  const auto at = [&](Index i) { return Eigen::Map<const Eigen::Vector3d>(points[i].data()); };
  const Eigen::Vector3d first = at(polygon[0]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += (at(polygon[k]) - first).cross(at(polygon[k + 1]) - first);
  }
  return sum.norm() / 2;
}

void SubdivisionScheme::fill_jets(LimitSamples& samples, const Topology& topology,
                                  const Sharpness& sharpness, const Context& context) const {
  samples.spots.resize(topology.vertex_count());
  samples.jets.resize(topology.vertex_count());
  parallel::for_ranges(context, topology.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      samples.spots[i] = spot(topology, sharpness, v);
      if (samples.spots[i] == Spot::regular) samples.jets[i] = jet(samples.mesh, topology, v);
    }
  });
}

Result<LimitSamples> SubdivisionScheme::limit_samples(const Mesh& control, const Rules& rules,
                                                      int levels, const Context& context) const {
  auto mesh = refine(control, rules, levels, context);
  if (!mesh) return tl::make_unexpected(mesh.error());
  const auto topology = Topology::build(*mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto sharpness = Sharpness::build(*mesh, *topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  const auto op = surpass::limit_operator(*mesh, *topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  const std::vector<Point> limits = op->rows.apply(context, mesh->points);

  LimitSamples samples;
  samples.mesh = std::move(*mesh);
  samples.patch_measure = patch_measure();
  fill_jets(samples, *topology, *sharpness, context);
  std::size_t hole = 0;
  const std::vector<Index>& holes = samples.mesh.hole_faces;
  for (Index f = 0; f < samples.mesh.face_count(); ++f) {
    if (hole < holes.size() && holes[hole] == f) {
      ++hole;
      continue;
    }
    const auto face = samples.mesh.face(f);
    samples.add_patch(face, polygon_area(limits, face));
  }
  return samples;
}

}  // namespace surpass

#include <Eigen/Dense>

#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"

namespace surpass::loop {
namespace {

using Vector = Eigen::Vector3d;

Vector position(const Mesh& mesh, Index v) {
  return Eigen::Map<const Vector>(mesh.points[v].data());
}

Vector unit(const Vector& v) {
  const double length = v.stableNorm();
  return length > 0 ? Vector(v / length) : Vector(Vector::Zero());
}

Vector evaluate(const std::vector<double>& mask, const std::vector<Vector>& points) {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < mask.size(); ++i) sum += mask[i] * points[i];
  return sum;
}

Vector normal_at(const Mesh& mesh, const LoopRing& given) {
  std::vector<Vector> points = {position(mesh, given.center)};
  for (const Index w : given.spokes) points.push_back(position(mesh, w));
  const LoopRing* ring = &given;
  SettledRing settled;
  if (!given.is_settled()) {
    settled = settle(given);
    std::vector<Vector> moved;
    for (const auto& mask : settled.weights) moved.push_back(evaluate(mask, points));
    points = std::move(moved);
    ring = &settled.ring;
  }
  Vector sum = Vector::Zero();
  for (const Tangents& sector : tangent_masks(*ring)) {
    sum += unit(evaluate(sector.first, points).cross(evaluate(sector.second, points)));
  }
  return unit(sum);
}

// Each fan of a bow-tie is a corner of its own.
Vector normal_at_bowtie(const Mesh& mesh, const Topology& topology, Index v) {
  Vector sum = Vector::Zero();
  topology.for_each_outgoing(v, [&](Index h) {
    const Vector a = position(mesh, topology.head(h)) - position(mesh, v);
    const Vector b = position(mesh, topology.tail(topology.previous(h))) - position(mesh, v);
    sum += unit(a.cross(b));
  });
  return unit(sum);
}

}  // namespace

Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                         Boundary boundary, const Context& context) {
  const auto sharpness = Sharpness::build(mesh, topology, boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  std::vector<Point> normals(topology.vertex_count(), Point{});
  parallel::for_ranges(context, normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      if (topology.is_isolated(v)) continue;
      const Vector n = topology.is_bowtie(v)
                           ? normal_at_bowtie(mesh, topology, v)
                           : normal_at(mesh, LoopRing::around(topology, *sharpness, boundary, v));
      normals[i] = {n[0], n[1], n[2]};
    }
  });
  return normals;
}

}  // namespace surpass::loop

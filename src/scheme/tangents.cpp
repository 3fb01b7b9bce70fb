#include "scheme/tangents.hpp"

#include <Eigen/Dense>

namespace surpass {
namespace {

using Vector = Eigen::Vector3d;

Vector position(const Mesh& mesh, Index v) {
  return Eigen::Map<const Vector>(mesh.points[v].data());
}

Vector evaluate(const Mask& mask, const std::vector<Vector>& points) {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < mask.size(); ++i) sum += mask[i] * points[i];
  return sum;
}

Point to_point(const Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Point normal_of(const Mesh& mesh, const NormalMasks& masks) {
  std::vector<Vector> points;
  points.reserve(masks.columns.size());
  for (const Index v : masks.columns) points.push_back(position(mesh, v));
  if (!masks.weights.empty()) {
    std::vector<Vector> refined;
    refined.reserve(masks.weights.size());
    for (const Mask& mask : masks.weights) refined.push_back(evaluate(mask, points));
    points = std::move(refined);
  }
  Vector sum = Vector::Zero();
  for (const Tangents& sector : masks.sectors) {
    sum += unit(evaluate(sector.first, points).cross(evaluate(sector.second, points)));
  }
  return to_point(unit(sum));
}

Point mean_face_normal(const Mesh& mesh, const Topology& topology, Index v) {
  Vector sum = Vector::Zero();
  topology.for_each_outgoing(v, [&](Index h) {
    const Vector a = position(mesh, topology.head(h)) - position(mesh, v);
    const Vector b = position(mesh, topology.tail(topology.previous(h))) - position(mesh, v);
    sum += unit(a.cross(b));
  });
  return to_point(unit(sum));
}

}  // namespace surpass

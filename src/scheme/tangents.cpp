#include "scheme/tangents.hpp"

#include <cmath>

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

/// Times a power of 2 that brings it near 1, if products of it could leave the range of doubles.
Vector tamed(const Vector& v) {
  constexpr double kSafe = 0x1p300;
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest < kSafe && largest > 1 / kSafe) return v;
  if (!v.allFinite() || largest == 0) return Vector::Zero();
  const int exponent = std::ilogb(largest);
  return v.unaryExpr([&](double x) { return std::scalbn(x, -exponent); });
}

Point to_point(const Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Eigen::Vector3d unit_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return unit(tamed(a).cross(tamed(b)));
}

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
    sum += unit_cross(evaluate(sector.first, points), evaluate(sector.second, points));
  }
  return to_point(unit(sum));
}

Point mean_face_normal(const Mesh& mesh, const Topology& topology, Index v) {
  Vector sum = Vector::Zero();
  topology.for_each_outgoing(v, [&](Index h) {
    const Vector a = position(mesh, topology.head(h)) - position(mesh, v);
    const Vector b = position(mesh, topology.tail(topology.previous(h))) - position(mesh, v);
    sum += unit_cross(a, b);
  });
  return to_point(unit(sum));
}

}  // namespace surpass

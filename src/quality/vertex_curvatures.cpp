// The shape operator at a vertex says how the normal turns along each of its edges; it is fitted to
// the normals at their other ends. Normals that were given (the limit's own) are taken, so a
// sphere's curvature is exact, and a torus's of second order.
#include <surpass/fairness.hpp>
#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "parallel/parallel.hpp"

namespace surpass {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// The entries a, b, c of the shape operator [a b; b c] by least squares.
struct ShapeFit {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();

  // Every direction counts the same: both sides are divided by the step's length.
  void add(const Vector2d& step, const Vector2d& turn) {
    const double weight = 1 / step.squaredNorm();
    const Vector3d first(step[0], step[1], 0);
    const Vector3d second(0, step[0], step[1]);
    squares += weight * (first * first.transpose() + second * second.transpose());
    right += weight * (turn[0] * first + turn[1] * second);
  }

  [[nodiscard]] VertexCurvature curvature() const {
    constexpr double kOneDirection = 1e-9;  // which does not say what the other one does
    if (!(squares.determinant() > kOneDirection * std::pow(squares.trace(), 3))) return {};
    const Vector3d shape = squares.ldlt().solve(right);
    return {(shape[0] + shape[2]) / 2, shape[0] * shape[2] - shape[1] * shape[1]};
  }
};

template <class Body>
void for_each_vertex(const Context& context, Index n, const Body& body) {
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) body(static_cast<Index>(v));
  });
}

// The faces' mean, weighted by their angles; zero where there is none.
Vector3d normal_of_faces(const Topology& topology, const Rows& points, Index v) {
  const auto along = [&](Index w) -> Vector3d { return (points.row(w) - points.row(v)); };
  Vector3d sum = Vector3d::Zero();
  topology.for_each_outgoing(v, [&](Index h) {
    const Vector3d a = along(topology.head(h));
    const Vector3d b = along(topology.tail(topology.previous(h)));
    const Vector3d cross = a.cross(b);
    sum += std::atan2(cross.norm(), a.dot(b)) * cross.stableNormalized();
  });
  return sum.stableNormalized();
}

Rows unit_normals(const Mesh& mesh, const Topology& topology, const Rows& points,
                  const Context& context) {
  const auto given = std::find_if(mesh.channels.begin(), mesh.channels.end(), [](const Channel& c) {
    return c.name == "normal" && c.width() == 3;
  });
  Rows normals = Rows::Zero(points.rows(), 3);
  for_each_vertex(context, topology.vertex_count(), [&](Index v) {
    Vector3d normal = Vector3d::Zero();
    if (given != mesh.channels.end()) normal = Vector3d::Map(&given->values[std::size_t{3} * v]);
    normal = normal.squaredNorm() > 0 ? Vector3d(normal.stableNormalized())
                                      : normal_of_faces(topology, points, v);
    normals.row(v) = normal.transpose();
  });
  return normals;
}

VertexCurvature curvature_at(const Topology& topology, const Rows& points, const Rows& normals,
                             Index v) {
  const Vector3d normal = normals.row(v);
  if (normal.isZero()) return {};
  Eigen::Matrix<double, 2, 3> plane;
  plane.row(0) = normal.unitOrthogonal();
  plane.row(1) = normal.cross(plane.row(0).transpose());
  ShapeFit fit;
  topology.for_each_neighbour(v, [&](Index w) {
    const Vector2d step = plane * (points.row(w) - points.row(v)).transpose();
    if (normals.row(w).isZero() || !(step.squaredNorm() > 0)) return;
    fit.add(step, plane * (normals.row(w) - normals.row(v)).transpose());
  });
  return fit.curvature();
}

}  // namespace

Result<std::vector<VertexCurvature>> vertex_curvatures(const Mesh& surface,
                                                       const Context& context) {
  if (surface.face_count() == 0) {
    return fail(ErrorCode::empty_mesh, "there are no faces, so there is no surface to measure");
  }
  const auto topology = Topology::build(surface);
  if (!topology) return tl::make_unexpected(topology.error());
  const Box box = bounding_box(surface.points);
  if (!std::isfinite(box.side())) {
    return fail(ErrorCode::not_finite, "a position is infinite or not a number");
  }
  // In a box where squares neither overflow nor vanish.
  const double unit = box.side() > 0 ? box.side() : 1;
  Rows points(surface.points.size(), 3);
  for_each_vertex(context, surface.vertex_count(), [&](Index v) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto c = static_cast<std::size_t>(k);
      points(v, k) = (surface.points[v][c] - box.low[c]) / unit;
    }
  });
  const Rows normals = unit_normals(surface, *topology, points, context);
  std::vector<VertexCurvature> found(surface.points.size());
  for_each_vertex(context, surface.vertex_count(), [&](Index v) {
    const VertexCurvature in_box = curvature_at(*topology, points, normals, v);
    found[v] = {in_box.mean / unit, in_box.gauss / unit / unit};
  });
  if (context.cancelled()) return fail(ErrorCode::cancelled, "the measurement was interrupted");
  return found;
}

}  // namespace surpass

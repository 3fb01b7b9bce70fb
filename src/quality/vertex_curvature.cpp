// The shape operator by least squares over the edges of a vertex, from given normals.
#include <surpass/curvature.hpp>
#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Dense>

#include "parallel/parallel.hpp"

namespace surpass {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const Channel* find_normals(const Mesh& mesh) {
  const auto found = std::find_if(mesh.channels.begin(), mesh.channels.end(), [](const Channel& c) {
    return c.name == "normal" && c.width() == 3;
  });
  return found == mesh.channels.end() ? nullptr : &*found;
}

Vector3d row(std::span<const double> values, Index v) {
  return Eigen::Map<const Vector3d>(values.data() + std::size_t{3} * v);
}

/// Mean and Gaussian curvature; zeros where the edges do not say them.
struct ShapeFit {
  Matrix3d squares = Matrix3d::Zero();  // normal equations for the entries a, b, c of [a b; b c]
  Vector3d right = Vector3d::Zero();

  // Every direction counts the same: both sides are divided by the step's length.
  void add(const Vector2d& step, const Vector2d& turn) {
    const double weight = 1 / step.squaredNorm();
    const Vector3d first(step[0], step[1], 0);
    const Vector3d second(0, step[0], step[1]);
    squares += weight * (first * first.transpose() + second * second.transpose());
    right += weight * (turn[0] * first + turn[1] * second);
  }

  [[nodiscard]] std::pair<double, double> curvatures() const {
    constexpr double kOneDirection = 1e-9;
    if (!(squares.determinant() > kOneDirection * std::pow(squares.trace(), 3))) return {0, 0};
    const Vector3d shape = squares.ldlt().solve(right);
    return {(shape[0] + shape[2]) / 2, shape[0] * shape[2] - shape[1] * shape[1]};
  }
};

std::pair<double, double> curvatures_at(const Topology& topology, std::span<const double> points,
                                        std::span<const double> normals, Index v) {
  const Vector3d normal = row(normals, v);
  if (normal.squaredNorm() == 0) return {0, 0};
  Eigen::Matrix<double, 2, 3> plane;
  plane.row(0) = normal.unitOrthogonal();
  plane.row(1) = normal.cross(plane.row(0).transpose());
  ShapeFit fit;
  topology.for_each_spoke(v, [&](Index w, Index) {
    const Vector3d other = row(normals, w);
    const Vector2d step = plane * (row(points, w) - row(points, v));
    if (other.squaredNorm() == 0 || !(step.squaredNorm() > 0)) return;
    fit.add(step, plane * (other - normal));
  });
  return fit.curvatures();
}

}  // namespace

Result<VertexCurvatures> vertex_curvatures(const Mesh& surface, const Context& context) {
  const Channel* normals = find_normals(surface);
  if (normals == nullptr || normals->values.size() != 3 * surface.points.size()) {
    return fail(ErrorCode::invalid_argument,
                "curvature is taken from vertex normals, and the mesh has none");
  }
  const auto topology = Topology::build(surface);
  if (!topology) return tl::make_unexpected(topology.error());
  VertexCurvatures found;
  found.mean.resize(surface.points.size());
  found.gauss.resize(surface.points.size());
  parallel::for_ranges(context, surface.points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::tie(found.mean[v], found.gauss[v]) =
          curvatures_at(*topology, flat(surface.points), normals->values, static_cast<Index>(v));
    }
  });
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while finding curvature");
  return found;
}

}  // namespace surpass

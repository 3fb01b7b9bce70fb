// S. Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 3DPVT 2004: over
// a triangle the shape operator is the one that best explains how the normal turns along the three
// sides; a vertex takes the mean of its triangles' operators, each turned into its own tangent
// plane. Normals that were given (the limit's own) are taken; so a sphere's curvature is exact.
#include <surpass/fairness.hpp>
#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <cmath>

#include <Eigen/Dense>

#include "parallel/parallel.hpp"

namespace surpass {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d point_of(const Mesh& mesh, Index v) {
  const Point& p = mesh.points[v];
  return {p[0], p[1], p[2]};
}

// Corners by their vertex, so that vertices can gather.
struct CornersOfVertices {
  explicit CornersOfVertices(const Mesh& mesh) : offsets(mesh.points.size() + 1, 0) {
    for (const Index v : mesh.face_vertices) ++offsets[v + 1];
    for (std::size_t v = 1; v < offsets.size(); ++v) offsets[v] += offsets[v - 1];
    std::vector<Index> next(offsets.begin(), offsets.end() - 1);
    corners.resize(mesh.face_vertices.size());
    for (Index c = 0; c < mesh.face_vertices.size(); ++c) {
      corners[next[mesh.face_vertices[c]]++] = c;
    }
  }
  [[nodiscard]] std::span<const Index> of(Index v) const {
    return std::span(corners).subspan(offsets[v], offsets[v + 1] - offsets[v]);
  }
  std::vector<Index> offsets;
  std::vector<Index> corners;
};

template <class Body>
void for_each_index(const Context& context, std::size_t n, const Body& body) {
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(static_cast<Index>(i));
  });
}

// What a triangle knows: its plane, its corners' shares, and its shape operator.
struct Patch {
  Vector3d normal = Vector3d::Zero();  // unit; zero for a triangle without area
  Vector3d angles = Vector3d::Zero();
  double area = 0;
  Matrix3d shape = Matrix3d::Zero();  // in space; the normal is in its kernel
};

class ShapeOperators {
 public:
  ShapeOperators(const Mesh& triangles, const Context& context)
      : mesh_(triangles), context_(context), around_(triangles), patches_(triangles.face_count()) {
    for_each_index(context_, patches_.size(), [&](Index f) { measure(f); });
    find_normals();
    for_each_index(context_, patches_.size(), [&](Index f) { patches_[f].shape = shape_of(f); });
  }

  [[nodiscard]] VertexCurvature curvature(Index v) const {
    const Vector3d& normal = normals_[v];
    Matrix3d sum = Matrix3d::Zero();
    double weight = 0;
    for (const Index c : around_.of(v)) {
      const Patch& patch = patches_[c / 3];
      if (patch.area == 0) continue;
      const Matrix3d turn =
          Eigen::Quaterniond::FromTwoVectors(patch.normal, normal).toRotationMatrix();
      sum += patch.area * (turn * patch.shape * turn.transpose());
      weight += patch.area;
    }
    if (weight == 0 || normal.isZero()) return {};
    const Matrix3d shape = sum / weight;
    const double trace = shape.trace();
    return {trace / 2, (trace * trace - (shape * shape).trace()) / 2};
  }

 private:
  [[nodiscard]] Vector3d corner(Index f, Index k) const {
    return point_of(mesh_, mesh_.face_vertices[3 * f + k % 3]);
  }

  void measure(Index f) {
    Patch& patch = patches_[f];
    const Vector3d cross = (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0));
    patch.area = cross.norm() / 2;
    if (patch.area == 0) return;
    patch.normal = cross.normalized();
    for (Index k = 0; k < 3; ++k) {
      const Vector3d a = corner(f, k + 1) - corner(f, k);
      const Vector3d b = corner(f, k + 2) - corner(f, k);
      patch.angles[k] = std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }

  // Given ones where they have a direction, else the faces' mean weighted by their angles.
  void find_normals() {
    const Channel* given = nullptr;
    for (const Channel& channel : mesh_.channels) {
      if (channel.name == "normal" && channel.width() == 3) given = &channel;
    }
    normals_.resize(mesh_.points.size());
    for_each_index(context_, normals_.size(), [&](Index v) {
      Vector3d normal = Vector3d::Zero();
      if (given != nullptr) normal = Vector3d::Map(&given->values[std::size_t{3} * v]);
      if (!(normal.squaredNorm() > 0)) {
        normal.setZero();
        for (const Index c : around_.of(v)) {
          normal += patches_[c / 3].angles[c % 3] * patches_[c / 3].normal;
        }
      }
      normals_[v] = normal.stableNormalized();
    });
  }

  [[nodiscard]] Matrix3d shape_of(Index f) const {
    const Patch& patch = patches_[f];
    if (patch.area == 0) return Matrix3d::Zero();
    const Vector3d x = (corner(f, 1) - corner(f, 0)).normalized();
    const Vector3d y = patch.normal.cross(x);
    // Unknown are the entries xx, xy, yy: two equations for each side.
    Eigen::Matrix<double, 6, 3> equations;
    Eigen::Matrix<double, 6, 1> turns;
    for (Index k = 0; k < 3; ++k) {
      const Vector3d side = corner(f, k + 1) - corner(f, k);
      const Vector3d turn = normals_[mesh_.face_vertices[3 * f + (k + 1) % 3]] -
                            normals_[mesh_.face_vertices[3 * f + k]];
      equations.row(2 * k) << side.dot(x), side.dot(y), 0;
      equations.row(2 * k + 1) << 0, side.dot(x), side.dot(y);
      turns[2 * k] = turn.dot(x);
      turns[2 * k + 1] = turn.dot(y);
    }
    const Vector3d w = equations.colPivHouseholderQr().solve(turns);
    return w[0] * x * x.transpose() + w[1] * (x * y.transpose() + y * x.transpose()) +
           w[2] * y * y.transpose();
  }

  const Mesh& mesh_;
  const Context& context_;
  CornersOfVertices around_;
  std::vector<Patch> patches_;
  std::vector<Vector3d> normals_;
};

// Without what the sums do not need, in a box where squares neither overflow nor vanish.
Mesh unit_triangles(const Mesh& surface, double unit, const Point& origin) {
  Mesh mesh;
  mesh.points = surface.points;
  mesh.face_offsets = surface.face_offsets;
  mesh.face_vertices = surface.face_vertices;
  for (const Channel& channel : surface.channels) {
    if (channel.name == "normal") mesh.channels.push_back(channel);
  }
  for (Point& p : mesh.points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] - origin[k]) / unit;
  }
  return all_triangles(mesh) ? mesh : triangulate(mesh).mesh;
}

}  // namespace

Result<std::vector<VertexCurvature>> vertex_curvatures(const Mesh& surface,
                                                       const Context& context) {
  if (surface.face_count() == 0) {
    return fail(ErrorCode::empty_mesh, "there are no faces, so there is no surface to measure");
  }
  if (const auto topology = Topology::build(surface); !topology) {
    return tl::make_unexpected(topology.error());
  }
  const Box box = bounding_box(surface.points);
  if (!std::isfinite(box.side())) {
    return fail(ErrorCode::not_finite, "a position is infinite or not a number");
  }
  const double unit = box.side() > 0 ? box.side() : 1;
  const Mesh mesh = unit_triangles(surface, unit, box.low);
  const ShapeOperators measured(mesh, context);
  std::vector<VertexCurvature> found(mesh.points.size());
  for_each_index(context, found.size(), [&](Index v) {
    const VertexCurvature in_box = measured.curvature(v);
    found[v] = {in_box.mean / unit, in_box.gauss / unit / unit};
  });
  if (context.cancelled()) return fail(ErrorCode::cancelled, "the measurement was interrupted");
  return found;
}

}  // namespace surpass

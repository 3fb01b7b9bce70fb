// A surface as a set of triangles, and the distance of points to it.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

namespace surpass {

/// A triangle prepared for distances to it. Triangles whose height is below 1e-8 of their longest
/// edge, where a normal means nothing, count as their edges; that shifts distances by less than the
/// height.
class SolidTriangle {
 public:
  SolidTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  [[nodiscard]] double squared_distance(const Eigen::Vector3d& p) const;
  [[nodiscard]] const Eigen::Vector3d& corner(std::size_t k) const { return corners_[k]; }
  /// False if the triangle counts as its edges.
  [[nodiscard]] bool has_inside() const { return has_inside_; }
  /// Height of p over the plane that stands on edge k, from corner k to the next; positive outside.
  [[nodiscard]] double beyond_edge(std::size_t k, const Eigen::Vector3d& p) const {
    return outward_[k].dot(p - corners_[k]);
  }
  [[nodiscard]] Eigen::AlignedBox3d box() const;
  [[nodiscard]] double area() const { return area_; }

 private:
  std::array<Eigen::Vector3d, 3> corners_;
  std::array<Eigen::Vector3d, 3> outward_;  // unit, in the plane
  Eigen::Vector3d normal_;                  // unit
  double area_;
  bool has_inside_;
};

/// A point with the nearest triangle of some surface.
struct Sample {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double distance = 0;
  Index triangle = 0;
};

/// Nearest triangles by a hierarchy of boxes. Immutable, so that threads may share it.
class TriangleTree {
 public:
  /// At least one triangle.
  explicit TriangleTree(std::vector<SolidTriangle> triangles);

  /// `guess` is any triangle; the nearer it is, the faster the search. O(log #triangles) usually.
  [[nodiscard]] Sample nearest(const Eigen::Vector3d& p, Index guess) const;
  [[nodiscard]] const std::vector<SolidTriangle>& triangles() const { return triangles_; }

 private:
  std::vector<SolidTriangle> triangles_;
  Eigen::KdBVH<double, 3, Index> boxes_;
};

}  // namespace surpass

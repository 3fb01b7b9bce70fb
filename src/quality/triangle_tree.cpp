#include "quality/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace surpass {
namespace {

using Eigen::Vector3d;

double squared_distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * along).squaredNorm();
}

// What Eigen's BVMinimize asks for. It starts from an infinite minimum; by answering "infinitely
// far" for boxes beyond the best triangle so far we make it start from the guess.
struct NearestTriangle {
  using Scalar = double;
  const std::vector<SolidTriangle>& triangles;
  Vector3d point;
  Index best;
  double best_distance;

  // NOLINTBEGIN(readability-identifier-naming): the names are Eigen's.
  double minimumOnVolume(const Eigen::AlignedBox3d& box) const {
    const double distance = box.squaredExteriorDistance(point);
    return distance < best_distance ? distance : std::numeric_limits<double>::infinity();
  }
  double minimumOnObject(Index t) {
    const double distance = triangles[t].squared_distance(point);
    if (distance < best_distance) {
      best_distance = distance;
      best = t;
    }
    return best_distance;
  }
  // NOLINTEND(readability-identifier-naming)
};

}  // namespace

SolidTriangle::SolidTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c)
    : corners_{a, b, c}, normal_((b - a).cross(c - a)) {
  constexpr double kNeedle = 1e-8;
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double doubled_area = normal_.norm();
  area_ = doubled_area / 2;
  has_inside_ = doubled_area > kNeedle * longest * longest;
  if (!has_inside_) {
    outward_.fill(Vector3d::Zero());
    return;
  }
  normal_ /= doubled_area;
  for (std::size_t k = 0; k < 3; ++k) {
    outward_[k] = (corners_[(k + 1) % 3] - corners_[k]).cross(normal_).normalized();
  }
}

double SolidTriangle::squared_distance(const Vector3d& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = has_inside_;
  for (std::size_t k = 0; k < 3; ++k) {
    // Seen from outside, the nearest point lies on an edge with the point beyond it.
    if (has_inside_ && beyond_edge(k, p) <= 0) continue;
    inside = false;
    nearest = std::min(nearest, squared_distance_to_segment(p, corners_[k], corners_[(k + 1) % 3]));
  }
  if (!inside) return nearest;
  const double height = normal_.dot(p - corners_[0]);
  return height * height;
}

Eigen::AlignedBox3d SolidTriangle::box() const {
  Eigen::AlignedBox3d box(corners_[0]);
  return box.extend(corners_[1]).extend(corners_[2]);
}

TriangleTree::TriangleTree(std::vector<SolidTriangle> triangles)
    : triangles_(std::move(triangles)) {
  std::vector<Index> numbers(triangles_.size());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles_.size());
  for (const SolidTriangle& t : triangles_) boxes.push_back(t.box());
  boxes_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

Sample TriangleTree::nearest(const Vector3d& p, Index guess) const {
  NearestTriangle search{triangles_, p, guess, triangles_[guess].squared_distance(p)};
  Eigen::BVMinimize(boxes_, search);
  return {p, std::sqrt(search.best_distance), search.best};
}

}  // namespace surpass

// The link condition is that of T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, Topology preserving
// edge contraction, Publications de l'Institut Mathematique 66 (1999), for surfaces.
#include "reconstruct/collapse_guards.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHighestValence = 10;
constexpr std::size_t kLowestValence = 3;
constexpr double kTurnCosine = 0.26;  // 75 degrees
const double kSharpestAngle = std::cos(10 * M_PI / 180);

// The cosine of the smallest angle: larger is sharper.
double sharpness(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a;
  const Vector3d bc = c - b;
  const Vector3d ca = a - c;
  const double ab2 = ab.squaredNorm();
  const double bc2 = bc.squaredNorm();
  const double ca2 = ca.squaredNorm();
  // The smallest angle lies opposite the shortest edge.
  if (ab2 <= bc2 && ab2 <= ca2) return bc2 > 0 ? -bc.dot(ca) / std::sqrt(bc2 * ca2) : 1;
  if (bc2 <= ca2) return ca2 > 0 && ab2 > 0 ? -ca.dot(ab) / std::sqrt(ca2 * ab2) : 1;
  return ab2 > 0 && bc2 > 0 ? -ab.dot(bc) / std::sqrt(ab2 * bc2) : 1;
}

}  // namespace

bool CollapseGuards::allow(Index v, Index w, std::span<const Index> around_v) {
  return keep_topology(v, w, around_v) && keep_shape(v, w);
}

bool CollapseGuards::has_more_than_least_valence(Index v) {
  std::size_t faces = 0;
  mesh_.for_each_corner(v, [&](Index) { ++faces; });
  if (faces > kLowestValence) return true;  // which have as many neighbours, or more at boundaries
  mesh_.neighbours(v, around_apex_);
  return around_apex_.size() > kLowestValence;
}

bool CollapseGuards::keep_topology(Index v, Index w, std::span<const Index> around_v) {
  std::size_t shared_faces = 0;
  bool apexes_can_lose_one = true;
  mesh_.for_each_corner(v, [&](Index c) {
    const Index a = mesh_.vertex(CollapseMesh::next(c));
    const Index b = mesh_.vertex(CollapseMesh::next(CollapseMesh::next(c)));
    if (a != w && b != w) return;
    ++shared_faces;
    apexes_can_lose_one = apexes_can_lose_one && has_more_than_least_valence(a == w ? b : a);
  });
  if (!apexes_can_lose_one) return false;
  mesh_.neighbours(w, around_w_);
  const auto common = static_cast<std::size_t>(
      std::count_if(around_v.begin(), around_v.end(), [&](Index u) { return mesh_.was_found(u); }));
  if (common != shared_faces) return false;
  // An edge with both ends on the boundary must lie on it.
  if (boundary_[v] != 0 && boundary_[w] != 0 && shared_faces != 1) return false;
  const std::size_t valence = around_v.size() - 1 + around_w_.size() - 1 - common;
  return valence <= std::max(kHighestValence, around_w_.size()) && valence >= kLowestValence;
}

bool CollapseGuards::keep_shape(Index v, Index w) const {
  const Vector3d& from = points_[v];
  const Vector3d& to = points_[w];
  const double longest = longest_edge_ * longest_edge_;
  double sharpest_before = kSharpestAngle;
  mesh_.for_each_corner(v, [&](Index c) {
    const Vector3d& a = points_[mesh_.vertex(CollapseMesh::next(c))];
    const Vector3d& b = points_[mesh_.vertex(CollapseMesh::next(CollapseMesh::next(c)))];
    sharpest_before = std::max(sharpest_before, sharpness(from, a, b));
  });
  bool fine = true;
  mesh_.for_each_corner(v, [&](Index c) {
    const Index i = mesh_.vertex(CollapseMesh::next(c));
    const Index j = mesh_.vertex(CollapseMesh::next(CollapseMesh::next(c)));
    if (!fine || i == w || j == w) return;
    const Vector3d& a = points_[i];
    const Vector3d& b = points_[j];
    if (longest > 0 && ((a - to).squaredNorm() > longest || (b - to).squaredNorm() > longest)) {
      fine = false;
      return;
    }
    const Vector3d before = (a - from).cross(b - from);
    const Vector3d after = (a - to).cross(b - to);
    const double lengths = std::sqrt(before.squaredNorm() * after.squaredNorm());
    fine = after.squaredNorm() > 0 && before.dot(after) >= kTurnCosine * lengths &&
           sharpness(to, a, b) <= sharpest_before;
  });
  return fine;
}

}  // namespace surpass::reconstruction

#include "quality/surface_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surpass {

using Eigen::Vector3d;

SurfacePiece::SurfacePiece(const TriangleTree& to, const std::array<Sample, 3>& corners)
    : corners_(corners) {
  const Vector3d centre = (corners[0].point + corners[1].point + corners[2].point) / 3;
  centre_ = to.nearest(centre, corners[0].triangle);
  bound(to);
}

void SurfacePiece::bound(const TriangleTree& to) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Index t :
       {centre_.triangle, corners_[0].triangle, corners_[1].triangle, corners_[2].triangle}) {
    double largest = 0;
    for (const Sample& corner : corners_) {
      largest = std::max(largest, to.triangles()[t].squared_distance(corner.point));
    }
    smallest = std::min(smallest, largest);
  }
  // At a corner the distance itself is known; rounding may put the bound below it.
  upper_bound_ = std::max(std::sqrt(smallest), farthest().distance);
}

const Sample& SurfacePiece::farthest() const {
  const auto& corner =
      *std::max_element(corners_.begin(), corners_.end(),
                        [](const Sample& a, const Sample& b) { return a.distance < b.distance; });
  return centre_.distance > corner.distance ? centre_ : corner;
}

double SurfacePiece::longest_edge() const {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, (corners_[(k + 1) % 3].point - corners_[k].point).squaredNorm());
  }
  return std::sqrt(longest);
}

double SurfacePiece::area() const {
  const Vector3d& a = corners_[0].point;
  return (corners_[1].point - a).cross(corners_[2].point - a).norm() / 2;
}

void SurfacePiece::bisect(const TriangleTree& to, std::vector<SurfacePiece>& parts) const {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double l = (corners_[(k + 1) % 3].point - corners_[k].point).squaredNorm();
    if (l > length) {
      length = l;
      longest = k;
    }
  }
  const Sample& a = corners_[longest];
  const Sample& b = corners_[(longest + 1) % 3];
  const Sample& c = corners_[(longest + 2) % 3];
  const Sample middle = to.nearest((a.point + b.point) / 2, centre_.triangle);
  parts.emplace_back(to, std::array{a, middle, c});
  parts.emplace_back(to, std::array{middle, b, c});
}

void SurfacePiece::cut(const TriangleTree& to, std::vector<SurfacePiece>& parts) const {
  constexpr double kShallow = 1e-3;  // of the piece: thinner slices would only multiply pieces
  const SolidTriangle& under = to.triangles()[centre_.triangle];
  std::array<double, 3> heights = {};
  double depth = 0;
  for (std::size_t edge = 0; edge < 3 && under.has_inside(); ++edge) {
    std::array<double, 3> beyond = {};
    for (std::size_t k = 0; k < 3; ++k) beyond[k] = under.beyond_edge(edge, corners_[k].point);
    const auto [low, high] = std::minmax_element(beyond.begin(), beyond.end());
    if (std::min(-*low, *high) <= depth) continue;
    depth = std::min(-*low, *high);
    heights = beyond;
  }
  if (depth <= kShallow * longest_edge()) return bisect(to, parts);

  // One corner is alone on its side of the plane.
  std::size_t alone = 0;
  while ((heights[alone] > 0) == (heights[(alone + 1) % 3] > 0) ||
         (heights[alone] > 0) == (heights[(alone + 2) % 3] > 0)) {
    ++alone;
  }
  const auto crossing = [&](std::size_t i, std::size_t j) {
    const double t = heights[i] / (heights[i] - heights[j]);
    const Vector3d p = corners_[i].point + t * (corners_[j].point - corners_[i].point);
    return to.nearest(p, centre_.triangle);
  };
  const std::size_t second = (alone + 1) % 3;
  const std::size_t third = (alone + 2) % 3;
  const Sample p = crossing(alone, second);
  const Sample q = crossing(alone, third);
  parts.emplace_back(to, std::array{corners_[alone], p, q});
  parts.emplace_back(to, std::array{p, corners_[second], corners_[third]});
  parts.emplace_back(to, std::array{p, corners_[third], q});
}

}  // namespace surpass

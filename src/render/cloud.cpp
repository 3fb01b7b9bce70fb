// H. Hoppe et al., Surface reconstruction from unorganized points, SIGGRAPH 1992: a point's normal
// is that of the plane through its neighbours.
#include "render/cloud.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <nanoflann.hpp>

#include "parallel/parallel.hpp"

namespace surpass::picture {
namespace {

constexpr std::size_t kNeighbours = 16;
constexpr std::size_t kChunk = 256;

// What nanoflann asks of a set of points.
struct Places {
  std::span<const Vec3> points;
  // NOLINTBEGIN(readability-identifier-naming): the names are nanoflann's.
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t k) const {
    return points[i][static_cast<Eigen::Index>(k)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
  // NOLINTEND(readability-identifier-naming)
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Places>,
                                                 Places, 3, Index>;

Vec3 normal_of(std::span<const Vec3> points, std::span<const Index> around) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index i : around) mean += points[i].cast<double>();
  mean /= static_cast<double>(around.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Index i : around) {
    const Eigen::Vector3d d = points[i].cast<double>() - mean;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  constexpr double kLine = 1e-6;  // of the largest spread: fewer than two directions, no plane
  if (!(solver.eigenvalues()[1] > kLine * solver.eigenvalues()[2])) return Vec3::Zero();
  return solver.eigenvectors().col(0).cast<float>();
}

}  // namespace

Cloud look_at_cloud(std::span<const Vec3> points, const Context& context) {
  Cloud cloud;
  cloud.normals.assign(points.size(), Vec3::Zero());
  if (points.size() < 2) return cloud;
  const Places places{points};
  const Tree tree(3, places, {16});
  std::vector<float> nearest(points.size(), 0);
  parallel::for_ranges(
      context, points.size(),
      [&](std::size_t begin, std::size_t end) {
        std::array<Index, kNeighbours> found = {};
        std::array<float, kNeighbours> squares = {};
        for (std::size_t i = begin; i < end && !context.cancelled(); ++i) {
          const std::size_t count =
              tree.knnSearch(points[i].data(), kNeighbours, found.data(), squares.data());
          cloud.normals[i] = normal_of(points, std::span(found).first(count));
          nearest[i] = std::sqrt(squares[1]);  // the first is the point itself
        }
      },
      kChunk);
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  cloud.spacing = *middle;
  return cloud;
}

}  // namespace surpass::picture

// Heights over a plane fall into two groups with more empty space between them than either fills.
// The plane of all neighbours tilts where a second sheet is seen on one side only, the plane of the
// nearest few follows scatter: the one that shows the wider space is taken.
#include "reconstruct/sheets.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/QR>

#include "reconstruct/local_fit.hpp"

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFew = 7;           // that hardly ever lie on two sheets
constexpr std::size_t kLeastInSheet = 3;  // fewer are stray points
constexpr double kBeside = 0.6;           // of the own group's radius

struct Space {
  double width = 0;  // 0 where there is none
  double middle = 0;
};

Space empty_space(std::vector<double> heights) {
  std::sort(heights.begin(), heights.end());
  Space space;
  double filled = 0;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const double width = heights[k] - heights[k - 1];
    if (width <= space.width) continue;
    space = {width, (heights[k] + heights[k - 1]) / 2};
    filled = std::max(heights[k - 1] - heights.front(), heights.back() - heights[k]);
  }
  return space.width > filled ? space : Space{};
}

// In the axes of a plane; point i comes first.
struct Neighbourhood {
  std::vector<Vector3d> local;
  Space space;
  [[nodiscard]] bool is_own(std::size_t k) const {
    return (local[k][2] > space.middle) == (local[0][2] > space.middle);
  }
};

Neighbourhood over_plane(std::span<const Point> points, std::span<const Index> all,
                         std::size_t of_first) {
  const LocalPlane plane = fit_plane(points, all.first(std::min(of_first, all.size())));
  Neighbourhood seen;
  std::vector<double> heights;
  for (const Index j : all) {
    seen.local.push_back(plane.local(points[j]));
    heights.push_back(seen.local.back()[2]);
  }
  seen.space = empty_space(std::move(heights));
  return seen;
}

// Two quadrics that differ by a constant, by least squares: how far apart they are.
double distance_of_parallels(const Neighbourhood& seen) {
  const auto n = static_cast<Eigen::Index>(seen.local.size());
  Eigen::MatrixXd terms(n, 7);
  Eigen::VectorXd heights(n);
  for (Eigen::Index r = 0; r < n; ++r) {
    const Vector3d& p = seen.local[static_cast<std::size_t>(r)];
    const double above = p[2] > seen.space.middle ? 1 : 0;
    terms.row(r) << above, 1, p[0], p[1], p[0] * p[0], p[0] * p[1], p[1] * p[1];
    heights[r] = p[2];
  }
  const Eigen::VectorXd found = terms.colPivHouseholderQr().solve(heights);
  return std::abs(found[0]) / std::hypot(1, found[2], found[3]);
}

// Behind an edge of the surface there is empty space, too, but the points lie beside the own ones.
bool lie_over_each_other(const Neighbourhood& seen) {
  Vector3d centres[2] = {Vector3d::Zero(), Vector3d::Zero()};
  std::size_t counts[2] = {0, 0};
  for (std::size_t k = 0; k < seen.local.size(); ++k) {
    centres[seen.is_own(k) ? 1 : 0] += seen.local[k];
    ++counts[seen.is_own(k) ? 1 : 0];
  }
  if (std::min(counts[0], counts[1]) < kLeastInSheet) return false;
  for (const int side : {0, 1}) centres[side] /= static_cast<double>(counts[side]);
  double sum = 0;
  for (std::size_t k = 0; k < seen.local.size(); ++k) {
    if (seen.is_own(k)) sum += (seen.local[k] - centres[1]).head<2>().squaredNorm();
  }
  const double radius = std::sqrt(sum / static_cast<double>(counts[1]));
  return (centres[1] - centres[0]).head<2>().norm() < kBeside * radius;
}

}  // namespace

Sheets tell_sheets(std::span<const Point> points, Index i, std::span<const Index> neighbours,
                   double least) {
  std::vector<Index> all = {i};
  all.insert(all.end(), neighbours.begin(), neighbours.end());
  Neighbourhood seen = over_plane(points, all, all.size());
  Neighbourhood by_few = over_plane(points, all, 1 + kFew);
  if (by_few.space.width > seen.space.width) seen = std::move(by_few);
  if (seen.space.width <= least) return {{neighbours.begin(), neighbours.end()}};
  Sheets sheets;
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (seen.is_own(k)) sheets.own.push_back(all[k]);
  }
  if (!lie_over_each_other(seen)) return sheets;
  const double distance = distance_of_parallels(seen);
  // Parallel sheets are as far apart as the empty space is wide, or more.
  if (distance >= seen.space.width) sheets.distance = distance;
  return sheets;
}

}  // namespace surpass::reconstruction

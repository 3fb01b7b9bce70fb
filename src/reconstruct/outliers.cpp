// Points that stand alone: their neighbours are far, and they are not where these neighbours would
// have a surface. Thin places of an uneven sampling have far neighbours too, but lie among them.
#include <algorithm>
#include <cmath>

#include "reconstruct/cloud.hpp"
#include "reconstruct/local_fit.hpp"
#include "reconstruct/point_loop.hpp"

namespace surpass::reconstruction {
namespace {

constexpr std::size_t kNeighbours = 12;
constexpr double kFar = 1.8;         // root mean square distance, in spacings: suspicious
constexpr double kVeryFar = 3;       // beyond what random samples of a surface show
constexpr double kOffSurface = 0.5;  // spacings from the neighbours' plane
constexpr double kMostLeftOut = 0.1;

enum Suspicion : unsigned char { regular, alone, far_alone };

Suspicion suspicion(const Cloud& cloud, Index i, const std::vector<Index>& near, double spacing) {
  const Point& p = cloud.points[i];
  double sum = 0;
  for (const Index j : near) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = cloud.points[j][k] - p[k];
      sum += d * d;
    }
  }
  const double reach = std::sqrt(sum / static_cast<double>(near.size()));
  if (reach <= kFar * spacing) return regular;
  const Point& nearest = cloud.points[near.front()];
  const bool is_isolated =
      std::hypot(nearest[0] - p[0], nearest[1] - p[1], nearest[2] - p[2]) > kVeryFar * spacing;
  const LocalPlane plane = fit_plane(cloud.points, near);
  if (!is_isolated && std::abs(plane.local(p)[2]) <= kOffSurface * spacing) return regular;
  return reach > kVeryFar * spacing ? far_alone : alone;
}

}  // namespace

Result<std::vector<unsigned char>> find_outliers(const Cloud& cloud, const Neighbours& neighbours,
                                                 double spacing, bool always,
                                                 const Context& context) {
  std::vector<unsigned char> found(cloud.points.size(), regular);
  const auto done =
      for_points(context, "outliers", found.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<Index> near;
        for (const Index i : neighbours.in_space().subspan(begin, end - begin)) {
          neighbours.nearest(i, kNeighbours, near);
          found[i] = suspicion(cloud, i, near, spacing);
        }
      });
  if (!done) return tl::make_unexpected(done.error());
  const auto far = std::count(found.begin(), found.end(), far_alone);
  const auto fine = std::count(found.begin(), found.end(), regular);
  const double left_out = 1 - static_cast<double>(fine) / static_cast<double>(found.size());
  if (!always && (far == 0 || left_out >= kMostLeftOut)) {
    std::fill(found.begin(), found.end(), regular);
  }
  for (unsigned char& f : found) f = f == regular ? 0 : 1;
  return found;
}

}  // namespace surpass::reconstruction

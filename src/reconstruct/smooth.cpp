#include "reconstruct/cloud.hpp"
#include "reconstruct/local_fit.hpp"
#include "reconstruct/point_loop.hpp"

namespace surpass::reconstruction {

Result<std::vector<Point>> smooth(const Cloud& cloud, unsigned passes, const Context& context) {
  constexpr std::size_t kNeighbours = 24;
  std::vector<Point> points = cloud.points;
  for (unsigned pass = 0; pass < passes; ++pass) {
    const Neighbours neighbours(points);
    std::vector<Point> moved = points;
    const auto done =
        for_points(context, "smooth", points.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Index> near;
          for (const Index i : neighbours.in_space().subspan(begin, end - begin)) {
            neighbours.nearest(i, kNeighbours, near);
            if (near.size() < 6) continue;
            moved[i] = fit_quadric(points, i, near).projected;
          }
        });
    if (!done) return tl::make_unexpected(done.error());
    points = std::move(moved);
  }
  return points;
}

}  // namespace surpass::reconstruction

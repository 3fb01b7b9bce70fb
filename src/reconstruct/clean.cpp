#include <array>
#include <cmath>

#include <fmt/format.h>

#include "mesh/coincident.hpp"
#include "reconstruct/cloud.hpp"

namespace surpass::reconstruction {
namespace {

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}  // namespace

Result<Cloud> clean(std::span<const Point> given) {
  Cloud cloud;
  const std::vector<Index> target = merge_targets(given, 0);
  for (Index i = 0; i < given.size(); ++i) {
    if (!is_finite(given[i])) {
      ++cloud.not_finite;
    } else if (target[i] != i) {
      ++cloud.duplicates;
    } else {
      cloud.points.push_back(given[i]);
      cloud.source.push_back(i);
    }
  }
  if (cloud.points.size() < 4) {
    return fail(ErrorCode::empty_mesh,
                fmt::format("a surface needs at least four different points, but there are {} ({} "
                            "given, {} not finite, {} duplicates)",
                            cloud.points.size(), given.size(), cloud.not_finite, cloud.duplicates));
  }
  const Box box = bounding_box(cloud.points);
  cloud.box_side = box.side();
  if (!std::isfinite(cloud.box_side)) {
    return fail(ErrorCode::too_large, "the points are so far apart that their distance overflows");
  }
  if (!std::isnormal(cloud.box_side)) {
    return fail(ErrorCode::too_large, "the points are so near that their distances underflow");
  }
  for (Point& p : cloud.points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] - box.low[k]) / cloud.box_side;
  }
  return cloud;
}

Cloud subset(const Cloud& cloud, const std::vector<unsigned char>& keep) {
  Cloud chosen;
  chosen.not_finite = cloud.not_finite;
  chosen.duplicates = cloud.duplicates;
  chosen.box_side = cloud.box_side;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (keep[i] == 0) continue;
    chosen.points.push_back(cloud.points[i]);
    chosen.source.push_back(cloud.source[i]);
  }
  return chosen;
}

}  // namespace surpass::reconstruction

#include "scheme/limit_points.hpp"

#include "mesh/common_part.hpp"

namespace surpass {

std::vector<Point> limit_points(const SparseRows& rows, std::span<const Point> points,
                                const Context& context) {
  const Point common = common_part(bounding_box(points));
  if (!is_far(common)) return rows.apply(context, points);
  std::vector<Point> near(points.begin(), points.end());
  add_common(near, common, -1);
  std::vector<Point> limits = rows.apply(context, near);
  add_common(limits, common, 1);
  return limits;
}

}  // namespace surpass

#include "mesh/common_part.hpp"

namespace surpass {

Point common_part(const Box& box) {
  Point common = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.low[k];
    const double high = box.high[k];
    const bool alike = (low > 0 && high <= 2 * low) || (high < 0 && low >= 2 * high);
    if (alike) common[k] = low + (high - low) / 2;
  }
  return common;
}

bool is_far(const Point& common) { return common != Point{}; }

void add_common(std::span<Point> points, const Point& common, double sign) {
  for (Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] += sign * common[k];
  }
}

}  // namespace surpass

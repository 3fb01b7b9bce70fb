// Kept points are listed by the cell of a hashed grid that they fall into. A cell is four distances
// wide: few neighbourhoods reach over its border, and it holds only so many points so far apart.
#include "mesh/coincident.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace surpass {
namespace {

struct PointHash {
  std::size_t operator()(const Point& p) const {
    std::uint64_t h = 0;
    for (const double x : p) {
      h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

class Grid {
 public:
  Grid(std::span<const Point> points, double distance)
      : points_(points), distance_(distance), cell_(4 * distance), next_(points.size(), kNone) {
    last_in_cell_.reserve(points.size());
  }

  // The smallest kept point within the distance, or kNone.
  [[nodiscard]] Index find(const Point& p) const {
    Index found = kNone;
    std::array<Point, 2> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      ends[0][k] = cell_of(p[k] - distance_);
      ends[1][k] = cell_of(p[k] + distance_);
    }
    for (unsigned side = 0; side < 8; ++side) {
      Point cell;
      bool seen = false;  // in a neighbourhood inside one cell the two ends are the same
      for (std::size_t k = 0; k < 3; ++k) {
        const bool high = (side >> k & 1) != 0;
        cell[k] = ends[high ? 1 : 0][k];
        seen = seen || (high && ends[0][k] == ends[1][k]);
      }
      if (!seen) found = std::min(found, find_in(cell, p));
    }
    return found;
  }

  void keep(Index v) {
    const Point& p = points_[v];
    Index& last = last_in_cell_.try_emplace({cell_of(p[0]), cell_of(p[1]), cell_of(p[2])}, kNone)
                      .first->second;
    next_[v] = last;
    last = v;
  }

 private:
  // Rounding keeps the order of numbers, so whatever is within the distance lies between the ends.
  // Adding 0 makes -0 and 0 one cell.
  [[nodiscard]] double cell_of(double x) const {
    return (cell_ > 0 ? std::floor(x / cell_) : x) + 0.0;
  }

  [[nodiscard]] Index find_in(const Point& cell, const Point& p) const {
    Index found = kNone;
    const auto last = last_in_cell_.find(cell);
    if (last == last_in_cell_.end()) return found;
    for (Index v = last->second; v != kNone; v = next_[v]) {
      const Point& q = points_[v];
      if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance_) found = v;
    }
    return found;  // lists run from large to small numbers
  }

  std::span<const Point> points_;
  double distance_;
  double cell_;
  std::unordered_map<Point, Index, PointHash> last_in_cell_;
  std::vector<Index> next_;
};

}  // namespace

std::vector<Index> merge_targets(std::span<const Point> points, double distance) {
  Grid kept(points, distance);
  std::vector<Index> target(points.size());
  for (Index v = 0; v < points.size(); ++v) {
    const Point& p = points[v];
    target[v] = v;
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
    if (const Index other = kept.find(p); other != kNone) {
      target[v] = other;
    } else {
      kept.keep(v);
    }
  }
  return target;
}

}  // namespace surpass

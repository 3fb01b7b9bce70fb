#include "io/point_table.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace surpass::io {
namespace {

// Adding zero makes one bit pattern of both zeros. The multiplier spreads every bit upwards.
std::size_t hash(const Point& point) {
  std::uint64_t mixed = 0;
  for (const double x : point) {
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;
    mixed ^= mixed >> 32U;
  }
  return static_cast<std::size_t>(mixed);
}

}  // namespace

Index PointTable::find_or_add(const Point& point, std::vector<Point>& points) {
  if (2 * (points.size() + 1) > slots_.size()) grow(points);
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(point) & mask;
  while (slots_[slot] != kNone) {
    if (points[slots_[slot]] == point) return slots_[slot];
    slot = (slot + 1) & mask;
  }
  slots_[slot] = static_cast<Index>(points.size());
  points.push_back(point);
  return slots_[slot];
}

void PointTable::grow(const std::vector<Point>& points) {
  const std::size_t size = std::max<std::size_t>(64, 2 * slots_.size());
  slots_.assign(size, kNone);
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::size_t slot = hash(points[v]) & (size - 1);
    while (slots_[slot] != kNone) slot = (slot + 1) & (size - 1);
    slots_[slot] = static_cast<Index>(v);
  }
}

}  // namespace surpass::io

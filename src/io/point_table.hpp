// Numbers for different points, in the order of their first occurrence.
#pragma once

#include <surpass/mesh.hpp>

#include <vector>

namespace surpass::io {

/// A hash table with open addressing over the points themselves.
class PointTable {
 public:
  /// The number of an equal point (0 equals -0), which is added to `points` if it is new.
  Index find_or_add(const Point& point, std::vector<Point>& points);

 private:
  void grow(const std::vector<Point>& points);

  std::vector<Index> slots_;  // a power of two of them, at most half in use
};

}  // namespace surpass::io

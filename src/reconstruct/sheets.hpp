// Whether a second sheet of the surface runs through the neighbourhood of a point.
#pragma once

#include <surpass/mesh.hpp>

#include <optional>
#include <span>
#include <vector>

namespace surpass::reconstruction {

/// A point's neighbours, told apart.
struct Sheets {
  std::vector<Index> own;  ///< neighbours on the point's side of the empty space, nearest first
  /// From sheet to sheet, where what is on the other side is one: at least three points that lie
  /// over the own ones, not beside them as behind an edge.
  std::optional<double> distance = {};
};

/// `neighbours` nearest first, point i left out; `least` is the width of the empty space from which
/// on it counts. Linear in the neighbours, but for sorting them.
[[nodiscard]] Sheets tell_sheets(std::span<const Point> points, Index i,
                                 std::span<const Index> neighbours, double least);

}  // namespace surpass::reconstruction

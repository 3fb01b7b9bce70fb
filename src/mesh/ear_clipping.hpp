// Cutting a polygon into triangles.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass {

/// Ear clipping, the ear with the shortest diagonal first. Keeps its buffers from polygon to
/// polygon.
class EarClipping {
 public:
  /// Three positions in the polygon's own list of corners, in its direction.
  using Triangle = std::array<Index, 3>;

  /// k - 2 triangles of a polygon of k >= 3 corners; the result is valid until the next call. The
  /// polygon is looked at along the largest component of its mean normal. Where it is simple in
  /// that view all triangles have positive area and none overlap, up to rounding; other polygons
  /// are cut along the shortest diagonals. O(k log k) if convex. Else each of about 2 k tests for
  /// an ear looks at the grid cells that the triangle's box covers: nearly linear for usual
  /// outlines, O(k^2) at worst.
  const std::vector<Triangle>& operator()(std::span<const Point> polygon);

 private:
  struct Candidate {
    double length;
    Index tip;
    Index stamp;  // of the tip when the length was taken; older candidates no longer hold
    // Of a heap the largest comes first: the shortest diagonal, and of equal ones the first tip.
    bool operator<(const Candidate& other) const {
      return length != other.length ? length > other.length : tip > other.tip;
    }
  };
  using Point2 = std::array<double, 2>;

  void project(std::span<const Point> polygon);
  void link(Index k);
  void list_blockers();
  void consider(Index tip);
  void clip(Index tip);
  [[nodiscard]] double turn(Index a, Index b, Index c) const;
  [[nodiscard]] bool is_ear(Index tip) const;
  [[nodiscard]] bool blocks(Index v, Index tip) const;
  [[nodiscard]] std::size_t cell(double x, std::size_t axis) const;

  std::vector<Point> local_;  // relative to the first corner, in units of the polygon's box
  std::vector<Point2> flat_;  // in view
  std::vector<Index> previous_;
  std::vector<Index> next_;
  std::vector<Index> stamp_;
  std::vector<unsigned char> clipped_;
  std::vector<Candidate> heap_;
  std::vector<Triangle> triangles_;

  // Blockers, the corners that are not convex, by the cells of a grid over the view.
  std::size_t side_ = 0;  // cells along a side; 0 without blockers
  Point2 low_ = {};
  Point2 extent_ = {};
  std::vector<Index> cell_begin_;
  std::vector<Index> cell_items_;
};

}  // namespace surpass

// The edges of any faces, manifold or not, with the half-edges at each.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass {

/// Edges in the order of their smaller and then of their larger end vertex. Half-edge h is face
/// corner h and runs to the face's next corner.
class EdgeTable {
 public:
  /// Indices must be in range in all faces f with skip[f] == 0; the others are left out, and so are
  /// half-edges from a vertex to itself. `skip` may be empty. O(#corners log #corners).
  explicit EdgeTable(const Mesh& mesh, std::span<const unsigned char> skip = {});

  [[nodiscard]] Index edge_count() const { return static_cast<Index>(begin_.size() - 1); }
  /// Ascending.
  [[nodiscard]] std::span<const Index> halfedges(Index e) const {
    return std::span(halfedges_).subspan(begin_[e], begin_[e + 1] - begin_[e]);
  }
  /// The smaller vertex first.
  [[nodiscard]] std::array<Index, 2> vertices(Index e) const { return vertices_[e]; }
  /// True if the half-edge runs from the smaller to the larger vertex of its edge.
  [[nodiscard]] bool ascends(Index h) const { return ascends_[h] != 0; }
  /// kNone where the half-edge was left out.
  [[nodiscard]] Index edge(Index h) const { return edge_[h]; }
  /// Two faces meet here, in opposite directions.
  [[nodiscard]] bool is_regular(Index e) const {
    const auto sides = halfedges(e);
    return sides.size() == 2 && ascends(sides[0]) != ascends(sides[1]);
  }

 private:
  std::vector<Index> begin_ = {0};
  std::vector<Index> halfedges_;
  std::vector<std::array<Index, 2>> vertices_;
  std::vector<Index> edge_;
  std::vector<unsigned char> ascends_;
};

}  // namespace surpass

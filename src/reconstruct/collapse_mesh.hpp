// A triangle mesh whose vertices can be merged into neighbours.
#pragma once

#include <surpass/mesh.hpp>

#include <array>
#include <span>
#include <vector>

namespace surpass::reconstruction {

/// Faces around a vertex hang on a list through their corners (corner c is corner c % 3 of face
/// c / 3), in no particular order. Faces that are gone are on no list.
class CollapseMesh {
 public:
  explicit CollapseMesh(const Mesh& mesh);

  [[nodiscard]] std::size_t vertex_count() const { return first_.size(); }
  [[nodiscard]] std::size_t face_count() const { return vertices_.size() / 3; }
  [[nodiscard]] bool is_gone(Index f) const { return gone_[f] != 0; }
  [[nodiscard]] Index vertex(Index corner) const { return vertices_[corner]; }
  [[nodiscard]] static Index next(Index corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  /// Calls visit(corner) for the corner at v of every face there.
  template <class Visit>
  void for_each_corner(Index v, Visit&& visit) const {
    for (Index c = first_[v]; c != kNone; c = next_[c]) visit(c);
  }

  /// The vertices that share a face with v, each once, into `found`.
  void neighbours(Index v, std::vector<Index>& found);

  /// Whether u was among those that neighbours() found last.
  [[nodiscard]] bool was_found(Index u) const { return round_of_[u] == round_; }

  /// Merges v into its neighbour w: faces of both disappear, the others of v go to w.
  void collapse(Index v, Index w);

 private:
  void unlink(Index corner);

  std::vector<Index> vertices_;  // a vertex per corner
  std::vector<Index> first_;     // #V: a corner at the vertex
  std::vector<Index> next_;      // #corners: another one at the same vertex
  std::vector<unsigned char> gone_;
  std::vector<Index> round_of_;  // #V: the call of neighbours() that found it last
  Index round_ = 0;
};

}  // namespace surpass::reconstruction

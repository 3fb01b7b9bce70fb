// The faces around a vertex as one patch. Most quads of a refined mesh have one corner, a vertex of
// the given mesh, that may be irregular, and three that are not: with all faces at that corner, the
// number of these is all that there is to know.
#pragma once

#include <surpass/topology.hpp>

#include <span>
#include <vector>

#include "scheme/sharpness.hpp"

namespace surpass {

/// Finds them. A star's vertices are its centre, then six for each of its faces, counterclockwise:
/// in coordinates with the centre at (0, 0) and the face on the unit square, those at (1, 0),
/// (1, 1), (2, 0), (2, 1), (2, 2) and (1, 2).
class Stars {
 public:
  static constexpr Index kFewestFaces = 3;
  /// Matrices grow with the square of that.
  static constexpr Index kMostFaces = 16;
  static constexpr std::size_t kPerFace = 6;

  /// Of a mesh of quads. `sampled`: #F, or empty for all.
  Stars(const Topology& topology, const Sharpness& sharpness,
        std::span<const unsigned char> sampled)
      : topology_(topology),
        sharpness_(sharpness),
        sampled_(sampled),
        seen_(topology.vertex_count(), kNone) {}

  /// Whether there is one around v: its faces begin there, are sampled, and have regular corners
  /// otherwise; across each of their outer sides there is a sampled face which numbers the side 2
  /// if they number it 1, and 1 if 2; and the vertices that they need are all different. To be
  /// asked once for each vertex.
  bool find(Index v);
  /// Of the one found last.
  [[nodiscard]] std::span<const Index> vertices() const { return vertices_; }

 private:
  bool add_face(Index h);
  [[nodiscard]] bool is_regular(Index v) const {
    return topology_.faces_at(v) == 4 && sharpness_.is_plain(v);
  }
  [[nodiscard]] bool is_beside(Index o, Index side) const {
    return o % 4 == side && (sampled_.empty() || sampled_[topology_.face(o)] != 0);
  }
  [[nodiscard]] bool all_different();

  const Topology& topology_;
  const Sharpness& sharpness_;
  std::span<const unsigned char> sampled_;
  std::vector<Index> seen_;  // #V: the last centre that a vertex was looked at for
  std::vector<Index> vertices_;
};

}  // namespace surpass

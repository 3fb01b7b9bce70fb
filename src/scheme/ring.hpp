// A vertex and its spokes, cut out of the mesh: what the rules at sharp and boundary vertices need.
#pragma once

#include <surpass/topology.hpp>

#include <vector>

#include "scheme/sharpness.hpp"

namespace surpass {

/// The rule at a vertex, from the number of sharp edges there. Order and meaning are OpenSubdiv's.
enum class VertexRule { smooth, dart, crease, corner };

/// Spokes run counterclockwise; in an open ring the first and the last lie on the boundary.
struct Ring {
  Index center = 0;
  float sharpness = 0;  ///< of the center
  bool open = false;
  std::vector<Index> spokes;           ///< neighbour vertices
  std::vector<float> spoke_sharpness;  ///< of the edges to them

  [[nodiscard]] std::size_t size() const { return spokes.size(); }
  [[nodiscard]] VertexRule rule() const;
  /// Positions in `spokes` of the sharp edges, ascending.
  [[nodiscard]] std::vector<std::size_t> sharp_spokes() const;
  /// Some sharpness will run out after refinements.
  [[nodiscard]] bool is_semi_sharp() const;
  /// The ring of the child vertex: the same spokes, sharpness decreased.
  [[nodiscard]] Ring child() const;

  static Ring around(const Topology& topology, const Sharpness& sharpness, Index v);
};

/// Consecutive faces between two sharp spokes: spokes begin .. begin + faces, modulo the size.
struct Sector {
  std::size_t begin;
  std::size_t faces;
};
/// The sectors of a crease or corner ring. A sharp vertex with fewer than two sharp edges is a tip,
/// each of whose faces is a sector of its own.
[[nodiscard]] std::vector<Sector> sectors(const Ring& ring);

/// How much of the parent's rule remains where the child's differs: the mean of the sharpnesses
/// that run out in this step (OpenSubdiv's uniform creasing; computed in float as there).
[[nodiscard]] float transitional_weight(const Ring& parent, const Ring& child);

}  // namespace surpass

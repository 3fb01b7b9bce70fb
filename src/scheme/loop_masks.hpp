// Masks of Loop subdivision around one vertex. Masks are weights in the order center, spokes.
//
// Loop, Smooth subdivision surfaces based on triangles, 1987 (interior rules);
// Hoppe et al., Piecewise smooth surface reconstruction, 1994 (rule `hoppe`);
// creases as OpenSubdiv has them, but for the limit at darts, which is exact here.
#pragma once

#include <array>
#include <vector>

#include "scheme/ring.hpp"
#include "scheme/settle.hpp"
#include "scheme/tangents.hpp"

namespace surpass::loop {

/// Weight that the vertex rule moves to the ring of a vertex of valence n: 5/8 - (3/8 +
/// cos(2pi/n)/4)^2.
[[nodiscard]] double alpha(std::size_t n);

/// Weight of the center in the interior limit mask, equation (3) of the paper.
[[nodiscard]] double beta(std::size_t n);

/// The third vertex of the triangle of a half-edge.
[[nodiscard]] inline Index across(const Topology& topology, Index h) {
  return topology.tail(topology.previous(h));
}

/// A ring and, under the rule `hoppe`, which of its boundary vertices are regular (valence 4).
struct LoopRing : Ring {
  Boundary boundary = Boundary::edge_and_corner;
  bool center_regular = false;
  std::array<bool, 2> end_regular = {};  ///< of the first and the last spoke of an open ring

  /// On the boundary curve under `hoppe`, with no crease coming in.
  [[nodiscard]] bool is_hoppe_curve() const;
  /// Refinement changes nothing any more: no sharpness fades, and on a curve under `hoppe` both
  /// neighbours are regular.
  [[nodiscard]] bool is_settled() const;
  [[nodiscard]] LoopRing child() const;
  [[nodiscard]] std::size_t point_count() const { return size() + 1; }
  [[nodiscard]] std::vector<Mask> child_masks() const;
  static LoopRing around(const Topology& topology, const Sharpness& sharpness, Boundary boundary,
                         Index v);
};

/// Refined position of the center.
[[nodiscard]] Mask vertex_mask(const LoopRing& ring);

/// Limit position of the center, semi-sharp rings included.
[[nodiscard]] Mask limit_mask(const LoopRing& ring);

/// The new points on the spokes: mask j is for the edge from the center to spoke j.
[[nodiscard]] Mask spoke_mask(const LoopRing& ring, std::size_t j);

/// Share of the boundary edge's point that goes to its first vertex, under any boundary rule.
[[nodiscard]] double boundary_edge_share(Boundary boundary, bool first_regular,
                                         bool second_regular);

/// Ready for tangent_masks.
[[nodiscard]] inline bool is_settled(const LoopRing& ring) { return ring.is_settled(); }

[[nodiscard]] std::vector<Tangents> tangent_masks(const LoopRing& ring);

}  // namespace surpass::loop

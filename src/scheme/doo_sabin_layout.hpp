// Which rule holds at each edge and vertex, and the numbers of the points that they make.
#pragma once

#include <surpass/context.hpp>
#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <vector>

namespace surpass::doo_sabin {

enum class VertexKind : unsigned char { smooth, doublet, dart, curve, kept };

/// New points are numbered: corner points by half-edge, two curve points an edge in the order of
/// the curve edges (tail of the edge's half-edge first), kept vertices in their order.
class Layout {
 public:
  /// Fails as Sharpness::build does, and on semi-sharp edges and vertices. The topology must
  /// outlive the layout.
  static Result<Layout> build(const Mesh& mesh, const Topology& topology, Boundary boundary,
                              const Context& context);

  [[nodiscard]] const Topology& topology() const { return *topology_; }
  [[nodiscard]] VertexKind kind(Index v) const { return kinds_[v]; }
  [[nodiscard]] bool is_curve(Index e) const {
    return !curve_rank_.empty() && curve_rank_[e] != kNone;
  }
  /// Whether the two faces at tail(h), a kept vertex, are all of its fan: see doo_sabin.hpp.
  [[nodiscard]] bool is_lens(Index h) const;

  [[nodiscard]] const std::vector<Index>& curve_edges() const { return curve_edges_; }
  [[nodiscard]] const std::vector<Index>& kept_vertices() const { return kept_vertices_; }
  /// Place of a curve edge in curve_edges().
  [[nodiscard]] Index curve_rank(Index e) const { return curve_rank_[e]; }
  /// Place of a kept vertex in kept_vertices().
  [[nodiscard]] Index kept_rank(Index v) const;

  [[nodiscard]] Index first_curve_point() const { return topology_->corner_count(); }
  [[nodiscard]] Index first_kept_point() const {
    return first_curve_point() + 2 * static_cast<Index>(curve_edges_.size());
  }
  [[nodiscard]] Index point_count() const {
    return first_kept_point() + static_cast<Index>(kept_vertices_.size());
  }
  /// The curve points on the edge of h: next to its tail, next to its head.
  [[nodiscard]] Index tail_curve_point(Index h) const { return curve_point(h, 0); }
  [[nodiscard]] Index head_curve_point(Index h) const { return curve_point(h, 1); }
  [[nodiscard]] Index kept_point(Index v) const { return first_kept_point() + kept_rank(v); }

 private:
  [[nodiscard]] Index curve_point(Index h, Index end) const {
    const Index e = topology_->edge(h);
    const Index side = topology_->edge_halfedge(e) == h ? end : 1 - end;
    return first_curve_point() + 2 * curve_rank_[e] + side;
  }

  const Topology* topology_ = nullptr;
  std::vector<VertexKind> kinds_;     // #V
  std::vector<Index> curve_rank_;     // #E, or empty: no curve edges
  std::vector<Index> curve_edges_;    // ascending
  std::vector<Index> kept_vertices_;  // ascending
};

}  // namespace surpass::doo_sabin

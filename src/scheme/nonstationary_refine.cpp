// One step: e = (1/2 - d)(A + B) + d (C + D) with d = beta_k / 8 on edges, and at vertices
// p' = (1 - a) p + a (mean of the ring), a = ring weight times alpha_k for given vertices and times
// beta_k for those born on an edge, which all have valence 6.
#include <algorithm>

#include "scheme/loop_masks.hpp"
#include "scheme/nonstationary_state.hpp"
#include "scheme/quartered_triangles.hpp"

namespace surpass::nonstationary {
namespace {

class StepRows {
 public:
  StepRows(const State& state, const Topology& topology, const Sharpness& sharpness)
      : state_(state),
        topology_(topology),
        sharpness_(sharpness),
        edge_(state.edge_mask() / 8),
        born_(ring_weight(6, state.options.weights) * state.edge_mask()) {
    for (Index v = 0; v < state.given() && v < topology.vertex_count(); ++v) {
      while (rings_.size() <= topology.valence(v)) {
        const auto n = static_cast<Index>(rings_.size());
        rings_.push_back(n < 3 ? 0 : ring_weight(n, state.options.weights));
      }
    }
  }

  void add_vertex(Index v, RowTile& tile) const {
    if (topology_.is_isolated(v)) {
      const auto [columns, weights] = tile.add_row(1);
      columns[0] = v;
      weights[0] = 1;
    } else if (!sharpness_.is_plain(v)) {
      add_curve_vertex(state_, topology_, sharpness_, v, tile);
    } else if (state_.is_quadratic_step()) {
      add_quadratic_vertex(state_, topology_, sharpness_, v, tile);
    } else {
      add_plain_vertex(v, tile);
    }
  }

  void add_edge(Index e, RowTile& tile) const {
    if (sharpness_.edge(topology_, e) > 0) {
      add_curve_edge(state_, topology_, sharpness_, e, tile);
    } else if (state_.is_quadratic_step()) {
      add_quadratic_edge(topology_, sharpness_, e, tile);
    } else {
      add_smooth_edge(e, tile);
    }
  }

 private:
  [[nodiscard]] double moved(Index v) const {
    if (!state_.own.empty()) {
      const Index valence = topology_.valence(v);
      return ring_weight(valence, state_.options.weights) * in_mask(state_.own[v], state_.options);
    }
    if (v >= state_.given()) return born_;
    return rings_[topology_.valence(v)] * in_mask(state_.alpha(v), state_.options);
  }

  void add_plain_vertex(Index v, RowTile& tile) const {
    const Index valence = topology_.valence(v);
    const double part = moved(v) / static_cast<double>(valence);
    const auto [columns, weights] = tile.add_row(std::size_t{valence} + 1);
    // The own weight comes last, where nothing large is added to it any more, and makes the rounded
    // weights sum to 1.
    Index* column = columns.data();
    topology_.for_each_outgoing(v, [&](Index h) { *column++ = topology_.head(h); });
    *column = v;
    std::fill(weights.begin(), weights.end(), part);
    weights[valence] = 1 - part * static_cast<double>(valence);
  }

  void add_smooth_edge(Index e, RowTile& tile) const {
    const Index h = topology_.edge_halfedge(e);
    const Index a = topology_.tail(h);
    const Index b = topology_.head(h);
    const auto [columns, weights] = tile.add_row(4);
    columns[0] = a;
    columns[1] = b;
    columns[2] = loop::across(topology_, h);
    columns[3] = loop::across(topology_, topology_.opposite(h));
    const double d = state_.own.empty() ? edge_ : mean_mask(a, b) / 8;
    weights[0] = weights[1] = 0.5 - d;
    weights[2] = weights[3] = d;
    if (sharpness_.is_plain(a) == sharpness_.is_plain(b)) return;
    const bool first = sharpness_.is_plain(a);
    const auto bent = bent_edge(state_, topology_, sharpness_, first ? a : b, first ? b : a);
    if (!bent) return;
    weights[first ? 0 : 1] = bent->weight;
    weights[first ? 1 : 0] = 1 - 2 * d - bent->weight;
  }

  [[nodiscard]] double mean_mask(Index a, Index b) const {
    return in_mask((state_.own[a] + state_.own[b]) / 2, state_.options);
  }

  const State& state_;
  const Topology& topology_;
  const Sharpness& sharpness_;
  double edge_;                // d
  double born_;                // weight of the ring at a vertex that was born on an edge
  std::vector<double> rings_;  // ring weights by valence
};

}  // namespace

Result<Mesh> refinement(const State& state, const Mesh& mesh, const Topology& topology,
                        const Sharpness& sharpness, const Context& context, RowSink& sink) {
  auto refined = quartered_triangles(mesh, topology, context);
  if (!refined) return refined;
  const Index n = topology.vertex_count();
  const StepRows rows(state, topology, sharpness);
  make_rows(context, n + topology.edge_count(), sink, [&](Index i, RowTile& tile) {
    i < n ? rows.add_vertex(i, tile) : rows.add_edge(i - n, tile);
  });
  return refined;
}

}  // namespace surpass::nonstationary

// Limit positions: (1 - lambda) p + lambda c, with lambda of the parameters at this level, for
// every plain vertex of every level; cubic B-splines on curves.
#include <algorithm>

#include "scheme/nonstationary_state.hpp"
#include "scheme/steps.hpp"

namespace surpass::nonstationary {
namespace {

class LimitRows {
 public:
  LimitRows(const State& state, const Topology& topology, const Sharpness& sharpness)
      : state_(state), topology_(topology), sharpness_(sharpness) {
    born_ = share(6, state.beta(), state.beta());
    // After this level's step a vertex near a curve goes on as all do.
    next_ = share(6, iterated(state.beta(), 1, state.options),
                  iterated(state.beta(), 1, state.options));
    shares_ = given_shares();
  }

  void add(Index v, RowTile& tile) const {
    if (topology_.is_isolated(v)) {
      add_fixed(v, tile);
    } else if (!sharpness_.is_plain(v)) {
      add_curve_vertex(v, tile);
    } else if (!state_.own.empty()) {
      add_own_vertex(v, tile);
    } else {
      add_plain_vertex(v, tile);
    }
  }

 private:
  [[nodiscard]] double share(Index valence, double alpha, double beta) const {
    return share_of_centroid(alpha, beta, ring_weight(valence, state_.options.weights), 0,
                             state_.options)
        .value;
  }

  /// By given vertex; vertices that follow each other mostly have the same parameter and valence.
  [[nodiscard]] std::vector<double> given_shares() const {
    struct Known {
      Index valence;
      double alpha;
      double share;
    };
    std::vector<Known> known;
    std::vector<double> shares(state_.own.empty() ? state_.given() : 0, 0.0);
    for (Index v = 0; v < shares.size(); ++v) {
      if (topology_.is_isolated(v) || !sharpness_.is_plain(v)) continue;
      const Index valence = topology_.valence(v);
      const double alpha = state_.vertices[v];
      const auto at = std::find_if(known.begin(), known.end(), [&](const Known& k) {
        return k.valence == valence && k.alpha == alpha;
      });
      if (at != known.end()) {
        shares[v] = at->share;
        continue;
      }
      shares[v] = share(valence, state_.alpha(v), state_.beta());
      constexpr std::size_t kWorthAsking = 64;
      if (known.size() < kWorthAsking) known.push_back({valence, alpha, shares[v]});
    }
    return shares;
  }

  static void add_fixed(Index v, RowTile& tile) {
    const auto [columns, weights] = tile.add_row(1);
    columns[0] = v;
    weights[0] = 1;
  }

  void add_curve_vertex(Index v, RowTile& tile) const {
    const Ring ring = Ring::around(topology_, sharpness_, v);
    if (ring.rule() != VertexRule::crease) return add_fixed(v, tile);
    const auto sharp = ring.sharp_spokes();
    const auto [columns, weights] = tile.add_row(3);
    columns[0] = v;
    columns[1] = ring.spokes[sharp[0]];
    columns[2] = ring.spokes[sharp[1]];
    weights[0] = 2.0 / 3;
    weights[1] = weights[2] = 1.0 / 6;
  }

  void add_own_vertex(Index v, RowTile& tile) const {
    std::vector<double> spokes;
    const Index valence = topology_.valence(v);
    topology_.for_each_outgoing(v,
                                [&](Index h) { spokes.push_back(state_.own[topology_.head(h)]); });
    const Mask mask = ring_limit(state_.own[v], spokes, state_.options).position;
    const auto [columns, weights] = tile.add_row(std::size_t{valence} + 1);
    std::copy(mask.begin(), mask.end(), weights.begin());
    columns[0] = v;
    Index* column = columns.data();
    topology_.for_each_outgoing(v, [&](Index h) { *++column = topology_.head(h); });
  }

  void add_plain_vertex(Index v, RowTile& tile) const {
    const Index valence = topology_.valence(v);
    const double share = (v < state_.given() ? shares_[v] : born_) / static_cast<double>(valence);
    const auto [columns, weights] = tile.add_row(std::size_t{valence} + 1);
    columns[0] = v;
    weights[0] = 1 - share * static_cast<double>(valence);  // so that the rounded ones sum to 1
    Index* column = columns.data();
    topology_.for_each_outgoing(v, [&](Index h) { *++column = topology_.head(h); });
    std::fill(weights.begin() + 1, weights.end(), share);
    if (state_.level == 0 || v < state_.given()) return;
    for (std::size_t j = 1; j < columns.size(); ++j) {
      if (columns[j] >= state_.given() || sharpness_.is_plain(columns[j])) continue;
      const auto bent = bent_edge(state_, topology_, sharpness_, v, columns[j]);
      if (!bent) continue;
      // One point of its next ring is elsewhere.
      const double more = bent->weight - (0.5 - state_.edge_mask() / 8);
      const double moved = next_ * more / static_cast<double>(valence);
      weights[0] += moved;
      weights[j] -= moved;
    }
  }

  const State& state_;
  const Topology& topology_;
  const Sharpness& sharpness_;
  double born_ = 0;
  double next_ = 0;
  std::vector<double> shares_;
};

}  // namespace

void limit_rows(const State& state, const Topology& topology, const Sharpness& sharpness,
                const Context& context, RowSink& sink) {
  const LimitRows rows(state, topology, sharpness);
  make_rows(context, topology.vertex_count(), sink,
            [&](Index v, RowTile& tile) { rows.add(v, tile); });
}

}  // namespace surpass::nonstationary

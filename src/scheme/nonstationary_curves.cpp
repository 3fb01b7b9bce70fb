// Boundaries and infinitely sharp creases of non-stationary Loop surfaces. The paper has closed
// meshes only; these rules are ours.
//
// A curve depends on its own vertices alone: two patches with the same boundary stay together. Its
// first step has the edge rule (1/2 - s, 1/2 - s; s, s) with s = -1/12, exact for cubics, and a
// vertex rule that pushes back what the cubic B-spline of all later steps will take.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scheme/nonstationary_state.hpp"

namespace surpass::nonstationary {
namespace {

constexpr double kBeyond = -1.0 / 12;

/// A few weights, added up by column.
class ShortRow {
 public:
  void add(Index column, double weight) {
    const auto at = std::find_if(entries_.begin(), entries_.end(),
                                 [column](const auto& entry) { return entry.first == column; });
    if (at == entries_.end()) {
      entries_.emplace_back(column, weight);
    } else {
      at->second += weight;
    }
  }
  void write(RowTile& tile) const {
    const auto [columns, weights] = tile.add_row(entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      columns[i] = entries_[i].first;
      weights[i] = entries_[i].second;
    }
  }

 private:
  std::vector<std::pair<Index, double>> entries_;
};

/// The neighbours along the curve through a vertex; none at a corner.
std::optional<std::array<Index, 2>> along_curve(const Topology& topology,
                                                const Sharpness& sharpness, Index v) {
  const Ring ring = Ring::around(topology, sharpness, v);
  if (ring.rule() != VertexRule::crease) return std::nullopt;
  const auto sharp = ring.sharp_spokes();
  return std::array{ring.spokes[sharp[0]], ring.spokes[sharp[1]]};
}

/// weight * (the point on the curve after v, coming from `before`): beyond a corner it is mirrored.
void add_next(const Topology& topology, const Sharpness& sharpness, Index before, Index v,
              double weight, ShortRow& row) {
  const auto neighbours = along_curve(topology, sharpness, v);
  if (neighbours) {
    row.add((*neighbours)[0] == before ? (*neighbours)[1] : (*neighbours)[0], weight);
  } else {
    row.add(v, 2 * weight);
    row.add(before, -weight);
  }
}

/// weight * (the point of the curve's edge after the first step).
void add_first_edge(const Topology& topology, const Sharpness& sharpness, Index a, Index b,
                    double weight, ShortRow& row) {
  row.add(a, (0.5 - kBeyond) * weight);
  row.add(b, (0.5 - kBeyond) * weight);
  add_next(topology, sharpness, b, a, kBeyond * weight, row);
  add_next(topology, sharpness, a, b, kBeyond * weight, row);
}

/// Share of the neighbours' mean in a vertex after the steps that follow the first: 1/3 in the
/// limit.
double later_share(int steps) { return steps == 0 ? 1.0 / 3 : (1 - std::pow(4, 1 - steps)) / 3; }

}  // namespace

void add_curve_vertex(const State& state, const Topology& topology, const Sharpness& sharpness,
                      Index v, RowTile& tile) {
  const auto neighbours = along_curve(topology, sharpness, v);
  ShortRow row;
  if (!neighbours) {
    row.add(v, 1);
  } else if (state.level == 0 && state.interpolates()) {
    const double share = later_share(state.options.steps);
    row.add(v, 1 / (1 - share));
    for (const Index w : *neighbours) {
      add_first_edge(topology, sharpness, v, w, -share / (1 - share) / 2, row);
    }
  } else {
    row.add(v, 3.0 / 4);
    for (const Index w : *neighbours) row.add(w, 1.0 / 8);
  }
  row.write(tile);
}

void add_curve_edge(const State& state, const Topology& topology, const Sharpness& sharpness,
                    Index e, RowTile& tile) {
  const auto [a, b] = topology.edge_vertices(e);
  ShortRow row;
  if (state.level == 0 && state.interpolates()) {
    add_first_edge(topology, sharpness, a, b, 1, row);
  } else {
    row.add(a, 0.5);
    row.add(b, 0.5);
  }
  row.write(tile);
}

// After Biermann, Levin, Zorin, Piecewise smooth subdivision surfaces with normal control, 2000,
// with d in the place of 1/8. Only given vertices have other than three faces beside the curve.
std::optional<BentEdge> bent_edge(const State& state, const Topology& topology,
                                  const Sharpness& sharpness, Index inner, Index curve) {
  if (state.level == 0 || curve >= state.given() || sharpness.is_plain(curve) ||
      !sharpness.is_plain(inner)) {
    return std::nullopt;
  }
  const Ring ring = Ring::around(topology, sharpness, curve);
  if (ring.rule() != VertexRule::crease) return std::nullopt;
  const std::size_t n = ring.size();
  const auto at = static_cast<std::size_t>(
      std::find(ring.spokes.begin(), ring.spokes.end(), inner) - ring.spokes.begin());
  for (const Sector& sector : sectors(ring)) {
    if ((at + n - sector.begin) % n >= sector.faces) continue;
    if (sector.faces == 3) return std::nullopt;
    const double angle = std::numbers::pi / static_cast<double>(sector.faces);
    return BentEdge{curve, inner, 0.5 - state.edge_mask() / 4 * std::cos(angle)};
  }
  return std::nullopt;
}

}  // namespace surpass::nonstationary

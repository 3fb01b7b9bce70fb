// The first step of the quadratic rule, which is ours. New edge points take the two ends, the two
// vertices across and the four wings behind the triangles' other sides; weights 13/24, 1/8, -1/12
// make them the control points of Loop's box spline for every quadratic function on a regular
// lattice. The vertices are pushed back so that later steps, which are Loop's, bring them home.
#include <algorithm>

#include "scheme/loop_masks.hpp"
#include "scheme/nonstationary_state.hpp"

namespace surpass::nonstationary {
namespace {

constexpr double kEnd = 13.0 / 24;
constexpr double kAcross = 1.0 / 8;
constexpr double kWing = -1.0 / 12;
constexpr std::size_t kEdgePoints = 8;

/// use(column, weight) for the new point of a smooth edge, columns perhaps repeated. A wing behind
/// a curve is the fourth corner of the parallelogram.
template <class Use>
void edge_weights(const Topology& topology, const Sharpness& sharpness, Index e, Use&& use) {
  const Index first = topology.edge_halfedge(e);
  for (const Index h : {first, topology.opposite(first)}) {
    use(topology.tail(h), kEnd);
    use(loop::across(topology, h), kAcross);
    for (const Index side : {topology.next(h), topology.previous(h)}) {
      if (sharpness.edge(topology, topology.edge(side)) > 0) {
        use(topology.tail(side), kWing);
        use(topology.head(side), kWing);
        use(loop::across(topology, side), -kWing);
      } else {
        use(loop::across(topology, topology.opposite(side)), kWing);
      }
    }
  }
}

double later_centroid_share(const State& state, Index valence) {
  if (state.options.steps == 1) return 0;
  const int steps = std::max(0, state.options.steps - 1);
  return share_of_centroid(1, 1, ring_weight(valence, state.options.weights), steps, state.options)
      .value;
}

void write(const std::vector<std::pair<Index, double>>& sorted, RowTile& tile) {
  const auto [columns, weights] = tile.add_row(sorted.size());
  std::size_t k = 0;
  for (const auto& [column, weight] : sorted) {
    if (k > 0 && columns[k - 1] == column) {
      weights[k - 1] += weight;
      continue;
    }
    columns[k] = column;
    weights[k++] = weight;
  }
  tile.shorten_row(k);
}

void sort_by_column(std::vector<std::pair<Index, double>>& entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
}

}  // namespace

void add_quadratic_edge(const Topology& topology, const Sharpness& sharpness, Index e,
                        RowTile& tile) {
  std::vector<std::pair<Index, double>> entries;
  entries.reserve(2 * kEdgePoints);
  edge_weights(topology, sharpness, e,
               [&](Index column, double weight) { entries.emplace_back(column, weight); });
  sort_by_column(entries);
  write(entries, tile);
}

void add_quadratic_vertex(const State& state, const Topology& topology, const Sharpness& sharpness,
                          Index v, RowTile& tile) {
  const Index valence = topology.valence(v);
  const double share = later_centroid_share(state, valence);
  const double part = -share / (1 - share) / static_cast<double>(valence);
  std::vector<std::pair<Index, double>> entries = {{v, 1 / (1 - share)}};
  topology.for_each_spoke(v, [&](Index, Index e) {
    edge_weights(topology, sharpness, e,
                 [&](Index column, double weight) { entries.emplace_back(column, part * weight); });
  });
  sort_by_column(entries);
  write(entries, tile);
}

}  // namespace surpass::nonstationary

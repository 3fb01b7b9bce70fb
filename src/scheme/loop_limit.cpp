#include <algorithm>

#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"

namespace surpass::loop {
namespace {

// Interior rows: diag(n / (1 - beta)) L is symmetric, and x'Sx is half the sum over faces of
// (x_a + x_b + x_c)^2 plus the sum of n (beta / (1 - beta) - 1/2) x^2, so every eigenvalue is at
// least the smallest (3 beta - 1) / 2. Rows that leave vertices out form a principal submatrix.
RowFacts surface_facts(std::size_t n, double beta_n) {
  return {static_cast<double>(n) / (1 - beta_n), (3 * beta_n - 1) / 2, false};
}

// Curve rows: symmetric with 1/6 off the diagonal, or with 48 and 35 under `hoppe`; the bound is
// Gershgorin's, row by row: the diagonal less the rest.
RowFacts curve_facts(const LoopRing& ring, const std::vector<double>& mask) {
  const double weight = !ring.is_hoppe_curve() ? 6.0 : ring.center_regular ? 48.0 : 35.0;
  return {weight, 2 * mask[0] - 1, true};
}

RowFacts facts_of(const LoopRing& ring, const std::vector<double>& mask) {
  if (mask[0] == 1) return {1, 1, true};
  if (ring.boundary == Boundary::interior && ring.open) {
    return {static_cast<double>(ring.size()) / (1 - mask[0]), -1, false};
  }
  const VertexRule rule = ring.rule();
  if (ring.is_semi_sharp()) return {0, 0, rule != VertexRule::dart};
  if (rule == VertexRule::dart) return {0, 0, false};
  if (rule == VertexRule::crease) return curve_facts(ring, mask);
  return surface_facts(ring.size(), mask[0]);
}

// The row of a plain vertex and what is known of it, by valence, so that no cosine is taken a
// million times. Plain vertices have as many neighbours as faces.
struct PlainRow {
  double own = 1;
  double neighbour = 0;
  RowFacts facts = {};
};
std::vector<PlainRow> plain_rows(const Topology& topology) {
  Index most = 0;
  for (Index v = 0; v < topology.vertex_count(); ++v) most = std::max(most, topology.faces_at(v));
  std::vector<PlainRow> rows(std::size_t{most} + 1);
  for (std::size_t n = 1; n < rows.size(); ++n) {
    const double own = beta(n);
    rows[n] = {own, (1 - own) / static_cast<double>(n), surface_facts(n, own)};
  }
  return rows;
}

}  // namespace

Result<LimitOperator> Loop::limit_operator(const Mesh& mesh, const Topology& topology,
                                           const Rules& rules, const Context& context) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());

  const Index n = topology.vertex_count();
  const std::vector<PlainRow> plain = plain_rows(topology);
  LimitOperator op(n);
  const auto special_mask = [&](Index v) {
    return limit_mask(LoopRing::around(topology, *sharpness, rules.boundary, v));
  };
  const auto used = [](const std::vector<double>& mask) {
    return static_cast<Index>(
        std::count_if(mask.begin(), mask.end(), [](double w) { return w != 0; }));
  };

  op.rows = SparseRows::build(
      context, n,
      [&](Index v) -> Index {
        if (topology.is_isolated(v)) return 1;
        return sharpness->is_plain(v) ? topology.faces_at(v) + 1 : used(special_mask(v));
      },
      [&](Index v, std::span<Index> columns, std::span<double> weights) -> Index {
        if (topology.is_isolated(v)) {
          columns[0] = v;
          weights[0] = 1;
          return kNone;
        }
        if (sharpness->is_plain(v)) {
          const PlainRow& row = plain[columns.size() - 1];
          columns[0] = v;
          weights[0] = row.own;
          std::size_t k = 1;
          topology.for_each_outgoing(v, [&](Index h) { columns[k++] = topology.head(h); });
          std::fill(weights.begin() + 1, weights.end(), row.neighbour);
          op.note(v, row.facts);
          return static_cast<Index>(columns.size());
        }
        const LoopRing ring = LoopRing::around(topology, *sharpness, rules.boundary, v);
        const std::vector<double> mask = limit_mask(ring);
        std::size_t k = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
          if (mask[i] == 0) continue;
          columns[k] = i == 0 ? v : ring.spokes[i - 1];
          weights[k++] = mask[i];
        }
        op.note(v, facts_of(ring, mask));
        return kNone;
      });
  return op;
}

// Given vertices keep their numbers.
Result<SparseRows> Loop::given_limits(const Mesh& refined, const Topology& topology,
                                      const Rules& rules, const Mesh& given,
                                      const Context& context) const {
  const auto op = limit_operator(refined, topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  return SparseRows::build(
      context, given.vertex_count(), [&](Index v) { return op->rows.row_length(v); },
      [&](Index v, std::span<Index> columns, std::span<double> weights) {
        const RowView row = op->rows.row(v);
        std::copy(row.columns.begin(), row.columns.end(), columns.begin());
        std::copy_n(row.weights, weights.size(), weights.begin());
      });
}

}  // namespace surpass::loop

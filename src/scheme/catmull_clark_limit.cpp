#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_masks.hpp"
#include "scheme/catmull_clark_rows.hpp"

namespace surpass::catmull_clark {
namespace {

// Interior rows: with d = n (n + 5), diag(d) L is symmetric, and x'Sx is the sum over vertices of
// (n^2 - 3n) x^2, twice the sum over edges of (x_a + x_b)^2 and four times that over faces of
// (sum x)^2 / m. So every eigenvalue is at least the smallest (n - 3) / (n + 5), whatever the
// faces: nothing for valence 3, less than nothing for valence 2.
RowFacts surface_facts(std::size_t valence) {
  const auto n = static_cast<double>(valence);
  return {n * (n + 5), (n - 3) / (n + 5), false};
}

RowFacts facts_of(const FaceRing& ring) {
  const VertexRule rule = ring.rule();
  if (is_infinite(ring.sharpness)) return {1, 1, true};
  if (ring.is_semi_sharp()) return {0, 0, rule != VertexRule::dart};
  if (rule == VertexRule::corner) return {1, 1, true};
  if (rule == VertexRule::dart) return {0, 0, false};
  if (rule == VertexRule::crease) return {6, 1.0 / 3, true};  // Gershgorin: 2/3 - 1/6 - 1/6
  return surface_facts(ring.size());
}

}  // namespace

Result<LimitOperator> CatmullClark::limit_operator(const Mesh& mesh, const Topology& topology,
                                                   const Rules& rules,
                                                   const Context& context) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  const Index n = topology.vertex_count();
  LimitOperator op(n);
  const VertexRows rows(topology, *sharpness, limit_row, limit_mask);
  op.rows = SparseRows::build(
      context, n, [&](Index v) { return rows.length(v); },
      [&](Index v, std::span<Index> columns, std::span<double> weights) {
        rows.fill(v, columns, weights);
        if (topology.is_isolated(v)) return;
        op.note(v, sharpness->is_plain(v) ? surface_facts(topology.valence(v))
                                          : facts_of(FaceRing::around(topology, *sharpness, v)));
      });
  return op;
}

// Given vertices keep their numbers, so that there is no need for the rows of all others.
Result<SparseRows> CatmullClark::given_limits(const Mesh& refined, const Topology& topology,
                                              const Rules& rules, const Mesh& given,
                                              const Context& context) const {
  const auto sharpness = Sharpness::build(refined, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  const VertexRows rows(topology, *sharpness, limit_row, limit_mask);
  return SparseRows::build(
      context, given.vertex_count(), [&](Index v) { return rows.length(v); },
      [&](Index v, std::span<Index> columns, std::span<double> weights) {
        rows.fill(v, columns, weights);
      });
}

}  // namespace surpass::catmull_clark

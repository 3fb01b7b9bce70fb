#include <algorithm>
#include <tuple>
#include <utility>

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_faces.hpp"
#include "scheme/doo_sabin_weights.hpp"
#include "scheme/face_rows.hpp"

namespace surpass::doo_sabin {
namespace {

// Weights of given vertices, in any order, a vertex perhaps several times.
using Terms = std::vector<std::pair<Index, double>>;

class RowMaker {
 public:
  RowMaker(const Layout& layout, const WeightTable& table)
      : layout_(layout), topology_(layout.topology()), table_(table) {}

  // The limit is the mean, over the faces at v, of v's corner points. A vertex that two faces at v
  // share beyond an edge appears once for each.
  void fill_smooth(Index v, std::span<Index> columns, std::span<double> weights) const {
    fill_face_row(topology_, v, columns, weights,
                  [&](Index m, Index j) { return table_.of(m)[j]; });
    const double share = 1.0 / topology_.faces_at(v);
    for (double& w : weights) w *= share;
  }

  // x'Sx is the sum over faces of x'C x with the face rule C, so it is at least the sum of their
  // smallest eigenvalues times x'x.
  [[nodiscard]] RowFacts smooth_facts(Index v) const {
    double sum = 0;
    topology_.for_each_outgoing(v, [&](Index h) {
      sum += table_.lowest_eigenvalue(topology_.face_degree(topology_.face(h)));
    });
    const double n = topology_.faces_at(v);
    return {n, sum / n, false};
  }

  [[nodiscard]] Terms special_row(Index v) const {
    switch (layout_.kind(v)) {
      case VertexKind::curve: return merged(v, curve_row(v));
      case VertexKind::dart: return merged(v, dart_row(v));
      case VertexKind::doublet: return merged(v, doublet_row(v));
      default: return {{v, 1.0}};
    }
  }

 private:
  [[nodiscard]] std::span<const double> weights_at(Index h) const {
    return table_.of(topology_.face_degree(topology_.face(h)));
  }

  void add_point(const NewCorner& corner, double scale, Terms& terms) const {
    if (corner.toward != kNone) {
      terms.emplace_back(topology_.tail(corner.at), scale * 3 / 4);
      terms.emplace_back(topology_.tail(corner.toward), scale / 4);
      return;
    }
    Index h = corner.at;
    for (const double w : weights_at(h)) {
      terms.emplace_back(topology_.tail(h), scale * w);
      h = topology_.next(h);
    }
  }

  // The midpoint between the curve points on both sides.
  [[nodiscard]] Terms curve_row(Index v) const {
    Terms terms = {{v, 3.0 / 4}};
    topology_.for_each_spoke(v, [&](Index w, Index e) {
      if (layout_.is_curve(e)) terms.emplace_back(w, 1.0 / 8);
    });
    return terms;
  }

  [[nodiscard]] Terms dart_row(Index v) const {
    NewFaces faces;
    append_vertex_faces(layout_, v, faces);
    Terms terms;
    for (const NewCorner& c : faces.corners) {
      add_point(c, 1.0 / static_cast<double>(faces.corners.size()), terms);
    }
    return terms;
  }

  // The edge between the two corner points lies between the faces of the doublet's two edges.
  [[nodiscard]] Terms doublet_row(Index v) const {
    const Index h = topology_.outgoing(v);
    const Index other = topology_.rotate(h);
    Terms terms;
    for (const Index g : {h, other}) {
      NewFaces faces;
      append_edge_faces(layout_, topology_.edge(g), faces);
      add_edge_limit(table_.family(), faces.size(0), edge_position(faces, 0, h, other),
                     [&](Index k, double w) { add_point(faces.corners[k], w, terms); });
    }
    return terms;
  }

  // The center first, then by column, each once.
  static Terms merged(Index v, Terms terms) {
    std::stable_sort(terms.begin(), terms.end(), [v](const auto& a, const auto& b) {
      return std::pair(a.first != v, a.first) < std::pair(b.first != v, b.first);
    });
    Terms sums;
    for (const auto& [column, weight] : terms) {
      if (!sums.empty() && sums.back().first == column) {
        sums.back().second += weight;
      } else {
        sums.emplace_back(column, weight);
      }
    }
    return sums;
  }

  const Layout& layout_;
  const Topology& topology_;
  const WeightTable& table_;
};

// Curve rows: symmetric with weight 8; Gershgorin's bound is 3/4 less two eighths. Nothing is known
// of darts and doublets.
RowFacts special_facts(VertexKind kind) {
  if (kind == VertexKind::curve) return {8, 1.0 / 2, true};
  if (kind == VertexKind::kept) return {1, 1, true};
  return {};
}

}  // namespace

Result<LimitOperator> DooSabin::limit_operator(const Mesh& mesh, const Topology& topology,
                                               const Rules& rules, const Context& context) const {
  const auto layout = Layout::build(mesh, topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  const WeightTable table(topology, rules.weights);
  const RowMaker maker(*layout, table);
  const Index n = topology.vertex_count();

  LimitOperator op(n);
  op.rows = SparseRows::build(
      context, n,
      [&](Index v) -> Index {
        if (layout->kind(v) == VertexKind::smooth) return face_row_length(topology, v);
        return static_cast<Index>(maker.special_row(v).size());
      },
      [&](Index v, std::span<Index> columns, std::span<double> weights) {
        const VertexKind kind = layout->kind(v);
        if (kind == VertexKind::smooth) {
          maker.fill_smooth(v, columns, weights);
          op.note(v, maker.smooth_facts(v));
          return;
        }
        const Terms row = maker.special_row(v);
        for (std::size_t k = 0; k < row.size(); ++k) {
          std::tie(columns[k], weights[k]) = row[k];
        }
        op.note(v, special_facts(kind));
      });
  return op;
}

}  // namespace surpass::doo_sabin

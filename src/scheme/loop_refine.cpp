#include <algorithm>

#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"
#include "scheme/quartered_triangles.hpp"

namespace surpass::loop {
namespace {

// The weights of a plain vertex, by valence, so that no cosine is taken a million times.
struct RefinedRow {
  double own;
  double neighbour;
};
std::vector<RefinedRow> refined_rows(const Topology& topology) {
  std::vector<RefinedRow> rows;
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    while (rows.size() <= topology.valence(v)) {
      const std::size_t n = rows.size();
      const double moved = n == 0 ? 0 : alpha(n);
      rows.push_back({1 - moved, n == 0 ? 0 : moved / static_cast<double>(n)});
    }
  }
  return rows;
}

class RowMaker {
 public:
  RowMaker(const Topology& topology, const Sharpness& sharpness, Boundary boundary)
      : topology_(topology),
        sharpness_(sharpness),
        boundary_(boundary),
        plain_(refined_rows(topology)) {}

  void add_vertex(Index v, RowTile& tile) const {
    if (topology_.is_isolated(v)) {
      const auto [columns, weights] = tile.add_row(1);
      columns[0] = v;
      weights[0] = 1;
    } else if (sharpness_.is_plain(v)) {
      add_plain_vertex(v, tile);
    } else {
      add_special_vertex(v, tile);
    }
  }

  // The new point of an edge: its ends and, where it is not fully sharp, the vertices across.
  void add_edge(Index e, RowTile& tile) const {
    if (topology_.is_boundary_edge(e)) return add_boundary_edge(e, tile);
    const Index h = topology_.edge_halfedge(e);
    const double crease = std::min(1.0, static_cast<double>(sharpness_.edge(topology_, e)));
    const auto [columns, weights] = tile.add_row(crease < 1 ? 4 : 2);
    columns[0] = topology_.tail(h);
    columns[1] = topology_.head(h);
    weights[0] = weights[1] = crease / 2 + (1 - crease) * 3 / 8;
    if (crease == 1) return;
    columns[2] = across(topology_, h);
    columns[3] = across(topology_, topology_.opposite(h));
    weights[2] = weights[3] = (1 - crease) / 8;
  }

 private:
  void add_plain_vertex(Index v, RowTile& tile) const {
    const Index valence = topology_.valence(v);
    const RowTile::Room room = tile.add_row(std::size_t{valence} + 1);
    room.columns[0] = v;
    room.weights[0] = plain_[valence].own;
    std::size_t k = 1;
    topology_.for_each_outgoing(v, [&](Index h) { room.columns[k++] = topology_.head(h); });
    std::fill(room.weights.begin() + 1, room.weights.end(), plain_[valence].neighbour);
  }

  void add_special_vertex(Index v, RowTile& tile) const {
    const LoopRing ring = LoopRing::around(topology_, sharpness_, boundary_, v);
    const std::vector<double> mask = vertex_mask(ring);
    const auto [columns, weights] = tile.add_row(mask.size());
    std::size_t k = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask[i] == 0) continue;
      columns[k] = i == 0 ? v : ring.spokes[i - 1];
      weights[k++] = mask[i];
    }
    tile.shorten_row(k);
  }

  void add_boundary_edge(Index e, RowTile& tile) const {
    const auto [a, b] = topology_.edge_vertices(e);
    const bool hoppe = boundary_ == Boundary::hoppe;
    const double share = boundary_edge_share(boundary_, hoppe && topology_.valence(a) == 4,
                                             hoppe && topology_.valence(b) == 4);
    const auto [columns, weights] = tile.add_row(2);
    columns[0] = a;
    columns[1] = b;
    weights[0] = share;
    weights[1] = 1 - share;
  }

  const Topology& topology_;
  const Sharpness& sharpness_;
  Boundary boundary_;
  std::vector<RefinedRow> plain_;
};

}  // namespace

Result<Mesh> Loop::refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                              const Context& context, RowSink& sink) const {
  if (rules.boundary == Boundary::interior && topology.boundary_edge_count() > 0) {
    return fail(ErrorCode::invalid_argument,
                "the boundary rule `interior` defines limit points of the given vertices only; "
                "choose edge-only, edge-and-corner or hoppe to subdivide");
  }
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  auto refined = quartered_triangles(mesh, topology, context);
  if (!refined) return refined;
  const Index n = topology.vertex_count();
  const RowMaker rows(topology, *sharpness, rules.boundary);
  make_rows(context, n + topology.edge_count(), sink, [&](Index i, RowTile& tile) {
    i < n ? rows.add_vertex(i, tile) : rows.add_edge(i - n, tile);
  });
  return refined;
}

}  // namespace surpass::loop

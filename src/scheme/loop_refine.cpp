#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"
#include "scheme/refine_attributes.hpp"
#include "scheme/refined_faces.hpp"

namespace surpass::loop {
namespace {

// The third vertex of the triangle of a half-edge.
Index across(const Topology& topology, Index h) { return topology.tail(topology.previous(h)); }

struct Weighted {
  Index vertex;
  double weight;
};

// The new point of an edge: its ends and, where it is not fully sharp, the vertices across.
std::array<Weighted, 4> edge_weights(const Topology& topology, const Sharpness& sharpness,
                                     Boundary boundary, Index e) {
  const Index h = topology.edge_halfedge(e);
  const Index a = topology.tail(h);
  const Index b = topology.head(h);
  if (topology.is_boundary_edge(e)) {
    const bool hoppe = boundary == Boundary::hoppe;
    const double share = boundary_edge_share(boundary, hoppe && topology.valence(a) == 4,
                                             hoppe && topology.valence(b) == 4);
    return {{{a, share}, {b, 1 - share}, {kNone, 0}, {kNone, 0}}};
  }
  const double crease = std::min(1.0, static_cast<double>(sharpness.edge(topology, e)));
  const double end = crease / 2 + (1 - crease) * 3 / 8;
  const double side = (1 - crease) / 8;
  return {{{a, end},
           {b, end},
           {across(topology, h), side},
           {across(topology, topology.opposite(h)), side}}};
}

SparseRows stencil(const Topology& topology, const Sharpness& sharpness, Boundary boundary,
                   const Context& context) {
  const Index n = topology.vertex_count();
  const auto mask_of = [&](Index v, auto&& visit) {
    const LoopRing ring = LoopRing::around(topology, sharpness, boundary, v);
    const std::vector<double> mask = vertex_mask(ring);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask[i] != 0) visit(i == 0 ? v : ring.spokes[i - 1], mask[i]);
    }
  };
  return SparseRows::build(
      context, n + topology.edge_count(),
      [&](Index i) -> Index {
        Index length = 0;
        if (i >= n) {
          for (const Weighted& w : edge_weights(topology, sharpness, boundary, i - n)) {
            if (w.weight != 0) ++length;
          }
        } else if (topology.is_isolated(i)) {
          length = 1;
        } else if (sharpness.is_plain(i)) {
          length = topology.valence(i) + 1;
        } else {
          mask_of(i, [&](Index, double) { ++length; });
        }
        return length;
      },
      [&](Index i, std::span<Index> columns, std::span<double> weights) {
        std::size_t k = 0;
        const auto put = [&](Index v, double w) {
          columns[k] = v;
          weights[k++] = w;
        };
        if (i >= n) {
          for (const Weighted& w : edge_weights(topology, sharpness, boundary, i - n)) {
            if (w.weight != 0) put(w.vertex, w.weight);
          }
        } else if (topology.is_isolated(i)) {
          put(i, 1);
        } else if (sharpness.is_plain(i)) {
          const std::size_t valence = columns.size() - 1;
          const double moved = alpha(valence);
          put(i, 1 - moved);
          topology.for_each_spoke(
              i, [&](Index w, Index) { put(w, moved / static_cast<double>(valence)); });
        } else {
          mask_of(i, put);
        }
      });
}

}  // namespace

Result<Refinement> Loop::refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                    const Context& context) const {
  if (rules.boundary == Boundary::interior && topology.boundary_edge_count() > 0) {
    return fail(ErrorCode::invalid_argument,
                "the boundary rule `interior` defines limit points of the given vertices only; "
                "choose edge-only, edge-and-corner or hoppe to subdivide");
  }
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  auto room = mesh_of_equal_faces(std::uint64_t{4} * topology.face_count(), 3);
  if (!room) return tl::make_unexpected(room.error());
  Refinement refined{std::move(*room), stencil(topology, *sharpness, rules.boundary, context)};
  const Index n = topology.vertex_count();
  const Index faces = topology.face_count();
  Mesh& out = refined.mesh;
  parallel::for_ranges(context, faces, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto h = static_cast<Index>(3 * f);
      const Index middle[3] = {n + topology.edge(h), n + topology.edge(h + 1),
                               n + topology.edge(h + 2)};
      const Index child[12] = {
          topology.tail(h), middle[0],
          middle[2],  //
          middle[0],        topology.tail(h + 1),
          middle[1],        middle[2],
          middle[1],        topology.tail(h + 2),
          middle[0],        middle[1],
          middle[2],
      };
      std::copy(std::begin(child), std::end(child),
                out.face_vertices.begin() + 12 * static_cast<std::ptrdiff_t>(f));
    }
  });
  inherit_creases(mesh, topology, out);
  inherit_face_attributes(mesh, std::vector<Index>(faces, 4), out);
  refine_corner_channels_of_triangles(mesh, out);
  return refined;
}

}  // namespace surpass::loop

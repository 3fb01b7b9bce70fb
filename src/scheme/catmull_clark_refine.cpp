#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_rows.hpp"
#include "scheme/refine_attributes.hpp"
#include "scheme/refined_faces.hpp"

namespace surpass::catmull_clark {
namespace {

// The new point of an edge: its ends and, where it is not fully sharp, the centroids of its faces.
void add_edge(const Topology& topology, const Sharpness& sharpness, Index e, RowTile& tile) {
  const Index h = topology.edge_halfedge(e);
  const double crease = std::min(1.0, static_cast<double>(sharpness.edge(topology, e)));
  std::array<Index, 2> sides = {h, topology.opposite(h)};
  std::array<double, 2> shares = {};
  double end = crease / 2 + (1 - crease) / 4;
  std::size_t length = 2;
  for (std::size_t i = 0; crease < 1 && i < 2; ++i) {
    const Index degree = topology.face_degree(topology.face(sides[i]));
    shares[i] = (1 - crease) / (4.0 * degree);
    end += shares[i];
    length += degree - 2;
  }
  const auto [columns, weights] = tile.add_row(length);
  columns[0] = topology.tail(h);
  columns[1] = topology.head(h);
  weights[0] = weights[1] = end;
  std::size_t k = 2;
  for (std::size_t i = 0; crease < 1 && i < 2; ++i) {
    const Index side = sides[i];
    for (Index at = topology.next(topology.next(side)); at != side; at = topology.next(at)) {
      columns[k] = topology.tail(at);
      weights[k++] = shares[i];
    }
  }
}

void add_face(const Topology& topology, Index f, RowTile& tile) {
  const Index degree = topology.face_degree(f);
  const auto [columns, weights] = tile.add_row(degree);
  for (Index k = 0; k < degree; ++k) columns[k] = topology.tail(topology.face_begin(f) + k);
  std::fill(weights.begin(), weights.end(), 1.0 / degree);
}

}  // namespace

Result<Mesh> CatmullClark::refinement(const Mesh& mesh, const Topology& topology,
                                      const Rules& rules, const Context& context,
                                      RowSink& sink) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  auto refined = mesh_of_equal_faces(topology.corner_count(), 4);
  if (!refined) return refined;
  const Index edges = topology.vertex_count();
  const Index faces = edges + topology.edge_count();
  const VertexRows vertices(topology, *sharpness, refined_row, vertex_mask);
  make_rows(context, faces + topology.face_count(), sink, [&](Index i, RowTile& tile) {
    if (i < edges) return vertices.add(i, tile);
    if (i < faces) return add_edge(topology, *sharpness, i - edges, tile);
    add_face(topology, i - faces, tile);
  });
  parallel::for_ranges(context, topology.corner_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto h = static_cast<Index>(i);
      Index* quad = refined->face_vertices.data() + 4 * i;
      quad[0] = topology.tail(h);
      quad[1] = edges + topology.edge(h);
      quad[2] = faces + topology.face(h);
      quad[3] = edges + topology.edge(topology.previous(h));
    }
  });
  inherit_creases(mesh, topology, *refined);
  inherit_face_attributes(
      mesh, [&](Index f) { return mesh.face_offsets[f]; }, *refined);
  refine_corner_channels_to_quads(mesh, *refined);
  return refined;
}

}  // namespace surpass::catmull_clark

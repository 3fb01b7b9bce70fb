#include <algorithm>

#include <fmt/format.h>

#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_rows.hpp"
#include "scheme/refine_attributes.hpp"
#include "scheme/refined_faces.hpp"

namespace surpass::catmull_clark {
namespace {

// Calls put(vertex, weight) for the new point of an edge: its ends and, where it is not fully
// sharp, the centroids of its faces.
template <class Put>
void edge_row(const Topology& topology, const Sharpness& sharpness, Index e, Put&& put) {
  const Index h = topology.edge_halfedge(e);
  const double crease = std::min(1.0, static_cast<double>(sharpness.edge(topology, e)));
  double end = crease / 2 + (1 - crease) / 4;
  if (crease < 1) {
    for (const Index side : {h, topology.opposite(h)}) {
      end += (1 - crease) / (4.0 * topology.face_degree(topology.face(side)));
    }
  }
  put(topology.tail(h), end);
  put(topology.head(h), end);
  if (crease == 1) return;
  for (const Index side : {h, topology.opposite(h)}) {
    const double share = (1 - crease) / (4.0 * topology.face_degree(topology.face(side)));
    for (Index k = topology.next(topology.next(side)); k != side; k = topology.next(k)) {
      put(topology.tail(k), share);
    }
  }
}

SparseRows stencil(const Topology& topology, const Sharpness& sharpness, const Context& context) {
  const Index edges = topology.vertex_count();
  const Index faces = edges + topology.edge_count();
  const VertexRows vertices(topology, sharpness, refined_row, vertex_mask);
  return SparseRows::build(
      context, faces + topology.face_count(),
      [&](Index i) -> Index {
        if (i < edges) return vertices.length(i);
        if (i >= faces) return topology.face_degree(i - faces);
        Index length = 0;
        edge_row(topology, sharpness, i - edges, [&](Index, double) { ++length; });
        return length;
      },
      [&](Index i, std::span<Index> columns, std::span<double> weights) {
        std::size_t k = 0;
        const auto put = [&](Index v, double w) {
          columns[k] = v;
          weights[k++] = w;
        };
        if (i < edges) {
          vertices.fill(i, columns, weights);
        } else if (i < faces) {
          edge_row(topology, sharpness, i - edges, put);
        } else {
          const Index f = i - faces;
          const double share = 1.0 / topology.face_degree(f);
          for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
            put(topology.tail(h), share);
          }
        }
      });
}

}  // namespace

Result<Refinement> CatmullClark::refinement(const Mesh& mesh, const Topology& topology,
                                            const Rules& rules, const Context& context) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  auto room = mesh_of_equal_faces(topology.corner_count(), 4);
  if (!room) return tl::make_unexpected(room.error());
  Refinement refined{std::move(*room), stencil(topology, *sharpness, context)};
  const Index edges = topology.vertex_count();
  const Index faces = edges + topology.edge_count();
  Mesh& out = refined.mesh;
  parallel::for_ranges(context, topology.corner_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto h = static_cast<Index>(i);
      Index* quad = out.face_vertices.data() + 4 * i;
      quad[0] = topology.tail(h);
      quad[1] = edges + topology.edge(h);
      quad[2] = faces + topology.face(h);
      quad[3] = edges + topology.edge(topology.previous(h));
    }
  });
  inherit_creases(mesh, topology, out);
  std::vector<Index> children(topology.face_count());
  for (Index f = 0; f < topology.face_count(); ++f) children[f] = topology.face_degree(f);
  inherit_face_attributes(mesh, children, out);
  refine_corner_channels_to_quads(mesh, out);
  return refined;
}

}  // namespace surpass::catmull_clark

#include "scheme/sharpness.hpp"

#include <fmt/format.h>

namespace surpass {
namespace {

Result<void> check_value(float sharpness, const Place& place) {
  if (sharpness >= 0) return {};  // false for NaN, too
  return fail(ErrorCode::invalid_argument,
              fmt::format("a sharpness is {}; it must be 0 (smooth) or more", sharpness), place);
}

}  // namespace

Result<Sharpness> Sharpness::build(const Mesh& mesh, const Topology& topology, Boundary boundary) {
  Sharpness s;
  const Index n = topology.vertex_count();
  if (!mesh.creases.empty()) s.edges_.assign(topology.edge_count(), 0.0F);
  for (const Crease& crease : mesh.creases) {
    const Place place{.edge = crease.vertices};
    if (auto ok = check_value(crease.sharpness, place); !ok) return tl::make_unexpected(ok.error());
    const Index e = topology.find_edge(crease.vertices[0], crease.vertices[1]);
    if (e == kNone) {
      return fail(
          ErrorCode::mismatch,
          "a crease names two vertices that no edge joins; remove it or correct its numbers",
          place);
    }
    s.edges_[e] = crease.sharpness;
  }
  const bool open = topology.boundary_edge_count() > 0;
  bool bowties = false;
  for (Index v = 0; v < n && !bowties; ++v) bowties = topology.is_bowtie(v);
  if (!open && !bowties && mesh.creases.empty() && mesh.corners.empty()) return s;

  s.vertices_.assign(n, 0.0F);
  s.plain_.assign(n, 1);
  for (const Corner& corner : mesh.corners) {
    const Place place{.vertex = corner.vertex};
    if (auto ok = check_value(corner.sharpness, place); !ok) return tl::make_unexpected(ok.error());
    if (corner.vertex >= n) {
      return fail(ErrorCode::mismatch,
                  fmt::format("a corner names a vertex that does not exist; there are {}", n),
                  place);
    }
    s.vertices_[corner.vertex] = corner.sharpness;
    if (corner.sharpness > 0) s.plain_[corner.vertex] = 0;
  }
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (s.edge(topology, e) <= 0) continue;
    for (const Index v : topology.edge_vertices(e)) s.plain_[v] = 0;
  }
  for (Index v = 0; v < n; ++v) {
    const bool one_face = boundary == Boundary::edge_and_corner && topology.is_boundary(v) &&
                          topology.faces_at(v) == 1;
    if (!topology.is_bowtie(v) && !one_face) continue;
    s.vertices_[v] = kInfinitelySharp;
    s.plain_[v] = 0;
  }
  return s;
}

}  // namespace surpass

// Face corners are glued together across every regular edge (two faces, in opposite directions);
// what is glued at a vertex is a fan. A fan that ends at an irregular edge gets a vertex of its
// own.
//
// Why this is enough: a fan that ends at an irregular edge is a strip of faces turned alike, so at
// most its two ends lie on that edge, one as first and one as last spoke. Hence at most two faces
// keep both end vertices of the edge in common, and these run along it in opposite directions.
#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/repair_steps.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {
namespace {

std::vector<Index> next_corners(const Mesh& mesh) {
  std::vector<Index> next(mesh.face_vertices.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.face_offsets[f];
    const Index end = mesh.face_offsets[f + 1];
    for (Index c = begin; c < end; ++c) next[c] = c + 1 == end ? begin : c + 1;
  }
  return next;
}

std::vector<Index> irregular_edges(const EdgeTable& edges) {
  std::vector<Index> irregular;
  for (Index e = 0; e < edges.edge_count(); ++e) {
    if (edges.halfedges(e).size() > 1 && !edges.is_regular(e)) irregular.push_back(e);
  }
  return irregular;
}

DisjointSets fans_of_corners(const EdgeTable& edges, const std::vector<Index>& next) {
  DisjointSets fans(next.size());
  for (Index e = 0; e < edges.edge_count(); ++e) {
    if (!edges.is_regular(e)) continue;
    const auto sides = edges.halfedges(e);
    fans.unite(sides[0], next[sides[1]]);
    fans.unite(sides[1], next[sides[0]]);
  }
  return fans;
}

}  // namespace

void split_non_manifold(Mended& mended) {
  const Mesh& mesh = mended.mesh;
  const EdgeTable edges(mesh);
  const auto irregular = irregular_edges(edges);
  if (irregular.empty()) return;
  const auto next = next_corners(mesh);
  DisjointSets fans = fans_of_corners(edges, next);

  // Of the fans to be separated at a vertex, the one with the first corner keeps the vertex.
  std::vector<unsigned char> separate(next.size(), 0);
  for (const Index e : irregular) {
    for (const Index h : edges.halfedges(e))
      separate[fans.find(h)] = separate[fans.find(next[h])] = 1;
  }
  std::vector<unsigned char> taken(mesh.points.size(), 0);
  std::vector<Index> vertex_of_fan(next.size(), kNone);
  Selection s = Selection::of_all_vertices(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) {
      const Index v = mesh.face_vertices[c];
      const Index fan = fans.find(c);
      if (vertex_of_fan[fan] == kNone) {
        vertex_of_fan[fan] = separate[fan] != 0 && taken[v] != 0 ? s.add_copy(v) : v;
        if (separate[fan] != 0) taken[v] = 1;
      }
      s.add_corner(c, vertex_of_fan[fan]);
    }
    s.end_face(f);
  }
  const std::size_t copies = s.vertex_source.size() - mesh.points.size();
  mended.mesh = select(mesh, std::move(s));
  mended.done.push_back(fmt::format(
      "split {} at which more than two faces meet or which no turning of faces can mend, adding {}",
      counted(irregular.size(), "edge", "edges"), counted(copies, "vertex copy", "vertex copies")));
}

}  // namespace surpass::repair_step

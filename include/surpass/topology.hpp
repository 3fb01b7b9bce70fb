// Who is next to whom: built once from a mesh, immutable, shared by everything that repeats.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass {

/// Half-edge view of a mesh with oriented, manifold edges.
///
/// Half-edge h is face corner h: it runs from `tail(h)`, the corner's vertex, to the face's next
/// vertex. Seen from outside, faces and the spokes of a vertex turn counterclockwise. Vertices with
/// several fans of faces (bow-ties) and isolated vertices are allowed.
class Topology {
 public:
  /// O(#corners) time for bounded valences. Fails, naming the element, on indices out of range,
  /// faces with fewer than three or with repeated vertices, edges of more than two faces, and
  /// neighbours of opposite orientation. Memory: about 60 bytes a vertex for triangles.
  static Result<Topology> build(const Mesh& mesh);

  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(vertices_.size()); }
  [[nodiscard]] Index face_count() const { return static_cast<Index>(face_offsets_.size() - 1); }
  [[nodiscard]] Index corner_count() const { return static_cast<Index>(face_vertices_.size()); }
  [[nodiscard]] Index edge_count() const { return static_cast<Index>(edge_halfedge_.size()); }

  // Half-edges.
  [[nodiscard]] Index tail(Index h) const { return face_vertices_[h]; }
  [[nodiscard]] Index head(Index h) const { return face_vertices_[next(h)]; }
  [[nodiscard]] Index face(Index h) const {
    if (common_degree_ == 3) return h / 3;
    if (common_degree_ == 4) return h / 4;
    return face_of_[h];
  }
  [[nodiscard]] Index next(Index h) const {
    if (common_degree_ == 3) return h % 3 == 2 ? h - 2 : h + 1;
    if (common_degree_ == 4) return h % 4 == 3 ? h - 3 : h + 1;
    const Index f = face(h);
    return h + 1 == face_offsets_[f + 1] ? face_offsets_[f] : h + 1;
  }
  [[nodiscard]] Index previous(Index h) const {
    if (common_degree_ == 3) return h % 3 == 0 ? h + 2 : h - 1;
    if (common_degree_ == 4) return h % 4 == 0 ? h + 3 : h - 1;
    const Index f = face(h);
    return h == face_offsets_[f] ? face_offsets_[f + 1] - 1 : h - 1;
  }
  /// The half-edge of the neighbouring face, or kNone on the boundary.
  [[nodiscard]] Index opposite(Index h) const { return opposite_[h]; }
  [[nodiscard]] Index edge(Index h) const { return edge_[h]; }
  /// The next spoke counterclockwise around tail(h); kNone after the last face of an open fan.
  [[nodiscard]] Index rotate(Index h) const { return opposite_[previous(h)]; }

  // Edges, numbered in the order of their smaller end vertex.
  [[nodiscard]] Index edge_halfedge(Index e) const { return edge_halfedge_[e]; }
  [[nodiscard]] bool is_boundary_edge(Index e) const {
    return opposite_[edge_halfedge_[e]] == kNone;
  }
  [[nodiscard]] std::array<Index, 2> edge_vertices(Index e) const {
    const Index h = edge_halfedge_[e];
    return {tail(h), head(h)};
  }
  /// The edge between two vertices, or kNone. O(valence of a).
  [[nodiscard]] Index find_edge(Index a, Index b) const;

  // Faces.
  [[nodiscard]] Index face_begin(Index f) const { return face_offsets_[f]; }
  [[nodiscard]] Index face_end(Index f) const { return face_offsets_[f + 1]; }
  [[nodiscard]] Index face_degree(Index f) const {
    return common_degree_ != 0 ? common_degree_ : face_end(f) - face_begin(f);
  }
  /// 3 or 4 where all faces are triangles or quads, else 0.
  [[nodiscard]] Index common_degree() const { return common_degree_; }

  // Vertices.
  /// A half-edge leaving v, or kNone for an isolated vertex. In an open fan it is the first spoke,
  /// the one on the boundary from which `rotate` reaches every face of the fan.
  [[nodiscard]] Index outgoing(Index v) const { return vertices_[v].outgoing; }
  [[nodiscard]] bool is_isolated(Index v) const { return outgoing(v) == kNone; }
  [[nodiscard]] bool is_boundary(Index v) const { return vertices_[v].boundary; }
  /// More than one fan of faces, open or closed.
  [[nodiscard]] bool is_bowtie(Index v) const { return vertices_[v].bowtie; }
  /// One starting half-edge per fan of v beyond the first, as for `outgoing`.
  [[nodiscard]] std::vector<Index> further_fans(Index v) const;

  /// Number of faces at v, all fans together.
  [[nodiscard]] Index faces_at(Index v) const { return vertices_[v].faces; }
  /// Number of edges at v, all fans together. O(1), but O(faces at v) for bow-ties.
  [[nodiscard]] Index valence(Index v) const;

  /// Calls visit(h) for every half-edge h leaving v, counterclockwise in each fan.
  template <class Visit>
  void for_each_outgoing(Index v, Visit&& visit) const {
    visit_fan(outgoing(v), visit);
    if (is_bowtie(v)) {
      for (const Index start : further_fans(v)) visit_fan(start, visit);
    }
  }

  /// Calls visit(w, e) for every neighbour w along edge e, counterclockwise in each fan; in an open
  /// fan the first and the last are on the boundary.
  template <class Visit>
  void for_each_spoke(Index v, Visit&& visit) const {
    for_each_outgoing(v, [&](Index h) {
      visit(head(h), edge(h));
      const Index p = previous(h);
      if (opposite_[p] == kNone) visit(tail(p), edge(p));
    });
  }

  /// Half-edges without opposite.
  [[nodiscard]] Index boundary_edge_count() const { return boundary_edges_; }

 private:
  struct Vertex {
    Index outgoing = kNone;
    Index faces : 30 = 0;  // enough, for a face has three corners or more
    bool boundary : 1 = false;
    bool bowtie : 1 = false;
  };
  struct FurtherFan {
    Index vertex;
    Index start;
  };

  template <class Visit>
  void visit_fan(Index start, Visit&& visit) const {
    for (Index h = start; h != kNone;) {
      visit(h);
      h = rotate(h);
      if (h == start) return;
    }
  }

  Result<void> match_halfedges();
  Result<void> explain_conflict(Index a, Index b) const;
  void find_fans();
  [[nodiscard]] bool has_further_fans() const;
  [[nodiscard]] Index in_first_fan(Index v) const {
    Index n = 0;
    visit_fan(outgoing(v), [&](Index) { ++n; });
    return n;
  }
  void find_further_fans();

  std::vector<Index> face_offsets_;
  std::vector<Index> face_vertices_;
  Index common_degree_ = 0;     // 3 or 4 where all faces are such, which is worth knowing
  std::vector<Index> face_of_;  // empty for those, where dividing is faster than looking up
  std::vector<Index> opposite_;
  std::vector<Index> edge_;
  std::vector<Index> edge_halfedge_;
  std::vector<Vertex> vertices_;
  std::vector<FurtherFan> further_fans_;  // ascending by vertex
  Index boundary_edges_ = 0;
};

/// Connected pieces, joined along edges and at shared vertices; isolated vertices do not count.
struct Components {
  Index count = 0;
  std::vector<Index>
      of_vertex;  ///< #V: 0..count-1 in the order of the first vertex, kNone if isolated
};
[[nodiscard]] Components find_components(const Topology& topology);

/// The closed loops of boundary half-edges, each as its half-edges in order. At a bow-tie vertex a
/// loop goes on along the boundary of the fan that it came by.
[[nodiscard]] std::vector<std::vector<Index>> boundary_loops(const Topology& topology);

}  // namespace surpass

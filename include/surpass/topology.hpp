// Who is next to whom: built once from a mesh, immutable, shared by everything that repeats.
#pragma once

#include <surpass/mesh.hpp>

#include <atomic>
#include <memory>
#include <mutex>
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
  /// neighbours of opposite orientation. Memory: 77 bytes a vertex for triangles, and 36 more once
  /// somebody asks for the number of an edge. Copies share both.
  static Result<Topology> build(const Mesh& mesh);

  [[nodiscard]] Index vertex_count() const { return vertex_count_; }
  [[nodiscard]] Index face_count() const { return face_count_; }
  [[nodiscard]] Index corner_count() const { return corner_count_; }
  [[nodiscard]] Index edge_count() const { return (corner_count_ + boundary_edges_) / 2; }

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
  [[nodiscard]] Index edge(Index h) const { return edges().of_halfedge[h]; }
  /// The next spoke counterclockwise around tail(h); kNone after the last face of an open fan.
  [[nodiscard]] Index rotate(Index h) const { return opposite_[previous(h)]; }

  // Edges, numbered in the order of their smaller end vertex when a number is asked for first:
  // O(#corners). Any thread may be the first.
  [[nodiscard]] Index edge_halfedge(Index e) const { return edges().halfedge[e]; }
  [[nodiscard]] bool is_boundary_edge(Index e) const {
    return opposite_[edge_halfedge(e)] == kNone;
  }
  [[nodiscard]] std::array<Index, 2> edge_vertices(Index e) const {
    const Index h = edge_halfedge(e);
    return {tail(h), head(h)};
  }
  /// The edge between two vertices, or kNone. O(valence of a).
  [[nodiscard]] Index find_edge(Index a, Index b) const;

  // Faces.
  [[nodiscard]] Index face_begin(Index f) const {
    return common_degree_ != 0 ? f * common_degree_ : face_offsets_[f];
  }
  [[nodiscard]] Index face_end(Index f) const { return face_begin(f + 1); }
  [[nodiscard]] Index face_degree(Index f) const {
    return common_degree_ != 0 ? common_degree_ : face_end(f) - face_begin(f);
  }
  /// 3 or 4 where all faces are triangles or quads, else 0.
  [[nodiscard]] Index common_degree() const { return common_degree_; }

  // Vertices.
  /// A half-edge leaving v, or kNone for an isolated vertex. In an open fan it is the first spoke,
  /// the one on the boundary from which `rotate` reaches every face of the fan.
  [[nodiscard]] Index outgoing(Index v) const {
    return is_isolated(v) ? kNone : around_[start_[v]];
  }
  [[nodiscard]] bool is_isolated(Index v) const { return faces_at(v) == 0; }
  [[nodiscard]] bool is_boundary(Index v) const { return (kinds_[v] & kBoundary) != 0; }
  /// More than one fan of faces, open or closed.
  [[nodiscard]] bool is_bowtie(Index v) const { return (kinds_[v] & kBowtie) != 0; }
  /// One starting half-edge per fan of v beyond the first, as for `outgoing`.
  [[nodiscard]] std::vector<Index> further_fans(Index v) const;

  /// Number of faces at v, all fans together.
  [[nodiscard]] Index faces_at(Index v) const { return start_[v + 1] - start_[v]; }
  /// Number of edges at v, all fans together. O(1), but O(faces at v) for bow-ties.
  [[nodiscard]] Index valence(Index v) const;

  /// Calls visit(h) for every half-edge h leaving v, counterclockwise in each fan.
  template <class Visit>
  void for_each_outgoing(Index v, Visit&& visit) const {
    for (Index k = start_[v]; k < start_[v + 1]; ++k) visit(around_[k]);
  }

  /// Calls visit(w, e) for every neighbour w along edge e, counterclockwise in each fan; in an open
  /// fan the first and the last are on the boundary.
  template <class Visit>
  void for_each_spoke(Index v, Visit&& visit) const {
    visit_spokes(v, [&](Index w, Index h) { visit(w, edge(h)); });
  }
  /// Calls visit(w) for the same neighbours.
  template <class Visit>
  void for_each_neighbour(Index v, Visit&& visit) const {
    visit_spokes(v, [&](Index w, Index) { visit(w); });
  }

  /// Half-edges without opposite.
  [[nodiscard]] Index boundary_edge_count() const { return boundary_edges_; }

 private:
  static constexpr unsigned char kBoundary = 1;
  static constexpr unsigned char kBowtie = 2;
  struct FurtherFan {
    Index vertex;
    Index start;
  };

  // Visits each neighbour, and a half-edge between it and v.
  template <class Visit>
  void visit_spokes(Index v, Visit&& visit) const {
    for_each_outgoing(v, [&](Index h) {
      visit(head(h), h);
      if (!is_boundary(v)) return;
      const Index p = previous(h);
      if (opposite_[p] == kNone) visit(tail(p), p);
    });
  }

  struct Edges {
    std::atomic<bool> numbered = false;
    std::mutex numbering;
    std::unique_ptr<Index[]> of_halfedge;  // #corners
    std::unique_ptr<Index[]> halfedge;     // #E, the smaller of the edge's one or two
  };
  [[nodiscard]] const Edges& edges() const {
    if (!edges_->numbered.load(std::memory_order_acquire)) number_edges();
    return *edges_;
  }
  void number_edges() const;

  template <class Faces>
  class FanMatching;
  template <class Faces>
  Result<void> match(const Mesh& mesh, const Faces& faces);

  // Arrays are not vectors where clearing them first would cost; copies share what never changes.
  Index vertex_count_ = 0;
  Index face_count_ = 0;
  Index corner_count_ = 0;
  Index common_degree_ = 0;          // 3 or 4 where all faces are such, which is worth knowing
  std::vector<Index> face_offsets_;  // empty for those, where computing is faster than looking up
  std::vector<Index> face_of_;       // likewise
  std::shared_ptr<Index[]> face_vertices_;
  std::shared_ptr<Index[]> opposite_;
  // Half-edges by the vertex that they leave, in the order of going around it: who goes around many
  // vertices reads them one after the other, where `rotate` would wait for memory at every step.
  std::shared_ptr<Index[]> around_;         // #corners
  std::shared_ptr<Index[]> start_;          // #V + 1: of each vertex, in `around_`
  std::shared_ptr<unsigned char[]> kinds_;  // #V
  std::shared_ptr<Edges> edges_ = std::make_shared<Edges>();
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

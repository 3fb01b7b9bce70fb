// Half-edge matching by counting sort: half-edges fall into the bucket of their smaller end vertex
// and find their partners inside it. Memory goes by in order but for the scatter into the buckets.
#include <surpass/topology.hpp>

#include <algorithm>
#include <functional>

#include "mesh/corner_faces.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_buckets.hpp"
#include "mesh/refusals.hpp"

namespace surpass {
namespace {

// Above this many entries a bucket is sorted rather than searched: a vertex can have any valence.
constexpr std::size_t kSearchedBucket = 32;

// The quick answer for nearly all faces of nearly all meshes.
bool is_sound_triangle(const Mesh& mesh, Index f) {
  const Index begin = mesh.face_offsets[f];
  if (mesh.face_offsets[f + 1] - begin != 3) return false;
  const Index a = mesh.face_vertices[begin];
  const Index b = mesh.face_vertices[begin + 1];
  const Index c = mesh.face_vertices[begin + 2];
  return a != b && b != c && c != a && std::max({a, b, c}) < mesh.points.size();
}

// 3 or 4 if all faces have that many corners, else 0.
Index degree_of_all_faces(const Mesh& mesh) {
  for (const Index degree : {Index{3}, Index{4}}) {
    const auto has_it = [&](Index begin, Index end) { return end - begin == degree; };
    // Stops at the first pair of neighbouring offsets that is farther or less far apart.
    const auto other =
        std::adjacent_find(mesh.face_offsets.begin(), mesh.face_offsets.end(), std::not_fn(has_it));
    if (other == mesh.face_offsets.end()) return degree;
  }
  return 0;
}

Result<void> check_faces(const Mesh& mesh) {
  if (mesh.face_vertices.size() > kMostCorners || mesh.points.size() > kMostCorners) {
    return tl::make_unexpected(refusal::too_large());
  }
  refusal::FaceCheck check(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (is_sound_triangle(mesh, f)) continue;
    if (auto error = check(f)) return tl::make_unexpected(*std::move(error));
  }
  return {};
}

// The next entry with this larger vertex, or the bucket's size. Large buckets are sorted, so there
// only one place is possible.
std::size_t find_same_edge(std::span<const BucketEntry> bucket, std::size_t from, Index larger) {
  const std::size_t end =
      bucket.size() > kSearchedBucket ? std::min(from + 1, bucket.size()) : bucket.size();
  for (std::size_t i = from; i < end; ++i) {
    if (bucket[i].larger == larger) return i;
  }
  return bucket.size();
}

}  // namespace

Result<Topology> Topology::build(const Mesh& mesh) {
  if (auto checked = check_faces(mesh); !checked) return tl::make_unexpected(checked.error());
  Topology t;
  t.face_offsets_ = mesh.face_offsets;
  t.face_vertices_ = mesh.face_vertices;
  t.vertices_.resize(mesh.points.size());
  t.common_degree_ = degree_of_all_faces(mesh);
  if (t.common_degree_ == 0) t.face_of_ = corner_faces(mesh);
  if (auto matched = t.match_halfedges(); !matched) return tl::make_unexpected(matched.error());
  t.find_fans();
  return t;
}

Result<void> Topology::match_halfedges() {
  const Index corners = corner_count();
  EdgeBuckets buckets(vertex_count(), face_offsets_, face_vertices_);
  opposite_.assign(corners, kNone);
  edge_.assign(corners, kNone);
  edge_halfedge_.reserve(corners / 2 + corners / 16 + 4);
  for (Index v = 0; v < vertex_count(); ++v) {
    const auto bucket = buckets[v];
    if (bucket.size() > kSearchedBucket) EdgeBuckets::sort(bucket);
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const BucketEntry entry = bucket[i];
      if (entry.larger == kNone) continue;  // matched from its partner
      const Index e = edge_count();
      edge_halfedge_.push_back(entry.halfedge());
      edge_[entry.halfedge()] = e;
      const std::size_t partner = find_same_edge(bucket, i + 1, entry.larger);
      if (partner == bucket.size()) {
        ++boundary_edges_;
        continue;
      }
      const BucketEntry other = bucket[partner];
      if (entry.reversed() == other.reversed() ||
          find_same_edge(bucket, partner + 1, entry.larger) != bucket.size()) {
        return explain_conflict(v, entry.larger);
      }
      bucket[partner].larger = kNone;
      edge_[other.halfedge()] = e;
      opposite_[entry.halfedge()] = other.halfedge();
      opposite_[other.halfedge()] = entry.halfedge();
    }
  }
  return {};
}

// The slow, exact account of an edge that failed: how many faces, and one of them.
Result<void> Topology::explain_conflict(Index a, Index b) const {
  Index faces = 0;
  Index first = kNone;
  for (Index f = 0; f < face_count(); ++f) {
    for (Index h = face_begin(f); h < face_end(f); ++h) {
      const Index p = tail(h);
      const Index q = head(h);
      if ((p == a && q == b) || (p == b && q == a)) {
        ++faces;
        if (first == kNone) first = f;
      }
    }
  }
  return tl::make_unexpected(faces > 2 ? refusal::non_manifold_edge(first, {a, b}, faces)
                                       : refusal::inconsistent_orientation(first, {a, b}));
}

// Chooses a start for every fan: the first spoke of an open fan, else the smallest half-edge.
void Topology::find_fans() {
  for (Index h = 0; h < corner_count(); ++h) {
    Vertex& v = vertices_[tail(h)];
    ++v.faces;
    if (opposite_[h] == kNone) {
      v.boundary = true;
      if (v.outgoing == kNone || opposite_[v.outgoing] != kNone) v.outgoing = h;
    } else if (v.outgoing == kNone) {
      v.outgoing = h;
    }
  }
  if (has_further_fans()) find_further_fans();
}

// Walks around several vertices abreast: a step waits for the memory that the one before names, but
// not for the steps around other vertices.
bool Topology::has_further_fans() const {
  constexpr Index kAbreast = 8;
  Index v = 0;
  for (; v + kAbreast <= vertex_count(); v += kAbreast) {
    Index at[kAbreast];
    Index left[kAbreast];  // steps until the closed fan must be through
    Index most = 0;
    for (Index k = 0; k < kAbreast; ++k) {
      const Vertex& vertex = vertices_[v + k];
      const bool closed = !vertex.boundary && vertex.outgoing != kNone;
      if (!closed && in_first_fan(v + k) != vertex.faces) return true;
      at[k] = closed ? vertex.outgoing : 0;
      left[k] = closed ? vertex.faces : 0;
      most = std::max(most, left[k]);
    }
    bool early = false;
    for (Index step = 1; step < most; ++step) {
      for (Index k = 0; k < kAbreast; ++k) {
        const Index next = rotate(at[k]);
        at[k] = step < left[k] ? next : at[k];
        early |= step < left[k] && next == vertices_[v + k].outgoing;
      }
    }
    if (early) return true;
  }
  for (; v < vertex_count(); ++v) {
    if (in_first_fan(v) != vertices_[v].faces) return true;
  }
  return false;
}

// A vertex with corners outside its first fan is a bow-tie.
void Topology::find_further_fans() {
  std::vector<unsigned char> visited(corner_count(), 0);
  const auto mark = [&](Index start) { visit_fan(start, [&](Index h) { visited[h] = 1; }); };
  for (const Vertex& vertex : vertices_) mark(vertex.outgoing);
  // Open fans first, so that no fan is entered in its middle.
  for (const bool open : {true, false}) {
    for (Index h = 0; h < corner_count(); ++h) {
      if (visited[h] != 0 || (opposite_[h] == kNone) != open) continue;
      further_fans_.push_back({tail(h), h});
      vertices_[tail(h)].bowtie = true;
      mark(h);
    }
  }
  std::stable_sort(further_fans_.begin(), further_fans_.end(),
                   [](const FurtherFan& a, const FurtherFan& b) { return a.vertex < b.vertex; });
}

std::vector<Index> Topology::further_fans(Index v) const {
  const auto [begin, end] = std::equal_range(
      further_fans_.begin(), further_fans_.end(), FurtherFan{v, 0},
      [](const FurtherFan& a, const FurtherFan& b) { return a.vertex < b.vertex; });
  std::vector<Index> starts;
  for (auto fan = begin; fan != end; ++fan) starts.push_back(fan->start);
  return starts;
}

// One more than faces in an open fan, as many in a closed one.
Index Topology::valence(Index v) const {
  if (!is_bowtie(v)) return faces_at(v) + (is_boundary(v) ? 1 : 0);
  Index n = 0;
  for_each_spoke(v, [&](Index, Index) { ++n; });
  return n;
}

Index Topology::find_edge(Index a, Index b) const {
  Index found = kNone;
  if (a >= vertex_count()) return found;
  for_each_spoke(a, [&](Index w, Index e) {
    if (w == b) found = e;
  });
  return found;
}

Components find_components(const Topology& topology) {
  DisjointSets sets(topology.vertex_count());
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index first = topology.tail(topology.face_begin(f));
    for (Index h = topology.face_begin(f) + 1; h < topology.face_end(f); ++h) {
      sets.unite(first, topology.tail(h));
    }
  }
  Components components;
  components.of_vertex.assign(topology.vertex_count(), kNone);
  std::vector<Index> number(topology.vertex_count(), kNone);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (topology.is_isolated(v)) continue;
    Index& n = number[sets.find(v)];
    if (n == kNone) n = components.count++;
    components.of_vertex[v] = n;
  }
  return components;
}

std::vector<std::vector<Index>> boundary_loops(const Topology& topology) {
  std::vector<std::vector<Index>> loops;
  std::vector<unsigned char> visited(topology.corner_count(), 0);
  for (Index start = 0; start < topology.corner_count(); ++start) {
    if (topology.opposite(start) != kNone || visited[start] != 0) continue;
    std::vector<Index>& loop = loops.emplace_back();
    for (Index h = start; visited[h] == 0;) {
      visited[h] = 1;
      loop.push_back(h);
      // Turn clockwise about head(h), face by face, to the next half-edge without opposite.
      h = topology.next(h);
      while (topology.opposite(h) != kNone) h = topology.next(topology.opposite(h));
    }
  }
  return loops;
}

}  // namespace surpass

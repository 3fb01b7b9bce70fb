// Half-edge matching by counting sort: half-edges fall into the bucket of their smaller end vertex
// and find their partners inside it. Memory goes by in order but for the scatter into the buckets.
#include <surpass/topology.hpp>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace surpass {
namespace {

// Above this many entries a bucket is sorted rather than searched: a vertex can have any valence.
constexpr std::size_t kSearchedBucket = 32;

// A half-edge in the bucket of its smaller vertex: larger vertex, number, and direction.
struct Entry {
  Index larger;
  Index halfedge_and_direction;  // number * 2 + (1 if it runs from the larger vertex)
  [[nodiscard]] Index halfedge() const { return halfedge_and_direction >> 1; }
  [[nodiscard]] bool reversed() const { return (halfedge_and_direction & 1) != 0; }
};

Result<void> check_faces(const Mesh& mesh) {
  constexpr Index kMost = kNone / 2;  // half-edge numbers keep a bit for the direction
  if (mesh.face_vertices.size() > kMost || mesh.points.size() > kMost) {
    return fail(ErrorCode::too_large,
                fmt::format("at most {} vertices and face corners can be held", kMost));
  }
  std::vector<Index> last_face(mesh.points.size(), kNone);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3) {
      return fail(ErrorCode::degenerate_face,
                  fmt::format("a face needs at least 3 vertices, this one has {}", face.size()),
                  {.face = f});
    }
    for (const Index v : face) {
      if (v >= mesh.points.size()) {
        return fail(ErrorCode::index_out_of_range,
                    fmt::format("a face names vertex {}, but there are {}", v, mesh.points.size()),
                    {.face = f});
      }
      if (last_face[v] == f) {
        return fail(ErrorCode::repeated_vertex, "a face names the same vertex twice",
                    {.vertex = v, .face = f});
      }
      last_face[v] = f;
    }
  }
  return {};
}

}  // namespace

Result<Topology> Topology::build(const Mesh& mesh) {
  if (auto checked = check_faces(mesh); !checked) return tl::make_unexpected(checked.error());
  Topology t;
  t.face_offsets_ = mesh.face_offsets;
  t.face_vertices_ = mesh.face_vertices;
  t.outgoing_.assign(mesh.points.size(), kNone);
  t.flags_.assign(mesh.points.size(), 0);
  if (mesh.face_count() > 0) {
    t.face_size_ = mesh.face_offsets[1];
    for (Index f = 1; f < mesh.face_count() && t.face_size_ != 0; ++f) {
      if (mesh.face_offsets[f + 1] - mesh.face_offsets[f] != t.face_size_) t.face_size_ = 0;
    }
  }
  if (t.face_size_ == 0) {
    t.face_of_.resize(mesh.face_vertices.size());
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index h = mesh.face_offsets[f]; h < mesh.face_offsets[f + 1]; ++h) t.face_of_[h] = f;
    }
  }
  if (auto matched = t.match_halfedges(); !matched) return tl::make_unexpected(matched.error());
  t.find_fans();
  return t;
}

Result<void> Topology::match_halfedges() {
  const Index n = vertex_count();
  const Index corners = corner_count();
  // Bucket v starts at start[v + 1] while filling, and at start[v] once every entry is in place.
  std::vector<Index> start(static_cast<std::size_t>(n) + 2, 0);
  const auto for_each_halfedge = [&](auto&& visit) {
    for (Index f = 0; f < face_count(); ++f) {
      const Index end = face_offsets_[f + 1];
      Index a = face_vertices_[end - 1];
      Index h = end - 1;
      for (Index k = face_offsets_[f]; k < end; ++k) {
        const Index b = face_vertices_[k];
        visit(h, a, b);
        a = b;
        h = k;
      }
    }
  };
  for_each_halfedge([&](Index, Index a, Index b) { ++start[std::min(a, b) + 2]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Entry> entries(corners);
  for_each_halfedge([&](Index h, Index a, Index b) {
    entries[start[std::min(a, b) + 1]++] = {std::max(a, b), h * 2 + (a > b ? 1U : 0U)};
  });

  opposite_.assign(corners, kNone);
  edge_.assign(corners, kNone);
  edge_halfedge_.clear();
  edge_halfedge_.reserve(corners / 2 + corners / 16 + 4);
  for (Index v = 0; v < n; ++v) {
    const auto begin = entries.begin() + start[v];
    const auto end = entries.begin() + start[v + 1];
    if (static_cast<std::size_t>(end - begin) > kSearchedBucket) {
      std::sort(begin, end, [](const Entry& p, const Entry& q) {
        return std::pair(p.larger, p.halfedge_and_direction) <
               std::pair(q.larger, q.halfedge_and_direction);
      });
    }
    const bool sorted = static_cast<std::size_t>(end - begin) > kSearchedBucket;
    for (auto i = begin; i != end; ++i) {
      if (edge_[i->halfedge()] != kNone) continue;  // matched from its partner
      const auto same = [&](const Entry& e) { return e.larger == i->larger; };
      const auto partner =
          sorted ? (i + 1 != end && same(i[1]) ? i + 1 : end) : std::find_if(i + 1, end, same);
      const Index e = edge_count();
      edge_halfedge_.push_back(i->halfedge());
      edge_[i->halfedge()] = e;
      if (partner == end) {
        ++boundary_edges_;
        continue;
      }
      edge_[partner->halfedge()] = e;
      opposite_[i->halfedge()] = partner->halfedge();
      opposite_[partner->halfedge()] = i->halfedge();
      const auto third = sorted ? (partner + 1 != end && same(partner[1]) ? partner + 1 : end)
                                : std::find_if(partner + 1, end, same);
      if (i->reversed() == partner->reversed() || third != end)
        return explain_conflict(v, i->larger);
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
  const Place place{.face = first, .edge = std::array{a, b}};
  if (faces > 2) {
    return fail(ErrorCode::non_manifold_edge,
                fmt::format("an edge has {} faces; at most 2 can meet at one", faces), place);
  }
  return fail(
      ErrorCode::inconsistent_orientation,
      "the two faces at an edge run along it in the same direction: one of them is inside out",
      place);
}

// Chooses a start for every fan: the first spoke of an open fan, else the smallest half-edge.
void Topology::find_fans() {
  std::vector<Index> faces_seen(vertex_count(), 0);
  for (Index h = 0; h < corner_count(); ++h) {
    const Index v = tail(h);
    ++faces_seen[v];
    const bool first_spoke = opposite_[h] == kNone;
    if (first_spoke) flags_[v] |= kBoundary;
    const Index old = outgoing_[v];
    if (old == kNone || (first_spoke && opposite_[old] != kNone)) outgoing_[v] = h;
  }
  // A bow-tie is a vertex whose first fan does not hold all of its faces.
  std::vector<Index> bowties;
  for (Index v = 0; v < vertex_count(); ++v) {
    Index in_fan = 0;
    visit_fan(outgoing_[v], [&](Index) { ++in_fan; });
    if (in_fan != faces_seen[v]) {
      flags_[v] |= kBowtie;
      bowties.push_back(v);
    }
  }
  if (bowties.empty()) return;
  std::vector<unsigned char> visited(corner_count(), 0);
  const auto mark = [&](Index start) { visit_fan(start, [&](Index h) { visited[h] = 1; }); };
  for (const Index v : bowties) mark(outgoing_[v]);
  // Open fans first, so that no fan is entered in its middle.
  for (const bool open : {true, false}) {
    for (Index h = 0; h < corner_count(); ++h) {
      if (visited[h] != 0 || !is_bowtie(tail(h)) || (opposite_[h] == kNone) != open) continue;
      further_fans_.push_back({tail(h), h});
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

Index Topology::valence(Index v) const {
  Index n = 0;
  for_each_spoke(v, [&](Index, Index) { ++n; });
  return n;
}

Index Topology::faces_at(Index v) const {
  Index n = 0;
  for_each_outgoing(v, [&](Index) { ++n; });
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
  std::vector<Index> parent(topology.vertex_count());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index a = root(topology.tail(topology.face_begin(f)));
    for (Index h = topology.face_begin(f) + 1; h < topology.face_end(f); ++h) {
      parent[root(topology.tail(h))] = a;
    }
  }
  Components components;
  components.of_vertex.assign(topology.vertex_count(), kNone);
  std::vector<Index> number(topology.vertex_count(), kNone);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (topology.is_isolated(v)) continue;
    Index& n = number[root(v)];
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

#include <surpass/topology.hpp>

#include <algorithm>

#include "mesh/disjoint_sets.hpp"

namespace surpass {

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
  for_each_neighbour(v, [&](Index) { ++n; });
  return n;
}

Index Topology::find_edge(Index a, Index b) const {
  Index found = kNone;
  if (a >= vertex_count()) return found;
  visit_spokes(a, [&](Index w, Index h) {
    if (w == b) found = h;
  });
  return found == kNone ? kNone : edge(found);
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

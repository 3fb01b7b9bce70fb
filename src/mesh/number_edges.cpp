// Edges are numbered by a counting sort by their smaller end vertex. It is put off until a number
// is asked for: interpolation on a closed mesh under Loop's rules, for one, never asks.
#include <surpass/topology.hpp>

#include <algorithm>
#include <numeric>
#include <span>

#include "mesh/edge_buckets.hpp"

namespace surpass {
namespace {

// Calls visit(h, v) for the first half-edge h of every edge and the smaller end vertex v, face by
// face; of a face, the last half-edge comes first.
template <class Visit>
void for_each_edge(const Topology& topology, Visit&& visit) {
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index end = topology.face_end(f);
    Index h = end - 1;
    Index a = topology.tail(h);
    for (Index k = topology.face_begin(f); k < end; ++k) {
      const Index b = topology.tail(k);
      // kNone is larger than any half-edge.
      if (h < topology.opposite(h)) visit(h, std::min(a, b));
      a = b;
      h = k;
    }
  }
}

Index larger_end(const Topology& topology, Index h) {
  return std::max(topology.tail(h), topology.head(h));
}

// Edges at a vertex with many half-edges are in the order of their larger end.
void sort_edges(const Topology& topology, std::span<Index> halfedges) {
  const auto sides = std::accumulate(
      halfedges.begin(), halfedges.end(), std::size_t{0},
      [&](std::size_t n, Index h) { return n + (topology.opposite(h) == kNone ? 1 : 2); });
  if (sides <= kSearchedBucket) return;
  std::sort(halfedges.begin(), halfedges.end(),
            [&](Index g, Index h) { return larger_end(topology, g) < larger_end(topology, h); });
}

}  // namespace

void Topology::number_edges() const {
  const std::lock_guard lock(edges_->numbering);
  if (edges_->numbered.load(std::memory_order_relaxed)) return;
  std::unique_ptr<Index[]> halfedge(new Index[edge_count()]);
  std::unique_ptr<Index[]> of_halfedge(new Index[corner_count()]);

  // Vertex v starts at start[v + 1] while filling, and at start[v] once every edge is in place.
  std::vector<Index> start(std::size_t{vertex_count()} + 2, 0);
  for_each_edge(*this, [&](Index, Index v) { ++start[v + 2]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  for_each_edge(*this, [&](Index h, Index v) { halfedge[start[v + 1]++] = h; });
  for (Index v = 0; v < vertex_count(); ++v) {
    const std::span<Index> edges(halfedge.get() + start[v], start[v + 1] - start[v]);
    if (edges.size() > kSearchedBucket / 2) sort_edges(*this, edges);
  }
  for (Index e = 0; e < edge_count(); ++e) {
    const Index h = halfedge[e];
    of_halfedge[h] = e;
    if (opposite_[h] != kNone) of_halfedge[opposite_[h]] = e;
  }
  edges_->halfedge = std::move(halfedge);
  edges_->of_halfedge = std::move(of_halfedge);
  edges_->numbered.store(true, std::memory_order_release);
}

}  // namespace surpass

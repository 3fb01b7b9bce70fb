#include <surpass/topology.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

Topology built(const Mesh& mesh) {
  auto topology = Topology::build(mesh);
  EXPECT_TRUE(topology) << describe(topology.error());
  return *std::move(topology);
}

std::vector<Index> ring(const Topology& topology, Index v) {
  std::vector<Index> neighbours;
  topology.for_each_spoke(v, [&](Index w, Index e) {
    neighbours.push_back(w);
    const auto ends = topology.edge_vertices(e);
    EXPECT_TRUE((ends == std::array{v, w}) || (ends == std::array{w, v}));
  });
  return neighbours;
}

// The same cyclic sequence, begun at the smallest element.
std::vector<Index> cyclic(std::vector<Index> list) {
  std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
  return list;
}

using Directed = std::pair<Index, Index>;

// The half-edges from one vertex to another; empty where two run the same way.
std::map<Directed, Index> halfedges_by_ends(const Mesh& mesh) {
  std::map<Directed, Index> found;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Directed ends{face[k], face[(k + 1) % face.size()]};
      if (!found.emplace(ends, static_cast<Index>(mesh.face_offsets[f] + k)).second) return {};
    }
  }
  return found;
}

// Edges as they are numbered: by their smaller vertex, and at one vertex in the order of faces, of
// which the last half-edge comes first; by the larger vertex where there are many half-edges.
std::vector<Index> edges_in_order(const Mesh& mesh) {
  constexpr std::size_t kMany = 32;
  struct Bucket {
    std::vector<std::pair<Index, Index>> edges;  // larger vertex, half-edge
    std::size_t halfedges = 0;
  };
  std::vector<Bucket> buckets(mesh.points.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t k = (i + face.size() - 1) % face.size();
      const auto [small, large] = std::minmax(face[k], face[(k + 1) % face.size()]);
      Bucket& bucket = buckets[small];
      ++bucket.halfedges;
      const auto known = std::find_if(bucket.edges.begin(), bucket.edges.end(),
                                      [&, w = large](const auto& e) { return e.first == w; });
      if (known != bucket.edges.end()) continue;
      bucket.edges.emplace_back(large, static_cast<Index>(mesh.face_offsets[f] + k));
    }
  }
  std::vector<Index> order;
  for (Bucket& bucket : buckets) {
    if (bucket.halfedges > kMany) std::sort(bucket.edges.begin(), bucket.edges.end());
    for (const auto& edge : bucket.edges) order.push_back(edge.second);
  }
  return order;
}

void expect_edges(const Topology& t, const std::vector<Index>& order) {
  ASSERT_EQ(t.edge_count(), order.size());
  for (Index e = 0; e < order.size(); ++e) {
    EXPECT_EQ(t.edge_halfedge(e), order[e]);
    EXPECT_EQ(t.edge(order[e]), e);
    const Index other = t.opposite(order[e]);
    if (other != kNone) {
      EXPECT_EQ(t.edge(other), e);
    }
  }
}

// Faces on few vertices, so that all that can happen at a vertex does.
Mesh random_faces(std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<Index>(random() % n); };
  const Index n = 4 + below(9);
  std::vector<Face> faces(1 + below(12));
  std::vector<Index> vertices(n);
  std::iota(vertices.begin(), vertices.end(), Index{0});
  const bool triangles = below(2) == 0;
  for (Face& face : faces) {
    std::shuffle(vertices.begin(), vertices.end(), random);
    face.assign(vertices.begin(), vertices.begin() + (triangles ? 3 : 3 + below(2)));
  }
  return samples::faces(n, faces);
}

// The starts of a vertex's fans: of open ones first, each kind in the order of half-edges; a closed
// fan starts at its smallest.
std::vector<Index> fan_starts(const Topology& t, Index v, const std::map<Directed, Index>& all) {
  std::vector<Index> leaving;
  for (const auto& [ends, h] : all) {
    if (ends.first == v) leaving.push_back(h);
  }
  std::sort(leaving.begin(), leaving.end());
  std::vector<Index> starts;
  std::set<Index> seen;
  for (const bool open : {true, false}) {
    for (const Index start : leaving) {
      if (seen.contains(start) || (open && all.contains({t.head(start), v}))) continue;
      starts.push_back(start);
      for (Index h = start; seen.insert(h).second;) {
        const auto next = all.find({v, t.tail(t.previous(h))});
        if (next == all.end()) break;
        h = next->second;
      }
    }
  }
  return starts;
}

Error refusal_of(const Mesh& mesh) {
  const auto topology = Topology::build(mesh);
  EXPECT_FALSE(topology);
  return topology ? Error{} : topology.error();
}

TEST(Topology, RingsOfACubeTurnCounterclockwise) {
  const Topology t = built(samples::cube());
  EXPECT_EQ(t.edge_count(), 12U);
  EXPECT_EQ(t.boundary_edge_count(), 0U);
  // Seen from outside the corner (0,0,0): x, then z, then y would be clockwise about (-1,-1,-1).
  EXPECT_EQ(cyclic(ring(t, 0)), (Face{1, 4, 2}));
  EXPECT_EQ(cyclic(ring(t, 7)), (Face{3, 6, 5}));
  for (Index v = 0; v < 8; ++v) {
    EXPECT_EQ(t.valence(v), 3U);
    EXPECT_EQ(t.faces_at(v), 3U);
    EXPECT_FALSE(t.is_boundary(v));
    EXPECT_FALSE(t.is_bowtie(v));
  }
}

TEST(Topology, OpenFanBeginsAndEndsOnTheBoundary) {
  const Topology t = built(samples::grid(2));
  EXPECT_EQ(ring(t, 0), (Face{1, 3}));
  EXPECT_EQ(ring(t, 1), (Face{2, 4, 0}));
  EXPECT_EQ(ring(t, 5), (Face{8, 4, 2}));
  EXPECT_EQ(cyclic(ring(t, 4)), (Face{1, 5, 7, 3}));
  EXPECT_TRUE(t.is_boundary(1));
  EXPECT_FALSE(t.is_boundary(4));
  EXPECT_EQ(t.boundary_edge_count(), 8U);
}

TEST(Topology, HalfEdgesAgreeWithTheFaces) {
  for (const Mesh& mesh : {samples::cube(), samples::grid(3), samples::tetrahedron(),
                           samples::torus(5, 7, false), samples::wheel(9, true)}) {
    const Topology t = built(mesh);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index h = mesh.face_offsets[f]; h < mesh.face_offsets[f + 1]; ++h) {
        EXPECT_EQ(t.face(h), f);
        EXPECT_EQ(t.previous(t.next(h)), h);
        EXPECT_EQ(t.head(h), t.tail(t.next(h)));
        const Index other = t.opposite(h);
        if (other == kNone) continue;
        EXPECT_EQ(t.opposite(other), h);
        EXPECT_EQ(t.tail(other), t.head(h));
        EXPECT_EQ(t.head(other), t.tail(h));
        EXPECT_EQ(t.edge(other), t.edge(h));
        EXPECT_EQ(t.find_edge(t.tail(h), t.head(h)), t.edge(h));
      }
    }
    EXPECT_EQ(t.find_edge(0, 0), kNone);
  }
}

TEST(Topology, BowtieOfTwoOpenFans) {
  const Topology t = built(samples::faces(5, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_TRUE(t.is_bowtie(0));
  EXPECT_TRUE(t.is_boundary(0));
  EXPECT_EQ(t.further_fans(0).size(), 1U);
  EXPECT_EQ(ring(t, 0), (Face{1, 2, 3, 4}));
  EXPECT_EQ(t.valence(0), 4U);
  EXPECT_EQ(t.faces_at(0), 2U);
  const auto loops = boundary_loops(t);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 3U);
  EXPECT_EQ(loops[1].size(), 3U);
  EXPECT_EQ(find_components(t).count, 1U);
}

TEST(Topology, BowtieOfClosedFans) {
  // Two tetrahedra that share vertex 0.
  const Topology t = built(samples::faces(
      7, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {0, 6, 5}}));
  EXPECT_TRUE(t.is_bowtie(0));
  EXPECT_FALSE(t.is_boundary(0));
  EXPECT_EQ(t.valence(0), 6U);
  EXPECT_EQ(t.faces_at(0), 6U);
  auto all = ring(t, 0);
  EXPECT_EQ(cyclic(Face(all.begin(), all.begin() + 3)), (Face{1, 3, 2}));
  EXPECT_EQ(cyclic(Face(all.begin() + 3, all.end())), (Face{4, 6, 5}));
}

TEST(Topology, BowtieOfAnOpenAndAClosedFan) {
  // The closed fan has the smaller half-edges, but the open one comes first.
  const Topology t =
      built(samples::faces(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 5, 0}}));
  EXPECT_TRUE(t.is_bowtie(0));
  EXPECT_TRUE(t.is_boundary(0));
  const auto all = ring(t, 0);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(Face(all.begin(), all.begin() + 2), (Face{4, 5}));
  EXPECT_EQ(t.opposite(t.outgoing(0)), kNone);
  EXPECT_EQ(t.opposite(t.previous(t.outgoing(0))), kNone);
}

TEST(Topology, OneBowtieAmongManyVertices) {
  // Fifty tetrahedra, two of which share a vertex: anywhere among the vertices, the last included.
  for (Index shared = 0; shared < 50; ++shared) {
    std::vector<Face> faces;
    for (Index k = 0; k < 50; ++k) {
      const Index a = 4 * k;
      const Index apex = k == 49 ? 4 * shared : a;
      const Index b = a + 1;
      const Index c = a + 2;
      const Index d = a + 3;
      for (const Face& face :
           {Face{apex, c, b}, Face{apex, b, d}, Face{b, c, d}, Face{apex, d, c}}) {
        faces.push_back(face);
      }
    }
    const Topology t = built(samples::faces(200, faces));
    for (Index v = 0; v < 200; ++v) EXPECT_EQ(t.is_bowtie(v), v == 4 * shared && shared != 49);
    EXPECT_EQ(t.valence(4 * shared), shared == 49 ? 3U : 6U);
  }
}

TEST(Topology, IsolatedVerticesHaveNoRing) {
  Mesh mesh = samples::tetrahedron();
  mesh.points.push_back({5, 5, 5});
  const Topology t = built(mesh);
  EXPECT_TRUE(t.is_isolated(4));
  EXPECT_EQ(t.valence(4), 0U);
  const Components parts = find_components(t);
  EXPECT_EQ(parts.count, 1U);
  EXPECT_EQ(parts.of_vertex[4], kNone);
  EXPECT_EQ(built(Mesh{}).edge_count(), 0U);
}

TEST(Topology, PillowOfTwoFacesIsClosed) {
  const Topology t = built(samples::faces(3, {{0, 1, 2}, {0, 2, 1}}));
  EXPECT_EQ(t.edge_count(), 3U);
  EXPECT_EQ(t.boundary_edge_count(), 0U);
  EXPECT_EQ(t.valence(0), 2U);
}

TEST(Topology, PoleOfAnyValenceKeepsItsOrder) {
  for (const bool closed : {true, false}) {
    const Topology t = built(samples::wheel(1000, closed));
    Face expected(1000);
    std::iota(expected.begin(), expected.end(), Index{1});
    EXPECT_EQ(cyclic(ring(t, 0)), expected);
    EXPECT_EQ(t.faces_at(0), closed ? 1000U : 999U);
    EXPECT_EQ(t.is_boundary(0), !closed);
  }
}

TEST(Topology, BoundaryLoopsFollowTheHoles) {
  Mesh all = samples::grid(3);
  Mesh mesh;
  mesh.points = all.points;
  for (Index f = 0; f < all.face_count(); ++f) {
    if (f != 4) mesh.add_face(all.face(f));
  }
  const Topology t = built(mesh);
  const auto loops = boundary_loops(t);
  ASSERT_EQ(loops.size(), 2U);
  std::multiset<std::size_t> lengths;
  for (const auto& loop : loops) {
    lengths.insert(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(t.opposite(loop[i]), kNone);
      EXPECT_EQ(t.head(loop[i]), t.tail(loop[(i + 1) % loop.size()]));
    }
  }
  EXPECT_EQ(lengths, (std::multiset<std::size_t>{4, 12}));
}

TEST(Topology, ComponentsAreNumberedByTheirFirstVertex) {
  const Topology t = built(samples::faces(9, {{7, 8, 1}, {0, 3, 5}, {4, 2, 6}}));
  const Components parts = find_components(t);
  EXPECT_EQ(parts.count, 3U);
  EXPECT_EQ(parts.of_vertex, (std::vector<Index>{0, 1, 2, 0, 2, 0, 2, 1, 1}));
}

TEST(Topology, PermutedVerticesGivePermutedRings) {
  const Mesh mesh = samples::torus(6, 5, false);
  const Topology t = built(mesh);
  std::vector<Index> number(mesh.points.size());
  std::iota(number.begin(), number.end(), Index{0});
  std::shuffle(number.begin(), number.end(), std::mt19937(7));
  Mesh permuted = mesh;
  for (Index& v : permuted.face_vertices) v = number[v];
  const Topology p = built(permuted);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    auto expected = ring(t, v);
    for (Index& w : expected) w = number[w];
    EXPECT_EQ(cyclic(ring(p, number[v])), cyclic(expected));
  }
}

TEST(Topology, EdgesAreNumberedByTheirSmallerVertex) {
  const Topology t = built(samples::torus(6, 5, false));
  Index last = 0;
  for (Index e = 0; e < t.edge_count(); ++e) {
    const auto [a, b] = t.edge_vertices(e);
    EXPECT_GE(std::min(a, b), last);
    last = std::min(a, b);
  }
}

TEST(Topology, AnyFacesAgreeWithASearchThroughAllOfThem) {
  std::mt19937 random(3);
  int accepted = 0;
  int bowties = 0;
  for (int round = 0; round < 4000; ++round) {
    const Mesh mesh = random_faces(random);
    const auto all = halfedges_by_ends(mesh);
    const auto topology = Topology::build(mesh);
    ASSERT_EQ(topology.has_value(), !all.empty());
    if (!topology) continue;
    ++accepted;
    const Topology& t = *topology;
    Index boundary = 0;
    for (const auto& [ends, h] : all) {
      const auto opposite = all.find({ends.second, ends.first});
      EXPECT_EQ(t.opposite(h), opposite == all.end() ? kNone : opposite->second);
      if (opposite == all.end()) ++boundary;
    }
    EXPECT_EQ(t.boundary_edge_count(), boundary);
    for (Index v = 0; v < t.vertex_count(); ++v) {
      std::vector<Index> starts = t.further_fans(v);
      if (t.is_bowtie(v)) ++bowties;
      EXPECT_EQ(t.is_bowtie(v), !starts.empty());
      if (!t.is_isolated(v)) starts.insert(starts.begin(), t.outgoing(v));
      EXPECT_EQ(starts, fan_starts(t, v, all));
    }
    expect_edges(t, edges_in_order(mesh));
  }
  EXPECT_GT(accepted, 400);
  EXPECT_GT(bowties, 100);
}

TEST(Topology, EdgesAreNumberedWhenAskedFor) {
  for (const Mesh& mesh :
       {samples::cube(), samples::grid(3), samples::torus(5, 7, false), samples::wheel(9, true),
        samples::wheel(40, true), samples::wheel(40, false), samples::wheel(32, false)}) {
    const std::vector<Index> order = edges_in_order(mesh);
    const Topology t = built(mesh);
    EXPECT_EQ(t.edge_count(), order.size());
    const Topology copy = t;
    expect_edges(copy, order);
    expect_edges(t, order);
  }
}

TEST(Topology, ManyThreadsMayAskForEdgesFirst) {
  const Mesh mesh = samples::torus(60, 50, false);
  const std::vector<Index> order = edges_in_order(mesh);
  for (int round = 0; round < 20; ++round) {
    const Topology t = built(mesh);
    std::vector<std::size_t> wrong(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < wrong.size(); ++k) {
      threads.emplace_back([&, k] {
        for (Index e = 0; e < order.size(); ++e) {
          wrong[k] += t.edge(order[e]) == e && t.edge_halfedge(e) == order[e] ? 0U : 1U;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<std::size_t>(4, 0));
  }
}

TEST(TopologyRefuses, FacesOfTwoVertices) {
  const Error error = refusal_of(samples::faces(4, {{0, 1, 2}, {1, 2}}));
  EXPECT_EQ(error.code, ErrorCode::degenerate_face);
  EXPECT_EQ(error.place.face, 1U);
}

TEST(TopologyRefuses, VerticesOutOfRange) {
  const Error error = refusal_of(samples::faces(4, {{0, 1, 2}, {0, 1, 4}}));
  EXPECT_EQ(error.code, ErrorCode::index_out_of_range);
  EXPECT_EQ(error.place.face, 1U);
}

TEST(TopologyRefuses, RepeatedVerticesInSmallAndLargeFaces) {
  Error error = refusal_of(samples::faces(4, {{0, 1, 2}, {3, 2, 3}}));
  EXPECT_EQ(error.code, ErrorCode::repeated_vertex);
  EXPECT_EQ(error.place.face, 1U);
  EXPECT_EQ(error.place.vertex, 3U);
  Face large(100);
  std::iota(large.begin(), large.end(), Index{0});
  large[77] = 13;
  error = refusal_of(samples::faces(100, {large}));
  EXPECT_EQ(error.code, ErrorCode::repeated_vertex);
  EXPECT_EQ(error.place.vertex, 13U);
}

TEST(TopologyRefuses, ThreeFacesAtAnEdge) {
  const Error error = refusal_of(samples::faces(6, {{3, 4, 5}, {0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(error.code, ErrorCode::non_manifold_edge);
  EXPECT_EQ(error.place.edge, (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(error.place.face, 1U);
}

TEST(TopologyRefuses, NeighboursThatDisagree) {
  const Error error = refusal_of(samples::faces(4, {{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(error.code, ErrorCode::inconsistent_orientation);
  EXPECT_EQ(error.place.edge, (std::array<Index, 2>{1, 2}));
  EXPECT_EQ(error.place.face, 0U);
  EXPECT_EQ(refusal_of(samples::band(5)).code, ErrorCode::inconsistent_orientation);
}

TEST(TopologyRefuses, WrongEdgesAtAPole) {
  Mesh mesh = samples::wheel(1000, true);
  mesh.points.push_back({0, 0, 1});
  mesh.add_face(Face{0, 500, 1001});
  const Error error = refusal_of(mesh);
  EXPECT_EQ(error.code, ErrorCode::non_manifold_edge);
  EXPECT_EQ(error.place.edge, (std::array<Index, 2>{0, 500}));
}

}  // namespace
}  // namespace surpass

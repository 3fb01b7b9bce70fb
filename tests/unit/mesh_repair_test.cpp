#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

Face face(const Mesh& mesh, Index f) { return {mesh.face(f).begin(), mesh.face(f).end()}; }

bool closed(const Mesh& mesh) {
  const auto topology = Topology::build(mesh);
  return topology && topology->boundary_edge_count() == 0;
}

// Whatever is done, points stay where they are, and copies lie on their originals.
void expect_same_positions(const Mesh& given, const Mesh& mended) {
  ASSERT_GE(mended.points.size(), given.points.size());
  EXPECT_TRUE(std::equal(given.points.begin(), given.points.end(), mended.points.begin()));
  for (const Point& p : mended.points) {
    EXPECT_NE(std::find(given.points.begin(), given.points.end(), p), given.points.end());
  }
}

TEST(Repair, LeavesSoundMeshesAsTheyAre) {
  for (const Mesh& mesh :
       {samples::cube(), samples::grid(4), samples::torus(7, 5, false), Mesh{},
        samples::faces(5, {{0, 1, 2}, {0, 3, 4}}), samples::faces(3, {{0, 1, 2}, {0, 2, 1}})}) {
    const Mended mended = repair(mesh);
    EXPECT_EQ(mended.mesh, mesh);
    EXPECT_TRUE(mended.done.empty());
  }
}

TEST(Repair, AnySoupBecomesManifold) {
  for (unsigned seed = 0; seed < 20000; ++seed) {
    const Mesh mesh = samples::soup(seed);
    const Mended mended = repair(mesh);
    const auto topology = Topology::build(mended.mesh);
    ASSERT_TRUE(topology) << seed << ": " << describe(topology.error());
    expect_same_positions(mesh, mended.mesh);
    const Mended again = repair(mended.mesh);
    EXPECT_EQ(again.mesh, mended.mesh) << seed;
    EXPECT_TRUE(again.done.empty()) << seed;
    EXPECT_EQ(mended.done.empty(), mended.mesh == mesh) << seed;
  }
}

TEST(Repair, DropsDegenerateAndRepeatedFaces) {
  Mesh mesh = samples::tetrahedron();
  mesh.add_face(Face{1, 1, 1});
  mesh.add_face(Face{0, 1});
  mesh.add_face(Face{0, 1, 0, 1});
  mesh.add_face(Face{1, 3, 2});
  mesh.add_face(Face{2, 1, 0, 0});
  const Mended mended = repair(mesh);
  EXPECT_EQ(mended.mesh, samples::tetrahedron());
  EXPECT_EQ(mended.done, (std::vector<std::string>{
                             "dropped 3 faces with fewer than three different vertices",
                             "dropped 1 face corner on the same vertex as the corner before",
                             "dropped 2 repeats of another face"}));
}

TEST(Repair, DropsFacesOfMissingVertices) {
  Mesh mesh = samples::tetrahedron();
  mesh.add_face(Face{0, 1, 9});
  EXPECT_EQ(repair(mesh).mesh, samples::tetrahedron());
}

TEST(Repair, KeepsQuadsThatShareAllVerticesButNotTheirEdges) {
  // The three quads of four vertices: a projective plane, each edge with two of them.
  const Mended mended = repair(samples::faces(4, {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}}));
  EXPECT_EQ(mended.mesh.face_count(), 3U);
  EXPECT_TRUE(Topology::build(mended.mesh));
}

TEST(Repair, TurnsTheMinorityAndKeepsFirstCorners) {
  Mesh mesh = samples::grid(3);
  Mesh wrong;
  wrong.points = mesh.points;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Face corners = face(mesh, f);
    if (f == 0 || f == 5) std::reverse(corners.begin() + 1, corners.end());
    wrong.add_face(corners);
  }
  const Mended mended = repair(wrong);
  EXPECT_EQ(mended.mesh, mesh);
  EXPECT_EQ(mended.done, (std::vector<std::string>{"turned 2 faces to agree with the neighbours"}));
}

TEST(Repair, TurnsClosedPiecesOutward) {
  Mesh inside_out = samples::cube();
  for (Index f = 0; f < 6; ++f) {
    std::reverse(inside_out.face_vertices.begin() + 4 * f + 1,
                 inside_out.face_vertices.begin() + 4 * f + 4);
  }
  EXPECT_DOUBLE_EQ(samples::six_volumes(inside_out), -6);
  const Mended mended = repair(inside_out);
  EXPECT_EQ(mended.mesh, samples::cube());
  EXPECT_EQ(mended.done,
            (std::vector<std::string>{"turned 1 closed piece outward, of negative volume before"}));
}

TEST(Repair, SeparatesTwoCubesAtTheirCommonEdge) {
  Mesh mesh = samples::cube();
  // A second cube beyond the edge 3-7 (x = 1, y = 1); its vertices 0 and 4 are 3 and 7.
  const Mesh other = samples::cube();
  std::vector<Index> number;
  for (Index v = 0; v < 8; ++v) {
    if (v == 0 || v == 4) {
      number.push_back(v == 0 ? 3 : 7);
      continue;
    }
    number.push_back(mesh.vertex_count());
    mesh.points.push_back({other.points[v][0] + 1, other.points[v][1] + 1, other.points[v][2]});
  }
  for (Index f = 0; f < 6; ++f) {
    Face corners = face(other, f);
    for (Index& v : corners) v = number[v];
    mesh.add_face(corners);
  }
  ASSERT_FALSE(Topology::build(mesh));
  const Mended mended = repair(mesh);
  EXPECT_TRUE(closed(mended.mesh));
  EXPECT_EQ(mended.mesh.points.size(), mesh.points.size() + 2);
  EXPECT_EQ(find_components(*Topology::build(mended.mesh)).count, 2U);
  EXPECT_DOUBLE_EQ(samples::six_volumes(mended.mesh), 12);
}

TEST(Repair, ThirdSheetAtAnEdgeGetsItsOwnVertices) {
  Mesh mesh = samples::cube();
  mesh.points.push_back({2, 2, 0.5});
  mesh.add_face(Face{3, 7, 8});
  mesh.creases = {{{7, 3}, 4.0F}};
  mesh.corners = {{3, 5.0F}};
  const Mended mended = repair(mesh);
  const auto topology = Topology::build(mended.mesh);
  ASSERT_TRUE(topology);
  EXPECT_EQ(mended.mesh.points.size(), 11U);
  EXPECT_EQ(face(mended.mesh, 6), (Face{9, 10, 8}));
  EXPECT_EQ(topology->boundary_edge_count(), 3U);
  // Both edges that the split made of the crease are creases, both vertices are corners.
  EXPECT_EQ(mended.mesh.creases, (std::vector<Crease>{{{7, 3}, 4.0F}, {{9, 10}, 4.0F}}));
  EXPECT_EQ(mended.mesh.corners, (std::vector<Corner>{{3, 5.0F}, {9, 5.0F}}));
}

TEST(Repair, CutsMoebiusBandsOnce) {
  for (const Index n : {5U, 7U, 31U}) {
    const Mesh mesh = samples::band(n);
    const Mended mended = repair(mesh);
    const auto topology = Topology::build(mended.mesh);
    ASSERT_TRUE(topology);
    // A strip of n triangles has n + 2 vertices and one boundary.
    EXPECT_EQ(mended.mesh.face_count(), n);
    EXPECT_EQ(mended.mesh.points.size(), n + 2);
    EXPECT_EQ(boundary_loops(*topology).size(), 1U);
  }
}

TEST(Repair, CutsKleinBottlesOpen) {
  const Mesh mesh = samples::torus(8, 6, true);
  ASSERT_EQ(Topology::build(mesh).error().code, ErrorCode::inconsistent_orientation);
  const Mended mended = repair(mesh);
  const auto topology = Topology::build(mended.mesh);
  ASSERT_TRUE(topology);
  EXPECT_EQ(mended.mesh.face_count(), mesh.face_count());
  EXPECT_GT(topology->boundary_edge_count(), 0U);
  expect_same_positions(mesh, mended.mesh);
}

TEST(Repair, SlitsPolygonsAlongABridgeToAHole) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                 {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  mesh.add_face(Face{0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  const Mended mended = repair(mesh);
  EXPECT_EQ(face(mended.mesh, 0), (Face{0, 1, 2, 3, 8, 4, 5, 6, 7, 9}));
  EXPECT_EQ(mended.mesh.points[8], mesh.points[0]);
  EXPECT_EQ(mended.mesh.points[9], mesh.points[4]);
  EXPECT_TRUE(Topology::build(mended.mesh));
}

TEST(Repair, PolesAreNotQuadratic) {
  // 100,000 faces around one vertex, every second one inside out.
  Mesh mesh = samples::wheel(100000, true);
  for (Index f = 0; f < mesh.face_count(); f += 2) {
    std::swap(mesh.face_vertices[3 * f + 1], mesh.face_vertices[3 * f + 2]);
  }
  EXPECT_TRUE(Topology::build(repair(mesh).mesh));
  EXPECT_EQ(diagnose(mesh).refusal_count, 100000U);
}

}  // namespace
}  // namespace surpass

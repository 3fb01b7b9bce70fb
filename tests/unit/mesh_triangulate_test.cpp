#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

Mesh polygon(std::vector<Point> outline) {
  Mesh mesh;
  mesh.points = std::move(outline);
  Face face(mesh.points.size());
  std::iota(face.begin(), face.end(), Index{0});
  mesh.add_face(face);
  return mesh;
}

double doubled_area(const Mesh& mesh, Index f) {
  const auto face = mesh.face(f);
  double sum = 0;
  for (std::size_t i = 2; i < face.size(); ++i) {
    const Point& a = mesh.points[face[0]];
    const Point& b = mesh.points[face[i - 1]];
    const Point& c = mesh.points[face[i]];
    sum += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  return sum;
}

// In the plane z = 0: k - 2 triangles of positive area that together have the polygon's area do not
// overlap; the polygon's edges are their boundary.
void expect_cut(const Mesh& mesh) {
  const Mesh cut = triangulate(mesh).mesh;
  const auto k = mesh.face(0).size();
  ASSERT_EQ(cut.face_count(), k - 2);
  double sum = 0;
  for (Index f = 0; f < cut.face_count(); ++f) {
    EXPECT_GT(doubled_area(cut, f), 0);
    sum += doubled_area(cut, f);
  }
  EXPECT_NEAR(sum, doubled_area(mesh, 0), 1e-9 * std::abs(sum));
  const auto topology = Topology::build(cut);
  ASSERT_TRUE(topology);
  EXPECT_EQ(topology->boundary_edge_count(), k);
  for (Index i = 0; i < k; ++i) {
    EXPECT_NE(topology->find_edge(i, (i + 1) % static_cast<Index>(k)), kNone);
  }
}

std::vector<Point> star(Index k, double inner) {
  std::vector<Point> points;
  const double pi = std::acos(-1.0);
  for (Index i = 0; i < k; ++i) {
    const double r = i % 2 == 0 ? 1 : inner;
    points.push_back({r * std::cos(2 * pi * i / k), r * std::sin(2 * pi * i / k), 0});
  }
  return points;
}

TEST(Triangulate, LeavesTrianglesAlone) {
  const Mesh mesh = samples::tetrahedron();
  EXPECT_EQ(triangulate(mesh).mesh, mesh);
  EXPECT_TRUE(triangulate(mesh).done.empty());
}

TEST(Triangulate, QuadsAlongTheShorterDiagonal) {
  const Mended cut = triangulate(polygon({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {0, 1, 0}}));
  ASSERT_EQ(cut.mesh.face_count(), 2U);
  EXPECT_NE(Topology::build(cut.mesh)->find_edge(1, 3), kNone);
  EXPECT_EQ(cut.done, (std::vector<std::string>{"cut 1 polygon into 2 triangles"}));
}

TEST(Triangulate, DartsAtTheirReflexCorner) {
  const Mended cut = triangulate(polygon({{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}));
  EXPECT_NE(Topology::build(cut.mesh)->find_edge(0, 2), kNone);
}

TEST(Triangulate, ConcaveOutlines) {
  expect_cut(polygon(star(5, 1)));
  expect_cut(polygon(star(14, 0.3)));
  expect_cut(polygon(star(1000, 0.999)));
  // A comb, with corners on straight lines.
  expect_cut(polygon({{0, 0, 0},
                      {1, 0, 0},
                      {2, 0, 0},
                      {3, 0, 0},
                      {3, 2, 0},
                      {2, 2, 0},
                      {2, 1, 0},
                      {1, 1, 0},
                      {1, 2, 0},
                      {0, 2, 0},
                      {0, 1, 0}}));
}

TEST(Triangulate, ASpiral) {
  std::vector<Point> outline;
  const auto at = [](double turn, double r) {
    return Point{r * std::cos(turn), r * std::sin(turn), 0};
  };
  for (int i = 0; i <= 300; ++i) outline.push_back(at(0.1 * i, 1 + 0.1 * i));
  for (int i = 300; i >= 0; --i) outline.push_back(at(0.1 * i, 0.8 + 0.1 * i));
  expect_cut(polygon(outline));
}

TEST(Triangulate, RandomStarShapes) {
  std::mt19937 random(11);
  const double pi = std::acos(-1.0);
  for (int round = 0; round < 300; ++round) {
    const auto k = static_cast<Index>(4 + random() % 40);
    std::vector<Point> outline;
    for (Index i = 0; i < k; ++i) {
      const double r = 0.1 + static_cast<double>(random()) / 4294967295.0;
      outline.push_back({r * std::cos(2 * pi * i / k), r * std::sin(2 * pi * i / k), 0});
    }
    expect_cut(polygon(outline));
  }
}

TEST(Triangulate, AnyPlaneAndScale) {
  // The same cut, whichever way the polygon faces and however large it is.
  Mesh flat = polygon(star(16, 0.4));
  for (std::size_t v = 0; v < 16; ++v) flat.points[v][0] *= 1 + 0.01 * static_cast<double>(v * v);
  const Mesh cut = triangulate(flat).mesh;
  for (const double scale : {1.0, 1e200, 1e-200}) {
    Mesh turned = flat;
    for (Point& p : turned.points) p = {0, p[0] * scale, p[1] * scale};
    EXPECT_EQ(triangulate(turned).mesh.face_vertices, cut.face_vertices);
    for (std::size_t v = 0; v < turned.points.size(); ++v) {
      turned.points[v] = {flat.points[v][1] * scale, flat.points[v][0] * scale, 0};
    }
    EXPECT_EQ(triangulate(turned).mesh.face_vertices, cut.face_vertices);
  }
}

TEST(Triangulate, PolygonsWithABridgeToAHole) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                 {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  mesh.add_face(Face{0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  const Mesh cut = triangulate(mesh).mesh;
  double sum = 0;
  for (Index f = 0; f < cut.face_count(); ++f) {
    EXPECT_GT(doubled_area(cut, f), 0);
    sum += doubled_area(cut, f);
  }
  EXPECT_DOUBLE_EQ(sum, 16);
  EXPECT_TRUE(Topology::build(cut));
}

TEST(Triangulate, OutlinesThatCannotBeCutWellAreCutAllTheSame) {
  EXPECT_EQ(triangulate(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}})).mesh.face_count(),
            2U);
  EXPECT_EQ(triangulate(polygon(std::vector<Point>(40, {1, 2, 3}))).mesh.face_count(), 38U);
  std::vector<Point> line;
  for (int i = 0; i < 30; ++i) line.push_back({double(i), 2.0 * i, 0});
  EXPECT_EQ(triangulate(polygon(line)).mesh.face_count(), 28U);
  line[7][0] = std::nan("");
  EXPECT_EQ(triangulate(polygon(line)).mesh.face_count(), 28U);
}

TEST(Triangulate, LargePolygonsInAMoment) {
  expect_cut(polygon(star(150000, 1)));
  expect_cut(polygon(star(150000, 0.9999)));
  EXPECT_EQ(triangulate(polygon(std::vector<Point>(150000, {1, 2, 3}))).mesh.face_count(), 149998U);
}

}  // namespace
}  // namespace surpass

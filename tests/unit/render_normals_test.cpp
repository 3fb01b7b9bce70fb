#include "mesh_samples.hpp"
#include "render/corner_normals.hpp"
#include "render/display_mesh.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using picture::Vec3;

// Two squares that meet at the y axis and fall by `degrees` on both sides.
Mesh roof(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  Mesh mesh;
  mesh.points = {{-c, 0, -s}, {0, 0, 0}, {c, 0, -s}, {-c, 1, -s}, {0, 1, 0}, {c, 1, -s}};
  mesh.add_face(std::array<Index, 4>{0, 1, 4, 3});
  mesh.add_face(std::array<Index, 4>{1, 2, 5, 4});
  return mesh;
}

std::vector<Vec3> smooth(const Mesh& mesh, double crease_angle = 45) {
  return picture::smooth_normals(mesh, *Topology::build(mesh), crease_angle);
}

constexpr Index kRidgeLeft = 1;   // corner of the left square at vertex 1
constexpr Index kRidgeRight = 4;  // corner of the right square at vertex 1

TEST(RenderNormals, AverageAcrossGentleEdges) {
  const std::vector<Vec3> n = smooth(roof(10));
  EXPECT_LT((n[kRidgeLeft] - Vec3(0, 0, 1)).norm(), 1e-6);
  EXPECT_LT((n[kRidgeRight] - Vec3(0, 0, 1)).norm(), 1e-6);
  EXPECT_LT((n[0] - Vec3(-std::sin(0.1745329F), 0, std::cos(0.1745329F))).norm(), 1e-6);
}

TEST(RenderNormals, PartAtCreasesAndSharpAngles) {
  Mesh creased = roof(10);
  creased.creases = {{{4, 1}, 0.5F}};
  const Vec3 left(-std::sin(0.1745329F), 0, std::cos(0.1745329F));
  EXPECT_LT((smooth(creased)[kRidgeLeft] - left).norm(), 1e-6);
  EXPECT_LT((smooth(creased)[kRidgeRight] - Vec3(-left.x(), 0, left.z())).norm(), 1e-6);
  creased.creases.front().sharpness = 0;
  EXPECT_LT((smooth(creased)[kRidgeLeft] - Vec3(0, 0, 1)).norm(), 1e-6);

  EXPECT_LT((smooth(roof(10), 19)[kRidgeLeft] - left).norm(), 1e-6);  // it turns by 20 degrees
  EXPECT_LT((smooth(roof(10), 21)[kRidgeLeft] - Vec3(0, 0, 1)).norm(), 1e-6);
}

TEST(RenderNormals, CubeIsFacettedUnlessToldOtherwise) {
  const Mesh cube = samples::cube();
  const std::vector<Vec3> facets = picture::facet_normals(cube);
  EXPECT_EQ(smooth(cube), facets);
  const std::vector<Vec3> round = smooth(cube, 91);
  for (Index c = 0; c < cube.corner_count(); ++c) {
    const Point& p = cube.points[cube.face_vertices[c]];
    const Vec3 outward(static_cast<float>(2 * p[0] - 1), static_cast<float>(2 * p[1] - 1),
                       static_cast<float>(2 * p[2] - 1));
    EXPECT_LT((round[c] - outward.normalized()).norm(), 1e-6) << c;
  }
}

TEST(RenderNormals, ChannelHoldsWhereNothingIsCreased) {
  Mesh mesh = roof(30);  // turns by 60 degrees, yet its author says that it is smooth
  Channel& normal = mesh.channels.emplace_back();
  normal.name = "normal";
  normal.parts = {"x", "y", "z"};
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    normal.values.insert(normal.values.end(), {0, v == 1 ? 3.0 : 0.0, v == 1 ? 4.0 : 1.0});
  }
  EXPECT_LT((smooth(mesh)[kRidgeLeft] - Vec3(0, 0.6F, 0.8F)).norm(), 1e-6);
  EXPECT_LT((smooth(mesh)[kRidgeRight] - Vec3(0, 0.6F, 0.8F)).norm(), 1e-6);
  normal.values[4] = normal.values[5] = 0;  // no direction at vertex 1
  EXPECT_LT((smooth(mesh)[kRidgeLeft] - Vec3(0, 0, 1)).norm(), 1e-6);
  mesh.creases = {{{1, 4}, 10}};
  EXPECT_LT((smooth(mesh)[kRidgeLeft] - Vec3(-0.5F, 0, std::sqrt(0.75F))).norm(), 1e-6);
}

TEST(RenderDisplayMesh, KnowsThePolygonsOwnSides) {
  Mesh mesh;  // an L: concave
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  mesh.add_face(std::array<Index, 6>{0, 1, 2, 3, 4, 5});
  const auto display = picture::make_display_mesh(mesh, {});
  ASSERT_TRUE(display);
  ASSERT_EQ(display->triangles.size(), 4U);
  double area = 0;
  int own = 0;
  for (const picture::Triangle& t : display->triangles) {
    const auto at = [&](std::size_t k) { return picture::to_vector(mesh.points[t.vertices[k]]); };
    const double doubled = (at(1) - at(0)).cross(at(2) - at(0)).z();
    EXPECT_GT(doubled, 0);
    area += doubled / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(t.own_side[k], t.vertices[(k + 1) % 3] == (t.vertices[k] + 1) % 6);
      own += t.own_side[k] ? 1 : 0;
    }
  }
  EXPECT_EQ(area, 3);
  EXPECT_EQ(own, 6);
}

TEST(RenderDisplayMesh, DrawsWhatIsNoManifoldWithFlatFacets) {
  Mesh fan = roof(10);  // a third square at the ridge
  fan.points.push_back({0, 0, 1});
  fan.points.push_back({0, 1, 1});
  fan.add_face(std::array<Index, 4>{1, 4, 7, 6});
  const auto display = picture::make_display_mesh(fan, {});
  ASSERT_TRUE(display);
  EXPECT_EQ(display->triangles.size(), 6U);
  EXPECT_EQ(display->corner_normals, picture::facet_normals(fan));
}

}  // namespace
}  // namespace surpass

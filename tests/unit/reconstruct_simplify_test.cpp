// Simplification: vertices stay where they were, tolerances hold, features and topology survive.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "reconstruct/features.hpp"
#include "reconstruct_clouds.hpp"
#include "support/meshes.hpp"

namespace surpass::test {
namespace {

using Eigen::Vector3d;

double smallest_angle(const Mesh& mesh) {
  double smallest = 180;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d a = vec(mesh.points[face[(k + 1) % 3]]) - vec(mesh.points[face[k]]);
      const Vector3d b = vec(mesh.points[face[(k + 2) % 3]]) - vec(mesh.points[face[k]]);
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI);
    }
  }
  return smallest;
}

Index largest_valence(const Mesh& mesh) {
  const auto topology = Topology::build(mesh);
  Index largest = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) largest = std::max(largest, topology->valence(v));
  return largest;
}

TEST(Simplify, ToANumberOfVertices) {
  const std::vector<Cloud> clouds = {sphere_cloud(3000), torus_cloud(4000, 1),
                                     double_torus_cloud()};
  for (std::size_t genus = 0; genus < clouds.size(); ++genus) {
    SCOPED_TRACE(genus);
    const Cloud& cloud = clouds[genus];
    const double angle_before = smallest_angle(reconstructed(cloud).mesh);
    const auto valence_before = largest_valence(reconstructed(cloud).mesh);
    const Reconstruction found = reconstructed(cloud, {.vertices = Index{400}});
    EXPECT_EQ(found.mesh.vertex_count(), 400U);
    EXPECT_EQ(found.report.full_vertices, cloud.size());
    expect_closed(found, genus);
    expect_input_points(found, cloud);
    EXPECT_GE(smallest_angle(found.mesh), std::min(10.0, angle_before) - 1e-9);
    EXPECT_LE(largest_valence(found.mesh), std::max(Index{10}, valence_before));
    EXPECT_EQ(std::set<Index>(found.source.begin(), found.source.end()).size(), 400U);
  }
}

TEST(Simplify, ToFewerThanTheGuardsAllow) {
  const Reconstruction found = reconstructed(torus_cloud(2000, 3), {.vertices = Index{4}});
  EXPECT_GT(found.mesh.vertex_count(), 6U);  // no torus has fewer than seven
  EXPECT_LT(found.mesh.vertex_count(), 200U);
  expect_closed(found, 1);
  ASSERT_EQ(found.report.warnings.size(), 1U);
  EXPECT_NE(found.report.warnings[0].find("more than the 4 asked for"), std::string::npos);
}

TEST(Simplify, NoToleranceIsExceeded) {
  const std::vector<Cloud> clouds = {sphere_cloud(1500), torus_cloud(2000, 5), cube_cloud(15),
                                     wave_cloud(35)};
  for (std::size_t shape = 0; shape < clouds.size(); ++shape) {
    const Cloud& cloud = clouds[shape];
    const double side = bounding_box(cloud).side();
    std::size_t vertices_before = cloud.size() + 1;
    for (const double tolerance : {1e-6, 1e-4, 1e-3, 3e-3, 1e-2}) {
      SCOPED_TRACE(testing::Message() << "shape " << shape << " tolerance " << tolerance);
      const Reconstruction found = reconstructed(cloud, {.tolerance = tolerance});
      ASSERT_TRUE(found.unused.empty());
      expect_input_points(found, cloud);
      double largest = 0;  // by another computation, of some points
      for (std::size_t i = 0; i < cloud.size(); i += 20) {
        largest = std::max(largest, slow_distance(cloud[i], found.mesh));
      }
      EXPECT_LE(largest, tolerance * side);
      EXPECT_LE(point_distances(cloud, found.mesh)->max, tolerance * side);
      EXPECT_LE(largest, found.report.polyhedron_max * side + 1e-12);
      EXPECT_LE(found.report.polyhedron_max, tolerance);
      EXPECT_LE(found.mesh.vertex_count(), vertices_before);
      vertices_before = found.mesh.vertex_count();
    }
    EXPECT_LT(vertices_before, cloud.size() / 2);
  }
}

TEST(Simplify, WithAToleranceAndANumberWhicheverComesFirst) {
  const Cloud cloud = torus_cloud(2000, 5);
  const Index by_tolerance = reconstructed(cloud, {.tolerance = 3e-3}).mesh.vertex_count();
  const Reconstruction both =
      reconstructed(cloud, {.tolerance = 3e-3, .vertices = by_tolerance + 100});
  EXPECT_EQ(both.mesh.vertex_count(), by_tolerance + 100);
  const Reconstruction strict = reconstructed(cloud, {.tolerance = 1e-4, .vertices = Index{10}});
  EXPECT_LE(strict.report.polyhedron_max, 1e-4);
  EXPECT_GT(strict.mesh.vertex_count(), 10U);
}

TEST(Simplify, TheOutlineOfASheetStays) {
  const Cloud cloud = wave_cloud(40);
  const Reconstruction found = reconstructed(cloud, {.tolerance = 2e-3});
  EXPECT_EQ(found.report.open_loops, 1U);
  EXPECT_LT(found.mesh.vertex_count(), cloud.size() / 2);
  EXPECT_LE(found.report.polyhedron_max, 2e-3);
}

TEST(Features, ACubeHasTwelveEdgesAndEightCorners) {
  constexpr int kPoints = 13;
  const Cloud cloud = cube_cloud(kPoints);
  for (const bool simplified : {false, true}) {
    SCOPED_TRACE(simplified);
    ReconstructOptions options = {.feature_angle = 40.0};
    if (simplified) options.vertices = 150;
    const Reconstruction found = reconstructed(cloud, options);
    expect_closed(found, 0);
    double length = 0;
    std::map<Index, int> ends;
    for (const Crease& crease : found.mesh.creases) {
      EXPECT_EQ(crease.sharpness, kInfinitelySharp);
      length +=
          (vec(found.mesh.points[crease.vertices[0]]) - vec(found.mesh.points[crease.vertices[1]]))
              .norm();
      for (const Index v : crease.vertices) ++ends[v];
    }
    EXPECT_NEAR(length, 12, 1e-12);
    EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& e) { return e.second == 3; }),
              8);
    EXPECT_EQ(found.report.creases, found.mesh.creases.size());
  }
}

TEST(Features, TheSurfaceOfACubeIsTheCube) {
  // With creases the limit surface keeps edges and corners, without it rounds them.
  const Cloud cloud = cube_cloud(13);
  const auto farthest = [&](std::optional<double> angle) {
    const Reconstruction found =
        reconstructed(cloud, {.vertices = Index{200}, .feature_angle = angle});
    const Rules rules{.scheme = Scheme::doo_sabin};
    const auto control = interpolate(found.mesh, {.rules = rules, .tolerance = 1e-12});
    EXPECT_TRUE(control) << describe(control.error());
    return limit_distances(cloud, found.source, found.unused, control->control, rules)->all.max;
  };
  EXPECT_LT(farthest(40.0), 1e-9);
  EXPECT_GT(farthest({}), 1e-3);
}

TEST(Features, SmoothSurfacesHaveNone) {
  const Reconstruction found = reconstructed(sphere_cloud(2000), {.feature_angle = 30.0});
  EXPECT_TRUE(found.mesh.creases.empty());
  EXPECT_TRUE(found.mesh.corners.empty());
}

TEST(Features, WhereACurveTurnsThereIsACorner) {
  // Flat double pyramids: their outline is one crease, with corners if it has few sides.
  for (const Index sides : {Index{4}, Index{40}}) {
    Mesh mesh = bipyramid(sides);
    mesh.points[sides][2] = 0.2;
    mesh.points[sides + 1][2] = -0.2;
    const auto found = reconstruction::find_features(mesh, *Topology::build(mesh), 60);
    EXPECT_EQ(found.creases.size(), sides);
    EXPECT_EQ(found.corners.size(), sides == 4 ? 4U : 0U);
  }
}

}  // namespace
}  // namespace surpass::test

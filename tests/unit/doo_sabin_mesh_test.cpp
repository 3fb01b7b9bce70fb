// Limit meshes of Doo-Sabin surfaces: duals of refined meshes.
#include "doo_sabin_samples.hpp"

namespace surpass::test {
namespace {

TEST(DooSabinLimitMesh, BeginsWithTheLimitsOfTheGivenVertices) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto limit = limit_positions(sample.mesh, rules).value();
    const double side = bounding_box(sample.mesh.points).side();
    for (int levels = 0; levels <= 3; ++levels) {
      const auto mesh = limit_mesh(sample.mesh, rules, levels);
      ASSERT_TRUE(mesh) << describe(mesh.error());
      const std::vector<Point> first(mesh->points.begin(),
                                     mesh->points.begin() + sample.mesh.vertex_count());
      EXPECT_LT(max_distance(first, limit), 1e-14 * side);
    }
  });
}

TEST(DooSabinLimitMesh, IsASoundSurfaceOfTheSameKind) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto given = Topology::build(sample.mesh).value();
    const auto pieces = find_components(given).count;
    for (int levels = 1; levels <= 3; ++levels) {
      const Mesh mesh = limit_mesh(sample.mesh, rules, levels).value();
      const auto topology = Topology::build(mesh);
      ASSERT_TRUE(topology) << levels << ": " << describe(topology.error());
      EXPECT_EQ(boundary_loops(*topology).size(), boundary_loops(given).size());
      EXPECT_EQ(find_components(*topology).count, pieces);
      const auto euler = [](const Topology& t) {
        return static_cast<long>(t.vertex_count()) - static_cast<long>(t.edge_count()) +
               static_cast<long>(t.face_count());
      };
      EXPECT_EQ(euler(*topology), euler(given)) << levels;
    }
  });
}

TEST(DooSabinLimitMesh, HasNormalsOnTheSideOfItsFaces) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    if (!sample.has_normals) return;
    const int levels = affordable_levels(sample.mesh, 5);
    const Mesh mesh = limit_mesh(sample.mesh, rules, levels).value();
    const Channel& normals = mesh.channels.back();
    ASSERT_EQ(normals.name, "normal");
    // Where a random patch is bent most tightly, a face can still turn away from its corners.
    Index turned_away = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      Point sum = {};
      for (const Index v : mesh.face(f)) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += normals.values[std::size_t{3} * v + c];
      }
      if (!(dot(face_normal(mesh, f), sum) > 0)) ++turned_away;
    }
    EXPECT_LE(turned_away, mesh.face_count() / 1000);
  });
}

TEST(DooSabinLimitMesh, EnclosesItsVolumeOutward) {
  for (const Mesh& given : {cube(), tetrahedron(), prism(7)}) {
    const Mesh mesh = limit_mesh(given, {.scheme = Scheme::doo_sabin}, 3).value();
    for (Index f = 0; f < mesh.face_count(); ++f) {
      EXPECT_GT(dot(face_normal(mesh, f), mesh.points[mesh.face(f).front()]), 0);
    }
  }
}

TEST(DooSabinLimitMesh, LeavesHolesOut) {
  Mesh mesh = quad_grid(6, 6);
  const Mesh whole = limit_mesh(mesh, {.scheme = Scheme::doo_sabin}, 2).value();
  mesh.hole_faces = {6, 7, 8, 11, 12, 13, 16, 17, 18};
  const Mesh limit = limit_mesh(mesh, {.scheme = Scheme::doo_sabin}, 2).value();
  EXPECT_TRUE(limit.hole_faces.empty());
  EXPECT_LT(limit.face_count(), whole.face_count());
  EXPECT_GT(limit.face_count(), whole.face_count() * 3 / 4);
}

}  // namespace
}  // namespace surpass::test

// Limit normals of Doo-Sabin surfaces, against the faces of finely refined meshes.
#include "doo_sabin_samples.hpp"

namespace surpass::test {
namespace {

Point sum_of_normals(const doo_sabin::Level& level, const std::vector<Index>& faces) {
  Point sum = {};
  for (const Index f : faces) {
    const Point n = face_normal(level.mesh, f);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += n[c];
  }
  return unit(sum);
}

// Mean normal of the refined faces at a site.
Point normal_at(const doo_sabin::Level& level, const doo_sabin::Site& site) {
  const Topology& t = *level.topology;
  std::vector<Index> faces;
  switch (site.kind) {
    case doo_sabin::Site::Kind::face: faces.push_back(site.at); break;
    case doo_sabin::Site::Kind::edge:
      faces.push_back(t.face(site.at));
      if (t.opposite(site.at) != kNone) faces.push_back(t.face(t.opposite(site.at)));
      break;
    case doo_sabin::Site::Kind::vertex:
      t.for_each_outgoing(site.at, [&](Index h) { faces.push_back(t.face(h)); });
      break;
  }
  return sum_of_normals(level, faces);
}

double error_at(const Mesh& mesh, const Rules& rules, const std::vector<Point>& normals,
                int levels) {
  const auto level = refined_level(mesh, rules, levels);
  double most = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (normals[v] == Point{}) continue;  // isolated
    most = std::max(most, distance(normals[v], normal_at(level, level.sites[v])));
  }
  return most;
}

TEST(DooSabinNormals, AreThoseOfTheRefinedFaces) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    if (!sample.has_normals) return;
    const auto normals = limit_normals(sample.mesh, rules);
    ASSERT_TRUE(normals) << describe(normals.error());
    const int levels = affordable_levels(sample.mesh, 6);
    const double coarse = error_at(sample.mesh, rules, *normals, levels - 2);
    const double fine = error_at(sample.mesh, rules, *normals, levels);
    EXPECT_LT(fine, std::max(0.7 * coarse, 1e-9));
    EXPECT_LT(fine, 0.1);
  });
}

TEST(DooSabinNormals, PointOutwardOnConvexMeshes) {
  for (const Mesh& mesh : {cube(), tetrahedron(), prism(7), icosahedron()}) {
    for (const Rules& rules : doo_sabin_rules()) {
      const auto limit = limit_positions(mesh, rules).value();
      const auto normals = limit_normals(mesh, rules).value();
      for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_GT(dot(normals[v], limit[v]), 0.3);
    }
  }
}

TEST(DooSabinNormals, AreZeroAtIsolatedVertices) {
  Mesh mesh = cube();
  mesh.points.push_back({4, 4, 4});
  const auto normals = limit_normals(mesh, {.scheme = Scheme::doo_sabin}).value();
  EXPECT_EQ(normals.back(), (Point{0, 0, 0}));
}

}  // namespace
}  // namespace surpass::test

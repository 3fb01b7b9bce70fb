// Every committed mesh, and every mesh of a folder given from outside, that can be interpolated at
// all: to 1e-12 under each boundary rule, certified by us and, where it has the rule, by
// OpenSubdiv.
#include "support/meshes.hpp"

#include <surpass/oracle.hpp>

#include <gtest/gtest.h>

namespace surpass {
namespace {

// What becomes of a mesh: not every file holds one that has an interpolating Loop surface.
enum class Outcome { interpolated, refused_topology, refused_polygons };

void check_mesh(const std::string& path, Outcome& outcome) {
  SCOPED_TRACE(path);
  const auto loaded = read_mesh(path);
  ASSERT_TRUE(loaded) << describe(loaded.error());
  const Mesh& given = loaded->mesh;
  const auto topology = Topology::build(given);
  outcome = !topology ? Outcome::refused_topology : Outcome::refused_polygons;
  if (!topology || !all_triangles(given)) {
    const auto refused = interpolate(given);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code,
              topology ? ErrorCode::unsuitable_for_scheme : topology.error().code);
    return;
  }
  outcome = Outcome::interpolated;
  for (const Boundary boundary :
       {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe}) {
    const Rules rules{Scheme::loop, boundary};
    const auto result = interpolate(given, {.rules = rules, .tolerance = 1e-12});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_TRUE(result->report.converged) << name_of(boundary);
    const auto ours = certify(result->control, given.points, rules);
    ASSERT_TRUE(ours) << describe(ours.error());
    EXPECT_LE(ours->max, result->report.tolerance) << name_of(boundary);
    if (boundary == Boundary::hoppe) continue;
    const auto theirs = certify_with_opensubdiv(result->control, given.points, rules);
    ASSERT_TRUE(theirs) << describe(theirs.error());
    EXPECT_LE(theirs->max, 2 * result->report.tolerance) << name_of(boundary);
  }
}

// How many of these files were interpolated.
int check_meshes(const std::vector<std::string>& paths) {
  int interpolated = 0;
  for (const std::string& path : paths) {
    Outcome outcome = Outcome::refused_topology;
    check_mesh(path, outcome);
    if (outcome == Outcome::interpolated) ++interpolated;
  }
  return interpolated;
}

TEST(EveryMesh, CommittedOnesInterpolateUnderEveryBoundaryRule) {
  EXPECT_GE(check_meshes(test::committed_meshes()), 30);
}

TEST(EveryMesh, GivenOnesInterpolateUnderEveryBoundaryRule) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(check_meshes(test::real_meshes("tri")), 100);
}

}  // namespace
}  // namespace surpass

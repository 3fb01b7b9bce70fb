// Similarity and fair interpolation on every committed mesh and every one of a folder given from
// outside: to 1e-12 at no and at all iterations, under both boundary rules, judged by OpenSubdiv.
#include <surpass/oracle.hpp>
#include <surpass/similarity.hpp>

#include <gtest/gtest.h>

#include "support/polygons.hpp"

namespace surpass {
namespace {

void expect_interpolated(const Mesh& given, const std::vector<Point>& control,
                         const SimilarityInterpolator& solver, const Rules& rules) {
  Mesh mesh = solver.refined();
  mesh.points = control;
  const auto theirs = certify_with_opensubdiv(mesh, given.points, rules);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  EXPECT_LE(theirs->max, 1e-12);
}

// False where the mesh is refused, which must be because it is not manifold.
bool check_mesh(const Mesh& given) {
  for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
    for (const Similarity similarity :
         {Similarity::vectors, Similarity::directions, Similarity::fair}) {
      SCOPED_TRACE(std::string(name_of(boundary)) + ", " + name_of(similarity));
      SimilarityOptions options;
      options.rules.boundary = boundary;
      options.similarity = similarity;
      for (const unsigned iterations : {0U, 1000U}) {
        options.max_iterations = iterations;
        const auto solver = SimilarityInterpolator::create(given, options);
        if (!solver) {
          EXPECT_FALSE(Topology::build(given)) << describe(solver.error());
          return false;
        }
        const auto found = solver->solve(given.points);
        if (!found) {
          ADD_FAILURE() << describe(found.error());
          return false;
        }
        EXPECT_TRUE(found->report.solve.converged) << found->report.solve.final.max;
        EXPECT_EQ(found->report.solver_converged, iterations > 0);
        expect_interpolated(given, found->points, *solver, options.rules);
      }
    }
  }
  return true;
}

int check_meshes(const std::vector<std::string>& paths) {
  int interpolated = 0;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto loaded = read_mesh(path);
    EXPECT_TRUE(loaded) << describe(loaded.error());
    if (loaded && check_mesh(loaded->mesh)) ++interpolated;
  }
  return interpolated;
}

TEST(EveryMeshBySimilarity, CommittedOnesAreInterpolated) {
  EXPECT_EQ(check_meshes(test::committed_meshes()),
            static_cast<int>(test::committed_meshes().size()));
}

TEST(EveryMeshBySimilarity, GivenTrianglesAreInterpolated) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(check_meshes(test::real_meshes("tri")), 95);
}

TEST(EveryMeshBySimilarity, GivenPolygonsAreInterpolated) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(check_meshes(test::real_meshes("quad")), 60);
}

TEST(EveryMeshBySimilarity, SamplesOfEverySpecialCase) {
  for (const test::Sample& sample : test::polygon_samples()) {
    SCOPED_TRACE(sample.name);
    EXPECT_TRUE(check_mesh(sample.mesh));
  }
}

// Where plain interpolation has no answer.
TEST(EveryMeshBySimilarity, CubesPrismsAndDualsHaveSurfaces) {
  Mesh cube = test::cube();
  for (double& x : cube.points[6]) x *= 2;
  std::mt19937_64 random(4);
  for (const Mesh& given : {cube, test::jitter(test::prism(4), random, 0.1),
                            test::jitter(test::prism(8), random, 0.1)}) {
    const auto plain = interpolate(given, {.rules = {Scheme::catmull_clark}});
    ASSERT_FALSE(plain);
    EXPECT_EQ(plain.error().code, ErrorCode::singular);
    EXPECT_TRUE(check_mesh(given));
  }
  EXPECT_TRUE(check_mesh(test::jitter(test::dual(test::icosahedron()), random, 0.1)));
}

}  // namespace
}  // namespace surpass

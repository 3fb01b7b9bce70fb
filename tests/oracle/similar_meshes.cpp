#include "similar_meshes.hpp"

#include <surpass/oracle.hpp>

#include <gtest/gtest.h>

namespace surpass::test {
namespace {

void expect_interpolated(const Mesh& given, const std::vector<Point>& control,
                         const SimilarityInterpolator& solver, const Rules& rules) {
  Mesh mesh = solver.refined();
  mesh.points = control;
  const auto theirs = certify_with_opensubdiv(mesh, given.points, rules);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  EXPECT_LE(theirs->max, 1e-12);
}

}  // namespace

bool is_interpolated_by_similarity(const Mesh& given) {
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

int interpolated_by_similarity(const std::vector<std::string>& paths) {
  int interpolated = 0;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto loaded = read_mesh(path);
    EXPECT_TRUE(loaded) << describe(loaded.error());
    if (loaded && is_interpolated_by_similarity(loaded->mesh)) ++interpolated;
  }
  return interpolated;
}

}  // namespace surpass::test

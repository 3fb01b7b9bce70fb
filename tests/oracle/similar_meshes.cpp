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

namespace {

// False where the mesh is refused.
bool is_interpolated(const Mesh& given, const SimilarityOptions& options) {
  SCOPED_TRACE(std::string(name_of(options.rules.boundary)) + ", " + name_of(options.open) + ", " +
               name_of(options.similarity));
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
  EXPECT_EQ(found->report.solver_converged, options.max_iterations > 0);
  expect_interpolated(given, found->points, *solver, options.rules);
  return true;
}

}  // namespace

bool is_interpolated_by_similarity(const Mesh& given) {
  const auto topology = Topology::build(given);
  const bool open = !topology || topology->boundary_edge_count() > 0;
  SimilarityOptions options;
  std::vector<SimilarityOptions> kinds;  // all the same on closed meshes
  kinds.push_back(options);
  options.rules.boundary = Boundary::edge_only;
  if (open) kinds.push_back(options);
  options.open = OpenMeshes::dummy_ring;
  if (open) kinds.push_back(options);
  for (SimilarityOptions& kind : kinds) {
    for (const Similarity similarity :
         {Similarity::vectors, Similarity::directions, Similarity::fair}) {
      kind.similarity = similarity;
      if (!is_interpolated(given, kind)) return false;
    }
    kind.max_iterations = 0;  // the reference, whatever the form
    if (!is_interpolated(given, kind)) return false;
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

// Every committed mesh, and every mesh of a folder given from outside, under each scheme: to 1e-12
// under each boundary rule, certified by us and, where it has the rules, by OpenSubdiv, with the
// same bits for any number of threads; or refused for a reason that is checked.
#include "support/meshes.hpp"

#include <surpass/oracle.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "scheme/limit_operator.hpp"
#include "support/dense.hpp"

namespace surpass {
namespace {

// What became of the meshes of a folder under one scheme.
struct Tally {
  int interpolated = 0;
  int refused = 0;   ///< not manifold, or faces that the scheme does not take
  int singular = 0;  ///< some component has no interpolating surface
};

std::vector<Boundary> boundaries_of(Scheme scheme) {
  if (scheme == Scheme::loop)
    return {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe};
  return {Boundary::edge_only, Boundary::edge_and_corner};
}

void check_certificates(const Mesh& given, const Interpolated& found, const Rules& rules) {
  const auto ours = certify(found.control, given.points, rules);
  ASSERT_TRUE(ours) << describe(ours.error());
  EXPECT_LE(ours->max, found.report.tolerance);
  if (!opensubdiv_knows(rules)) return;
  const auto theirs = certify_with_opensubdiv(found.control, given.points, rules);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  EXPECT_LE(theirs->max, 2 * found.report.tolerance);
}

void check_threads(const Mesh& given, const Interpolated& found,
                   const InterpolateOptions& options) {
  for (const int threads : {1, 2, 3, 8}) {
    const auto again = interpolate(given, options, {.threads = threads});
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->control.points, found.control.points) << threads << " threads";
  }
}

// The refusal is right if no control mesh comes closer than the tolerance: shown by the best one
// in the least-squares sense, found by dense linear algebra on the named component.
void check_singular(const Mesh& given, const Rules& rules, const Error& error) {
  ASSERT_EQ(error.code, ErrorCode::singular) << describe(error);
  ASSERT_TRUE(error.place.vertex.has_value());
  const auto topology = Topology::build(given).value();
  const Components components = find_components(topology);
  const Index named = components.of_vertex[*error.place.vertex];
  const std::string sentence = error.message.substr(0, error.message.find(':'));
  EXPECT_NE(sentence.find(std::to_string(named)), std::string::npos) << error.message;
  std::vector<Index> members;
  for (Index v = 0; v < given.vertex_count(); ++v) {
    if (components.of_vertex[v] == named) members.push_back(v);
  }
  const auto op = limit_operator(given, topology, rules, {}).value();
  test::Dense matrix(members.size());
  std::vector<Point> points;
  const auto number = [&](Index v) {
    const auto at = std::lower_bound(members.begin(), members.end(), v) - members.begin();
    return static_cast<std::size_t>(at);
  };
  for (const Index v : members) {
    for (std::size_t k = 0; k < op.rows.row_columns(v).size(); ++k) {
      matrix(number(v), number(op.rows.row_columns(v)[k])) += op.rows.row_weights(v)[k];
    }
    points.push_back(given.points[v]);
  }
  const test::BestFit best = test::best_fit(matrix, points, 1e-9);
  EXPECT_LT(best.rank, members.size());
  EXPECT_GT(best.error, 1e-12 * bounding_box(given.points).side());
}

void check_mesh(const std::string& path, Scheme scheme, Tally& tally) {
  const auto loaded = read_mesh(path);
  ASSERT_TRUE(loaded) << describe(loaded.error());
  const Mesh& given = loaded->mesh;
  const auto topology = Topology::build(given);
  if (!topology || (face_size(scheme) == 3 && !all_triangles(given))) {
    const auto refused = interpolate(given, {.rules = {scheme}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code,
              topology ? ErrorCode::unsuitable_for_scheme : topology.error().code);
    ++tally.refused;
    return;
  }
  bool singular = false;
  for (const Boundary boundary : boundaries_of(scheme)) {
    const Rules rules{scheme, boundary};
    SCOPED_TRACE(name_of(boundary));
    const InterpolateOptions options{.rules = rules, .tolerance = 1e-12};
    const auto result = interpolate(given, options);
    if (!result && result.error().code == ErrorCode::unsuitable_for_scheme) {
      ++tally.refused;  // semi-sharp creases on Doo-Sabin surfaces
      return;
    }
    if (!result) {
      check_singular(given, rules, result.error());
      singular = true;
      continue;
    }
    EXPECT_TRUE(result->report.converged);
    check_certificates(given, *result, rules);
    if (boundary == Rules().boundary) check_threads(given, *result, options);
  }
  ++(singular ? tally.singular : tally.interpolated);
}

Tally check_meshes(const std::vector<std::string>& paths, Scheme scheme) {
  Tally tally;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path + ", " + name_of(scheme));
    check_mesh(path, scheme, tally);
  }
  return tally;
}

class EveryMesh : public testing::TestWithParam<Scheme> {};

TEST_P(EveryMesh, CommittedOnesInterpolateUnderEveryBoundaryRule) {
  EXPECT_GE(check_meshes(test::committed_meshes(), GetParam()).interpolated, 30);
}

TEST_P(EveryMesh, GivenTrianglesInterpolateUnderEveryBoundaryRule) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(check_meshes(test::real_meshes("tri"), GetParam()).interpolated, 95);
}

TEST_P(EveryMesh, GivenPolygonsInterpolateUnderEveryBoundaryRule) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  const Tally tally = check_meshes(test::real_meshes("quad"), GetParam());
  if (GetParam() == Scheme::loop) {
    EXPECT_GE(tally.refused, 60);
    return;
  }
  EXPECT_GE(tally.interpolated, 50)
      << tally.singular << " singular, " << tally.refused << " refused";
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryMesh, testing::ValuesIn(all_schemes()),
                         [](const auto& which) {
                           std::string name = name_of(which.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace surpass

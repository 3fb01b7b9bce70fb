// Limit masks against OpenSubdiv: every kind of vertex, on irregular random meshes.
#include <surpass/oracle.hpp>

#include <tuple>

#include <gtest/gtest.h>

#include "osd.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

void expect_same_limits(const Mesh& mesh, const Rules& rules, double tolerance) {
  const auto ours = limit_positions(mesh, rules);
  const auto theirs = opensubdiv_limit_positions(mesh, rules);
  ASSERT_TRUE(ours) << describe(ours.error());
  ASSERT_TRUE(theirs) << describe(theirs.error());
  EXPECT_LT(test::max_distance(*ours, *theirs), tolerance);
}

void expect_same_limits(const Mesh& mesh, Boundary boundary, double tolerance) {
  expect_same_limits(mesh, Rules{Scheme::loop, boundary}, tolerance);
}

class LimitAgainstOpenSubdiv : public testing::TestWithParam<std::tuple<Scheme, int, int>> {
 protected:
  void expect_same(double creases, bool semi_sharp, double tolerance) const {
    const auto [scheme, kind, seed] = GetParam();
    const Mesh mesh = test::random_mesh_for(scheme, {.seed = static_cast<std::uint64_t>(seed),
                                                     .kind = kind,
                                                     .creases = creases,
                                                     .semi_sharp = semi_sharp});
    expect_same_limits(mesh, Rules{scheme, Boundary::edge_only}, tolerance);
    expect_same_limits(mesh, Rules{scheme, Boundary::edge_and_corner}, tolerance);
  }
};

TEST_P(LimitAgainstOpenSubdiv, SmoothMeshes) { expect_same(0, false, 1e-14); }

TEST_P(LimitAgainstOpenSubdiv, SharpCreasesWithDarts) {
  for (const double share : {0.02, 0.1, 0.3}) expect_same(share, false, 1e-13);
}

TEST_P(LimitAgainstOpenSubdiv, SemiSharpCreases) {
  for (const double share : {0.02, 0.1, 0.3}) expect_same(share, true, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(RandomMeshes, LimitAgainstOpenSubdiv,
                         testing::Combine(testing::Values(Scheme::loop, Scheme::catmull_clark),
                                          testing::Range(0, 5), testing::Range(0, 4)));

// Refined once by us where OpenSubdiv's own mask would be wrong: at the doublets it is followed.
TEST(CatmullClarkAgainstOpenSubdiv, EveryKindOfVertex) {
  for (const test::Sample& sample : test::polygon_samples()) {
    SCOPED_TRACE(sample.name);
    for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
      expect_same_limits(sample.mesh, Rules{Scheme::catmull_clark, boundary}, 1e-13);
    }
  }
}

TEST(CatmullClarkAgainstOpenSubdiv, ValencesAndFaceSizesFrom3To100) {
  for (Index n = 3; n <= 100; ++n) {
    const Rules rules{Scheme::catmull_clark, Boundary::edge_only};
    expect_same_limits(test::bipyramid(n), rules, 1e-13);
    expect_same_limits(test::prism(n), rules, 1e-13);
  }
}

TEST(CatmullClarkAgainstOpenSubdiv, DartsOfEveryValence) {
  for (Index n = 3; n <= 24; ++n) {
    Mesh mesh = test::bipyramid(n);
    mesh.creases.push_back({{n, 1}, 10});
    expect_same_limits(mesh, Rules{Scheme::catmull_clark, Boundary::edge_only}, 1e-13);
  }
}

// Why the oracle does not use OpenSubdiv's limit mask at interior vertices of valence 2.
TEST(CatmullClarkAgainstOpenSubdiv, ItsMaskOfValenceTwoIsNotTheLimitOfItsPoints) {
  const Mesh mesh = test::pillow(4);
  const Rules rules{Scheme::catmull_clark, Boundary::edge_only};
  const Point ours = limit_positions(mesh, rules).value()[0];
  const auto distance = [&](int level) {
    const auto refined = test::osd_refine(mesh, rules, level);
    const Point& p = refined.points[refined.descendant[0]];
    return std::hypot(p[0] - ours[0], p[1] - ours[1], p[2] - ours[2]);
  };
  EXPECT_GT(distance(1), 1e-3);  // where its limit mask leaves the vertex
  EXPECT_LT(distance(8), 1e-4 * distance(1));
}

TEST(LimitAgainstOpenSubdiv, ValencesFrom3To100) {
  for (Index n = 3; n <= 100; ++n) {
    expect_same_limits(test::bipyramid(n), Boundary::edge_only, 1e-14);
  }
}

TEST(LimitAgainstOpenSubdiv, DartsOfEveryValence) {
  for (Index n = 3; n <= 24; ++n) {
    Mesh mesh = test::bipyramid(n);
    mesh.creases.push_back({{n, 1}, 10});
    expect_same_limits(mesh, Boundary::edge_only, 1e-13);
  }
}

// The reason for the detour in the oracle: OpenSubdiv's own limit mask at a dart moves with the
// level.
TEST(LimitAgainstOpenSubdiv, ItsDartMaskIsNotTheLimitOfItsPoints) {
  Mesh mesh = test::icosahedron();
  mesh.creases = {{{0, 11}, 10}, {{11, 5}, 10}};
  const Point ours = limit_positions(mesh, {}).value()[0];
  const auto distance = [&](int level) {
    const auto refined = test::osd_refine(mesh, {}, level);
    const Point& p = refined.points[refined.descendant[0]];
    return std::hypot(p[0] - ours[0], p[1] - ours[1], p[2] - ours[2]);
  };
  EXPECT_GT(distance(1), 1e-2);
  EXPECT_LT(distance(6), distance(3) / 3);
}

TEST(LimitAgainstOpenSubdiv, BowTiesAreSharp) {
  const Mesh open = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0.5}},
                                    {{0, 1, 2}, {0, 3, 4}});
  expect_same_limits(open, Boundary::edge_only, 1e-15);
  Mesh closed = test::octahedron();
  for (const Point& p : test::octahedron().points) {
    if (p != Point{1, 0, 0}) closed.points.push_back({2 - p[0], p[1], p[2]});
  }
  const Mesh first = test::octahedron();
  for (Index f = 0; f < first.face_count(); ++f) {
    std::vector<Index> face(first.face(f).rbegin(), first.face(f).rend());
    for (Index& v : face) v = v == 0 ? 0 : v + 5;
    closed.add_face(face);
  }
  const auto limits = limit_positions(closed, {});
  ASSERT_TRUE(limits);
  EXPECT_EQ((*limits)[0], closed.points[0]);
  expect_same_limits(closed, Boundary::edge_only, 1e-15);
}

TEST(LimitAgainstOpenSubdiv, RefusesRulesItDoesNotHave) {
  const auto result =
      opensubdiv_limit_positions(test::octahedron(), {Scheme::loop, Boundary::hoppe});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
  const auto dual = opensubdiv_limit_positions(test::octahedron(), {Scheme::doo_sabin});
  ASSERT_FALSE(dual);
  EXPECT_EQ(dual.error().code, ErrorCode::invalid_argument);
}

TEST(LimitAgainstOpenSubdiv, CertificateSeesAMovedVertex) {
  const Mesh given = test::random_mesh({.seed = 5, .kind = 2});
  Mesh control = interpolate(given, {.tolerance = 1e-13}).value().control;
  EXPECT_LT(certify_with_opensubdiv(control, given.points, {})->max, 2e-13);
  control.points[7][1] += 0.01;
  const auto moved = certify_with_opensubdiv(control, given.points, {});
  EXPECT_GT(moved->max, 1e-4);
  EXPECT_NEAR(moved->max, certify(control, given.points, {})->max, 1e-14);
}

}  // namespace
}  // namespace surpass

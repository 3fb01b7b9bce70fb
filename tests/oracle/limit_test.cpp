// Limit masks against OpenSubdiv: every kind of vertex, on irregular random meshes.
#include <surpass/oracle.hpp>

#include <gtest/gtest.h>

#include "osd.hpp"

namespace surpass {
namespace {

void expect_same_limits(const Mesh& mesh, Boundary boundary, double tolerance) {
  const Rules rules{Scheme::loop, boundary};
  const auto ours = limit_positions(mesh, rules);
  const auto theirs = opensubdiv_limit_positions(mesh, rules);
  ASSERT_TRUE(ours) << describe(ours.error());
  ASSERT_TRUE(theirs) << describe(theirs.error());
  EXPECT_LT(test::max_distance(*ours, *theirs), tolerance);
}

class LimitAgainstOpenSubdiv : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  [[nodiscard]] test::RandomShape shape() const {
    return {.seed = static_cast<std::uint64_t>(std::get<1>(GetParam())),
            .kind = std::get<0>(GetParam())};
  }
};

TEST_P(LimitAgainstOpenSubdiv, SmoothMeshes) {
  const Mesh mesh = test::random_mesh(shape());
  expect_same_limits(mesh, Boundary::edge_only, 1e-14);
  expect_same_limits(mesh, Boundary::edge_and_corner, 1e-14);
}

TEST_P(LimitAgainstOpenSubdiv, SharpCreasesWithDarts) {
  for (const double share : {0.02, 0.1, 0.3}) {
    test::RandomShape s = shape();
    s.creases = share;
    const Mesh mesh = test::random_mesh(s);
    expect_same_limits(mesh, Boundary::edge_only, 1e-13);
    expect_same_limits(mesh, Boundary::edge_and_corner, 1e-13);
  }
}

TEST_P(LimitAgainstOpenSubdiv, SemiSharpCreases) {
  for (const double share : {0.02, 0.1, 0.3}) {
    test::RandomShape s = shape();
    s.creases = share;
    s.semi_sharp = true;
    const Mesh mesh = test::random_mesh(s);
    expect_same_limits(mesh, Boundary::edge_only, 1e-13);
    expect_same_limits(mesh, Boundary::edge_and_corner, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(RandomMeshes, LimitAgainstOpenSubdiv,
                         testing::Combine(testing::Range(0, 5), testing::Range(0, 4)));

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
    const auto refined = test::osd_refine(mesh, Boundary::edge_and_corner, level);
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

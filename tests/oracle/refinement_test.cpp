// Refined points against OpenSubdiv, matched by position: the two number new vertices differently.
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "osd.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

// Pairs points by sorting a coarse key; exact enough as no two refined points come that close here.
void expect_same_points(std::vector<Point> a, std::vector<Point> b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  const auto less = [](const Point& p, const Point& q) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(p[k] - q[k]) > 1e-9) return p[k] < q[k];
    }
    return false;
  };
  std::sort(a.begin(), a.end(), less);
  std::sort(b.begin(), b.end(), less);
  EXPECT_LT(test::max_distance(a, b), tolerance);
}

class RefinementAgainstOpenSubdiv : public testing::TestWithParam<std::tuple<Scheme, int>> {};

TEST_P(RefinementAgainstOpenSubdiv, TwoLevelsWithAndWithoutCreases) {
  for (const double creases : {0.0, 0.15}) {
    for (const bool semi_sharp : {false, true}) {
      const auto [scheme, kind] = GetParam();
      const test::RandomShape shape{
          .seed = 11, .kind = kind, .creases = creases, .semi_sharp = semi_sharp};
      const Mesh mesh = test::random_mesh_for(scheme, shape);
      for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
        const Rules rules{scheme, boundary};
        const auto ours = refine(mesh, rules, 2);
        ASSERT_TRUE(ours) << describe(ours.error());
        const auto theirs = test::osd_refine(mesh, rules, 2);
        expect_same_points(ours->points, theirs.points, 1e-14);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
          const Point& p = ours->points[v];
          const Point& q = theirs.points[theirs.descendant[v]];
          EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-14);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomMeshes, RefinementAgainstOpenSubdiv,
                         testing::Combine(testing::Values(Scheme::loop, Scheme::catmull_clark),
                                          testing::Range(0, 5)));

}  // namespace
}  // namespace surpass

// The same requirement said in different words, and numbers that say nothing.
#include <surpass/similarity.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/polygons.hpp"
#include "support/requirements.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;

class RequirementWords : public testing::Test {
 protected:
  SimilaritySolution solve(const std::vector<Requirement>& all) const {
    auto found = solver_.solve_required(all, mesh_.points);
    EXPECT_TRUE(found) << describe(found.error());
    return found ? *found : SimilaritySolution{};
  }
  Error refusal(const std::vector<Requirement>& all) const {
    const auto found = solver_.solve_required(all, mesh_.points);
    EXPECT_FALSE(found);
    return found ? Error{} : found.error();
  }

  Mesh mesh_ = test::random_polygons({.seed = 2, .kind = 1});
  SimilarityInterpolator solver_ = SimilarityInterpolator::create(mesh_, {}).value();
  SurfacePlace place_ = {6, 0.4, 0.3, 0};
};

// Powers of two, so that nothing is rounded on the way.
TEST_F(RequirementWords, LengthsOfDirectionsHaveNoMeaning) {
  const Requirement plain = test::on_face(Kind::direction, place_, {1, 0.2, 0.1}, {0.5, -0.25});
  const auto expected = solve({plain});
  EXPECT_TRUE(expected.report.solve.converged);
  for (const int power : {-1000, -300, -40, 40, 300, 1000}) {
    Requirement other = plain;
    for (double& x : other.along) x = std::ldexp(x, power);
    for (double& x : other.value) x = std::ldexp(x, -power);
    EXPECT_EQ(solve({other}).points, expected.points) << power;
  }
}

TEST_F(RequirementWords, DerivativesGrowWithTheirDirection) {
  const Requirement plain = test::on_face(Kind::derivative, place_, {1, 0.2, 0.1}, {0.5, -0.25});
  const auto expected = solve({plain});
  for (const int power : {-500, -40, 40, 500}) {
    Requirement other = plain;
    for (double& x : other.along) x = std::ldexp(x, power);
    for (double& x : other.value) x = std::ldexp(x, power);
    const auto found = solve({other});
    EXPECT_EQ(found.points, expected.points) << power;
    EXPECT_LT(found.report.requirements[0].error, 1e-14);
  }
}

// Whatever kind it is; what has no meaning for it need not be the same.
TEST_F(RequirementWords, WhatIsSaidTwiceIsAskedOnce) {
  const std::vector once = {test::on_face(Kind::normal, place_, {0.1, 0.2, 1}),
                            test::on_face(Kind::derivative, {8, 0.5, 0.5, 0}, {0.3, 0.1, 0.2}),
                            test::at_vertex(Kind::remove, 3),
                            test::at_vertex(Kind::normal, 5, {1, 2, 2})};
  const auto expected = solve(once);
  std::vector<Requirement> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  twice[6].value = {7, 7, 7};
  twice[7].value = {0.5, 1, 1};
  twice[7].along = {3, 4};
  const auto found = solve(twice);
  EXPECT_EQ(found.points, expected.points);
  for (std::size_t i = 0; i < twice.size(); ++i) {
    EXPECT_EQ(found.report.requirements[i].redundant, i >= once.size()) << i;
    EXPECT_LT(found.report.requirements[i].error, 1e-14) << i;
  }
}

TEST_F(RequirementWords, ADirectionFollowsFromADerivativeInEitherOrder) {
  const auto derivative = test::on_face(Kind::derivative, place_, {0.4, 0.1, 0.2});
  const auto direction = test::on_face(Kind::direction, place_, {0.8, 0.2, 0.4});
  const auto first = solve({derivative, direction}).report.requirements;
  const auto last = solve({direction, derivative}).report.requirements;
  EXPECT_EQ(first[0].redundant, false);
  EXPECT_EQ(first[1].redundant, true);
  EXPECT_EQ(last[0].redundant, true);
  EXPECT_EQ(last[1].redundant, false);
}

TEST_F(RequirementWords, NumbersTooLargeToComputeWithAreNamed) {
  for (const double x : {1e200, 1e308}) {
    const Error error = refusal({test::at_vertex(Kind::normal, 5, {0, 0, 1}),
                                 test::on_face(Kind::position, place_, {x, 0, 0})});
    EXPECT_EQ(error.code, ErrorCode::not_finite);
    EXPECT_NE(error.message.find("requirement 1"), std::string::npos) << error.message;
  }
}

// The amount is one of box sides, so it does not depend on the mesh's size.
TEST_F(RequirementWords, MissesAreToldInBoxSides) {
  std::string expected;
  for (const double scale : {1.0, 1.3, 1.9}) {
    Mesh mesh = mesh_;
    for (Point& p : mesh.points) {
      for (double& x : p) x *= scale;
    }
    const auto found = interpolate_required(
        mesh, std::vector{test::on_face(Kind::position, place_, {scale, 0, 0}),
                          test::on_face(Kind::position, place_, {scale, 0.5 * scale, 0})});
    ASSERT_FALSE(found);
    const std::string amount =
        found.error().message.substr(found.error().message.find("together they miss by"));
    if (expected.empty()) expected = amount;
    EXPECT_EQ(amount, expected) << scale;
  }
  const double side = bounding_box(mesh_.points).side();
  EXPECT_NEAR(std::stod(expected.substr(std::string("together they miss by ").size())), 0.5 / side,
              1e-2 / side);
}

// Two directions along one line meet their equations, and leave a spike.
TEST_F(RequirementWords, SurfacesWithoutATangentPlaneAreNoted) {
  const Index v = mesh_.face(6)[0];
  const auto both = [&](const Point& other) {
    return solve(
        {test::towards(Kind::direction, v, mesh_.face(6)[1], {0, 0, 1}),
         test::towards(Kind::direction, v, mesh_.face(6)[mesh_.face(6).size() - 1], other)});
  };
  const auto spike = both({0, 0, 1});
  EXPECT_TRUE(spike.report.requirements[0].without_plane);
  EXPECT_TRUE(std::any_of(spike.report.solve.notes.begin(), spike.report.solve.notes.end(),
                          [](const std::string& note) {
                            return note.find("without a tangent plane") != std::string::npos;
                          }));
  EXPECT_FALSE(both({1, 0, 0}).report.requirements[0].without_plane);
}

TEST(NormalsEverywhere, GoByWhatIsSharpInTheEnd) {
  const Mesh plain = test::quad_grid(5, 5);
  const Rules rules{Scheme::catmull_clark};
  const std::vector<Point> up(plain.points.size(), Point{0, 0, 1});
  const auto count = [&](const Mesh& mesh) {
    return normals_everywhere(mesh, rules, up).value().size();
  };
  ASSERT_EQ(count(plain), plain.points.size());
  const auto topology = Topology::build(plain).value();
  // The boundary is sharp with or without a tag.
  Mesh tagged = plain;
  Index inside = kNone;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (topology.is_boundary_edge(e)) {
      tagged.creases.push_back({topology.edge_vertices(e), kInfinitelySharp});
    } else if (const auto [a, b] = topology.edge_vertices(e);
               !topology.is_boundary(a) && !topology.is_boundary(b)) {
      inside = e;
    }
  }
  EXPECT_EQ(count(tagged), plain.points.size());
  // A dart, told twice, and taken back.
  ASSERT_NE(inside, kNone);
  Mesh dart = plain;
  dart.creases.assign(2, {topology.edge_vertices(inside), kInfinitelySharp});
  EXPECT_EQ(count(dart), plain.points.size());
  // A crease through a vertex leaves its ends, which are darts.
  Mesh crease = plain;
  const auto [a, b] = topology.edge_vertices(inside);
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const auto [c, d] = topology.edge_vertices(e);
    if (c == a || d == a) crease.creases.push_back({{c, d}, kInfinitelySharp});
  }
  EXPECT_LT(count(crease), plain.points.size());
  const std::vector<Crease> tags = crease.creases;
  for (const Crease& tag : tags) crease.creases.push_back({tag.vertices, 0});
  EXPECT_EQ(count(crease), plain.points.size());
}

// A file whose normals all point inward, or whose faces are wound the other way.
TEST(NormalsEverywhere, RefuseTheBackOfMostFaces) {
  const Mesh mesh = test::icosahedron();
  const Rules rules{Scheme::catmull_clark};
  std::vector<Point> normals = mesh.points;
  EXPECT_EQ(normals_everywhere(mesh, rules, normals).value().size(), 12U);
  const auto turn = [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      for (double& c : normals[v]) c = -c;
    }
  };
  turn(0, 6);
  EXPECT_TRUE(normals_everywhere(mesh, rules, normals));
  turn(6, 7);
  const auto refused = normals_everywhere(mesh, rules, normals);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::mismatch);
  EXPECT_NE(refused.error().message.find("7 of 12 normals point to the back"), std::string::npos)
      << refused.error().message;
}

TEST(PrescribesAtBoundary, AVertexIsWhereItsFacesCornersAre) {
  const Mesh mesh = test::quad_grid(5, 5);
  const auto topology = Topology::build(mesh).value();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index k = 0; k < 4; ++k) {
      constexpr std::array<std::array<double, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      const Index v = mesh.face(f)[k];
      const std::vector said = {test::at_vertex(Kind::normal, v, {0, 0, 1})};
      const SurfacePlace here{f, kCorners[k][0], kCorners[k][1]};
      for (const SurfacePlace& place : {here, SurfacePlace{f, 0, 0, k}}) {
        const std::vector other = {test::on_face(Kind::normal, place, {0, 0, 1})};
        EXPECT_EQ(prescribes_at_boundary(mesh, other), prescribes_at_boundary(mesh, said));
        EXPECT_EQ(prescribes_at_boundary(mesh, said), topology.is_boundary(v));
      }
    }
  }
}

}  // namespace
}  // namespace surpass

// Requirements beside the given vertices: met exactly however far the solver comes, dropped where
// they repeat, refused where they contradict, and of all surfaces that meet them the best one.
#include "support/requirements.hpp"

#include <gtest/gtest.h>

#include "support/polygons.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;
constexpr std::array kForms = {Similarity::vectors, Similarity::directions, Similarity::fair};

SimilarityOptions options_with(Similarity form, unsigned iterations = 1000) {
  SimilarityOptions options;
  options.similarity = form;
  options.max_iterations = iterations;
  options.solver_tolerance = 1e-12;
  return options;
}

// Ten normals tilted, points on a regular and on irregular patches, a direction, a derivative.
std::vector<Requirement> mixed_requirements(const Mesh& mesh, const Rules& rules) {
  const auto normals = limit_normals(mesh, rules).value();
  std::vector<Requirement> all;
  for (Index v = 0; v < 10; ++v) {
    Point n = normals[v];
    n[v % 3] += 0.2;
    all.push_back(test::at_vertex(Kind::normal, v, n));
  }
  const LimitSurface surface = LimitSurface::create(mesh, rules).value();
  for (Index f = 12; f < mesh.face_count() && all.size() < 16; f += 3) {
    const Index corner = mesh.face(f).size() == 4 ? kNone : 1;
    const SurfacePlace place{f, 0.5, 0.25, corner};
    SurfaceSample s = surface.evaluate(place).value();
    s.position[f % 3] += 0.05;
    all.push_back(test::on_face(Kind::position, place, s.position));
    const SurfacePlace other{f, 0.7, 0.4, corner};
    s = surface.evaluate(other).value();
    Requirement direction = test::on_face(Kind::direction, other, s.du);
    direction.value[0] += 0.1;
    direction.along = {0.8, -0.3};
    all.push_back(direction);
    all.push_back(test::on_face(Kind::derivative, {f + 1, 0.2, 0.3, 0}, {0.3, -0.1, 0.2}));
  }
  return all;
}

Mesh bumpy() { return test::random_polygons({.seed = 2, .kind = 1}); }

TEST(Requirements, AreMetExactlyAfterNoneAndAllIterations) {
  for (const Mesh& mesh : {bumpy(), test::random_polygons({.seed = 3, .kind = 2, .size = 8})}) {
    for (const Similarity form : kForms) {
      for (const unsigned iterations : {0U, 1U, 1000U}) {
        const auto options = options_with(form, iterations);
        const auto all = mixed_requirements(mesh, options.rules);
        ASSERT_GT(all.size(), 14U);
        const auto solver = SimilarityInterpolator::create(mesh, options).value();
        const auto found = solver.solve_required(all, mesh.points);
        ASSERT_TRUE(found) << describe(found.error());
        for (std::size_t i = 0; i < all.size(); ++i) {
          EXPECT_LT(found->report.requirements[i].error, 1e-14) << describe(all[i]);
          EXPECT_FALSE(found->report.requirements[i].redundant);
        }
        EXPECT_LT(found->report.solve.final.max, 1e-14);
        const auto limits = solver.limit_positions(found->points).value();
        EXPECT_LT(test::max_distance(limits, mesh.points), 1e-13);
      }
    }
  }
}

// The energy of the solution does not fall along any change that keeps all equations; so it is the
// constrained minimum. The change: the difference to another solution, from another start.
TEST(Requirements, TheConstrainedMinimumDoesNotDependOnTheStart) {
  const Mesh mesh = bumpy();
  const SimilarityOptions options = options_with(Similarity::fair);
  const auto all = mixed_requirements(mesh, options.rules);
  const auto solver = SimilarityInterpolator::create(mesh, options).value();
  const auto one = solver.solve_required(all, mesh.points).value();
  std::mt19937_64 random(5);
  Mesh start = solver.refined();
  start.points = one.points;
  start = test::jitter(start, random, 0.5);
  const auto other = solver.solve_required(all, mesh.points, start.points).value();
  EXPECT_LT(one.report.residual, 1e-11);
  EXPECT_LT(test::max_distance(one.points, other.points), 1e-8);
}

TEST(Requirements, WhatTheSurfaceDoesAnywayChangesNothing) {
  const Mesh mesh = bumpy();
  for (const Similarity form : kForms) {
    const SimilarityOptions options = options_with(form);
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    const auto plain = solver.solve(mesh.points).value();
    Mesh control = solver.refined();
    control.points = plain.points;
    const LimitSurface surface = LimitSurface::create(control, options.rules).value();
    std::vector<Requirement> all;
    for (Index f = 0; f < mesh.face_count(); f += 4) {
      // Quarter 1 of face f of the given mesh is a face of the control mesh.
      const auto s = surface.evaluate({mesh.face_offsets[f] + 1, 0.5, 0.25}).value();
      all.push_back(test::on_face(Kind::position, {f, 0.5, 0.25, 1}, s.position));
      all.push_back(test::on_face(Kind::normal, {f, 0.5, 0.25, 1}, s.normal));
    }
    const auto same = solver.solve_required(all, mesh.points).value();
    EXPECT_LT(test::max_distance(plain.points, same.points), 1e-8) << name_of(form);
    for (const auto& outcome : same.report.requirements) EXPECT_FALSE(outcome.flipped);
  }
}

TEST(Requirements, ParametersOfQuadsAreThoseOfTheGivenMesh) {
  const Mesh mesh = test::quad_grid(5, 5);
  const SimilarityOptions options = options_with(Similarity::vectors);
  // The same derivative on a quad and on its quarter 2, which is turned by two right angles and
  // half as wide.
  Requirement whole = test::on_face(Kind::derivative, {5, 0.75, 0.875}, {0.9, 0.2, 0.3});
  Requirement quarter = test::on_face(Kind::derivative, {5, 0.5, 0.25, 2}, {-0.45, -0.1, -0.15});
  const auto a = interpolate_required(mesh, std::vector{whole}, options).value();
  const auto b = interpolate_required(mesh, std::vector{quarter}, options).value();
  EXPECT_LT(test::max_distance(a.control.points, b.control.points), 1e-12);
  const auto both = interpolate_required(mesh, std::vector{whole, quarter}, options);
  ASSERT_TRUE(both) << describe(both.error());
  EXPECT_FALSE(both->report.requirements[0].redundant);
  EXPECT_TRUE(both->report.requirements[1].redundant);
}

TEST(Requirements, RepeatedOnesAreDroppedAndReported) {
  const Mesh mesh = bumpy();
  const SimilarityOptions options = options_with(Similarity::vectors);
  std::vector<Requirement> all = mixed_requirements(mesh, options.rules);
  const auto before = interpolate_required(mesh, all, options).value();
  const std::size_t count = all.size();
  all.insert(all.end(), all.begin(), all.begin() + 12);
  all.push_back(test::on_face(Kind::position, {3, 0, 0, 0}, mesh.points[mesh.face(3)[0]]));
  const auto after = interpolate_required(mesh, all, options);
  ASSERT_TRUE(after) << describe(after.error());
  EXPECT_LT(test::max_distance(before.control.points, after->control.points), 1e-10);
  const auto dropped =
      std::count_if(after->report.requirements.begin(), after->report.requirements.end(),
                    [](const RequirementOutcome& o) { return o.redundant; });
  EXPECT_EQ(dropped, 13);
  for (std::size_t i = 0; i < count; ++i) EXPECT_FALSE(after->report.requirements[i].redundant);
  EXPECT_EQ(all.size(), count + 13);
  for (const auto& outcome : after->report.requirements) EXPECT_LT(outcome.error, 1e-13);
}

void expect_contradiction(const Mesh& mesh, const std::vector<Requirement>& all,
                          const std::vector<std::string>& named) {
  for (const Similarity form : kForms) {
    const auto result = interpolate_required(mesh, all, options_with(form));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::contradictory);
    for (const std::string& name : named) {
      EXPECT_NE(result.error().message.find(name), std::string::npos) << describe(result.error());
    }
  }
}

TEST(Requirements, ContradictionsAreRefusedAndNamed) {
  const Mesh mesh = bumpy();
  const SurfacePlace place{6, 0.5, 0.25, 0};
  const Requirement first = test::on_face(Kind::position, place, {1, 2, 3});
  expect_contradiction(mesh,
                       {test::at_vertex(Kind::normal, 9, {0, 0, 1}), first,
                        test::on_face(Kind::position, place, {1, 2, 3.001})},
                       {"1 (position on face 6", "2 (position on face 6"});
  expect_contradiction(mesh,
                       {test::on_face(Kind::derivative, place, {1, 0, 0}),
                        test::on_face(Kind::normal, place, {1, 0.2, 0})},
                       {"0 (derivative", "1 (normal"});
  Point beside = mesh.points[mesh.face(3)[0]];
  beside[1] += 0.1;
  expect_contradiction(mesh, {test::on_face(Kind::position, {3, 0, 0, 0}, beside)},
                       {"0 (position on face 3", "given vertices"});
  expect_contradiction(
      mesh, {test::at_vertex(Kind::position, 4, {0, 0, 0}), test::at_vertex(Kind::remove, 4)},
      {"0 (position at vertex 4)", "1 (remove at vertex 4)"});
}

// Tangents of no length would meet the equations of all of these.
TEST(Requirements, TangentsThatExcludeEachOtherAreRefused) {
  const Mesh mesh = bumpy();
  const Index v = mesh.face(2)[0];
  const auto towards = [&](std::size_t k, Kind kind, Point value) {
    Requirement r = test::at_vertex(kind, v, value);
    r.towards = mesh.face(2)[k];
    return r;
  };
  const Requirement up = test::at_vertex(Kind::normal, v, {0, 0, 1});
  const std::vector<std::vector<Requirement>> pairs = {
      {up, test::at_vertex(Kind::normal, v, {0, 1, 1})},
      {up, test::at_vertex(Kind::normal, v, {0, 0, -1})},
      {up, test::on_face(Kind::normal, {2, 0, 0, 0}, {0, 1e-6, 1})},
      {up, towards(1, Kind::direction, {1, 0, 0.1})},
      {up, towards(1, Kind::derivative, {0, 0, 0})},
      {towards(1, Kind::direction, {1, 0, 0}), towards(1, Kind::direction, {1, 0.1, 0})},
      {towards(1, Kind::direction, {1, 0, 0}), towards(1, Kind::direction, {-1, 0, 0})},
      {towards(1, Kind::derivative, {1, 0, 0}), towards(1, Kind::direction, {-1, 0, 0})}};
  for (const auto& pair : pairs) {
    SCOPED_TRACE(describe(pair[1]));
    expect_contradiction(mesh, pair, {"0 (" + describe(pair[0]), "1 (" + describe(pair[1])});
  }
  // Three directions in one plane that no derivatives of it can have.
  const auto on_place = [&](std::array<double, 2> along, Point value) {
    Requirement r = test::on_face(Kind::direction, {6, 0.5, 0.25, 0}, value);
    r.along = along;
    return r;
  };
  expect_contradiction(
      mesh, {on_place({1, 0}, {1, 0, 0}), on_place({0, 1}, {0, 1, 0}), on_place({1, 1}, {1, 1, 1})},
      {"0 (direction", "1 (direction", "2 (direction"});
}

TEST(Requirements, TangentsThatAgreeAreMet) {
  const Mesh mesh = bumpy();
  const Index v = mesh.face(2)[0];
  const auto towards = [&](std::size_t k, Point value) {
    Requirement r = test::at_vertex(Kind::direction, v, value);
    r.towards = mesh.face(2)[k];
    return r;
  };
  const SimilarityOptions options = options_with(Similarity::vectors);
  const std::vector<Requirement> all = {test::at_vertex(Kind::normal, v, {0, 0, 1}),
                                        test::on_face(Kind::normal, {2, 0, 0, 0}, {0, 0, 3}),
                                        towards(1, {1, 0.2, 0}), towards(1, {2, 0.4, 0})};
  const auto found = interpolate_required(mesh, all, options);
  ASSERT_TRUE(found) << describe(found.error());
  const std::vector<bool> redundant = {false, true, false, true};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(found->report.requirements[i].redundant, redundant[i]) << i;
    EXPECT_LT(found->report.requirements[i].error, 1e-14) << i;
  }
}

// Where a surface is not evaluated anywhere, its vertices can still be moved and let go.
TEST(Requirements, VerticesAreMovedOnSurfacesOfEveryScheme) {
  for (const Scheme scheme : {Scheme::loop, Scheme::doo_sabin}) {
    const Mesh mesh = test::octahedron();
    SimilarityOptions options = options_with(Similarity::vectors);
    options.rules = {scheme};
    const std::vector<Requirement> all = {test::at_vertex(Kind::position, 2, {0.1, 0.2, 2}),
                                          test::at_vertex(Kind::position, 2, {0.1, 0.2, 2}),
                                          test::at_vertex(Kind::remove, 3)};
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    const auto found = solver.solve_required(all, mesh.points).value();
    std::vector<Point> expected = mesh.points;
    expected[2] = {0.1, 0.2, 2};
    const auto limits = solver.limit_positions(found.points).value();
    expected[3] = limits[3];
    EXPECT_LT(test::max_distance(limits, expected), 1e-14);
    EXPECT_TRUE(found.report.requirements[1].redundant);
    const auto refused = solver.solve_required(
        std::vector{test::at_vertex(Kind::normal, 1, {0, 0, 1})}, mesh.points);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalid_argument);
  }
}

// Nothing can be nearer than the digits of its numbers.
TEST(Requirements, AreMetFarFromTheOrigin) {
  Mesh mesh = bumpy();
  for (Point& p : mesh.points) p[0] += 1e8;
  Point wanted = mesh.points[mesh.face(6)[0]];
  wanted[2] += 0.1;
  const auto found = interpolate_required(
      mesh, std::vector{test::on_face(Kind::position, {6, 0.5, 0.25, 0}, wanted)},
      options_with(Similarity::vectors));
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->report.solve.converged);
}

TEST(Requirements, VerticesAreRemovedAndReplaced) {
  const Mesh mesh = bumpy();
  for (const Similarity form : kForms) {
    const SimilarityOptions options = options_with(form);
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    Point moved = mesh.points[5];
    moved[0] += 0.2;
    const std::vector all = {test::at_vertex(Kind::remove, 3),
                             test::at_vertex(Kind::position, 5, moved)};
    const auto found = solver.solve_required(all, mesh.points).value();
    const auto limits = solver.limit_positions(found.points).value();
    std::vector<Point> expected = mesh.points;
    expected[5] = moved;
    EXPECT_GT(std::hypot(limits[3][0] - expected[3][0], limits[3][1] - expected[3][1],
                         limits[3][2] - expected[3][2]),
              1e-4);
    expected[3] = limits[3];
    EXPECT_LT(test::max_distance(limits, expected), 1e-13);
    EXPECT_LT(found.report.solve.final.max, 1e-13);
    EXPECT_LT(test::max_distance(found.targets, expected), 1e-15);
  }
}

// A surface that was required to pass through where it goes without a vertex keeps going there.
TEST(Requirements, RemovingAVertexFindsTheBestPlaceForIt) {
  const Mesh mesh = bumpy();
  const SimilarityOptions options = options_with(Similarity::fair);
  const auto solver = SimilarityInterpolator::create(mesh, options).value();
  const auto free =
      solver.solve_required(std::vector{test::at_vertex(Kind::remove, 3)}, mesh.points);
  ASSERT_TRUE(free);
  const auto fixed = solver.solve_like(mesh.points, free->targets).value();
  EXPECT_LT(test::max_distance(free->points, fixed.points), 1e-8);
}

TEST(Requirements, DerivativesAtVerticesGoAlongTheirEdges) {
  const Mesh mesh = bumpy();
  const SimilarityOptions options = options_with(Similarity::vectors);
  const Index v = mesh.face(2)[0];
  Requirement r = test::at_vertex(Kind::derivative, v, {0.2, 0.1, -0.3});
  r.towards = mesh.face(2)[1];
  const auto found = interpolate_required(mesh, std::vector{r}, options).value();
  const LimitSurface surface = LimitSurface::create(found.control, options.rules).value();
  const auto at = surface.evaluate({mesh.face_offsets[2], 0, 0}).value();
  EXPECT_LT(std::hypot(at.du[0] - 0.2, at.du[1] - 0.1, at.du[2] + 0.3), 1e-14);
}

TEST(Requirements, SameBitsForAnyNumberOfThreads) {
  const Mesh mesh = refine(bumpy(), {Scheme::catmull_clark}, 1).value();
  for (const Similarity form : kForms) {
    SimilarityOptions options = options_with(form);
    options.solver_tolerance = 1e-4;
    const auto all =
        normals_everywhere(mesh, options.rules, limit_normals(mesh, options.rules).value()).value();
    const auto one = interpolate_required(mesh, all, options, {.threads = 1}).value();
    for (const int threads : {2, 8}) {
      const auto many = interpolate_required(mesh, all, options, {.threads = threads}).value();
      EXPECT_EQ(one.control.points, many.control.points);
    }
  }
}

TEST(Requirements, ImpossibleOnesAreRefused) {
  const Mesh mesh = test::cube();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Requirement away = test::at_vertex(Kind::direction, 0, {1, 0, 0});
  away.towards = 7;  // across the cube
  Requirement nowhere = test::on_face(Kind::direction, {0, 0.5, 0.5}, {1, 0, 0});
  nowhere.along = {0, 0};
  for (const Requirement& r :
       {test::at_vertex(Kind::normal, 8, {1, 0, 0}), test::at_vertex(Kind::normal, 0, {0, 0, 0}),
        test::at_vertex(Kind::position, 0, {nan, 0, 0}),
        test::at_vertex(Kind::direction, 0, {1, 0, 0}),
        test::on_face(Kind::position, {6, 0, 0}, {}), test::on_face(Kind::position, {0, 2, 0}, {}),
        test::on_face(Kind::position, {0, 0, 0, 4}, {}), test::on_face(Kind::remove, {0, 0, 0}, {}),
        away, nowhere}) {
    const auto result = interpolate_required(mesh, std::vector{r}, {});
    ASSERT_FALSE(result) << describe(r);
    EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
    EXPECT_NE(result.error().message.find("requirement 0"), std::string::npos);
  }
}

// Gauss and Seidel's sweeps end where conjugate gradients do, and leave the requirements nowhere.
TEST(Requirements, GaussAndSeidelKeepThemAndFindTheSame) {
  const Mesh mesh = bumpy();
  for (const Similarity form : kForms) {
    SCOPED_TRACE(name_of(form));
    SimilarityOptions options = options_with(form, 20000);
    options.solver_tolerance = 1e-11;
    const auto all = mixed_requirements(mesh, options.rules);
    const auto expected = interpolate_required(mesh, all, options).value();
    options.solver = SimilaritySolver::gauss_seidel;
    for (const unsigned iterations : {0U, 1U, 3U, 20000U}) {
      options.max_iterations = iterations;
      const auto found = interpolate_required(mesh, all, options).value();
      for (const auto& outcome : found.report.requirements) EXPECT_LT(outcome.error, 1e-13);
      EXPECT_LT(found.report.solve.final.max, 1e-13);
      if (iterations < 10) continue;
      EXPECT_LT(found.report.residual, 1e-11);
      EXPECT_LT(test::max_distance(found.control.points, expected.control.points), 1e-7);
    }
  }
}

// Two points of the surface so near each other that the second equation is the first one but for a
// millionth and less: together they prescribe a derivative, and both are met.
TEST(Requirements, NearlyDependentOnesAreMet) {
  const Mesh mesh = bumpy();
  for (const double apart : {1e-6, 1e-7, 1e-8}) {
    SCOPED_TRACE(apart);
    const SimilarityOptions options = options_with(Similarity::vectors);
    const auto start = interpolate_similar(mesh, options).value().control;
    const LimitSurface surface = LimitSurface::create(start, options.rules).value();
    // A quarter of face 6 of the given mesh, whose parameters run half as fast.
    const auto s = surface.evaluate({mesh.face_offsets[6], 0.5, 0.25}).value();
    const SurfacePlace here{6, 0.5, 0.25, 0};
    const SurfacePlace there{6, 0.5 + apart, 0.25, 0};
    Point wanted = s.position;
    Point beside = s.position;
    for (std::size_t c = 0; c < 3; ++c) beside[c] += apart * (s.du[c] + (c == 2 ? 0.2 : 0.1));
    std::vector<Requirement> all = {
        test::on_face(Kind::position, here, wanted), test::on_face(Kind::position, there, beside),
        test::on_face(Kind::position, there, beside), test::at_vertex(Kind::normal, 9, {0, 0, 1})};
    const auto found = interpolate_required(mesh, all, options);
    ASSERT_TRUE(found) << describe(found.error());
    for (const auto& outcome : found->report.requirements) EXPECT_LT(outcome.error, 1e-14);
    EXPECT_FALSE(found->report.requirements[0].redundant);
    EXPECT_FALSE(found->report.requirements[1].redundant);
    EXPECT_TRUE(found->report.requirements[2].redundant);
    const auto after = LimitSurface::create(found->control, options.rules)
                           .value()
                           .evaluate({mesh.face_offsets[6], 0.5, 0.25})
                           .value();
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(after.du[c], s.du[c] + (c == 2 ? 0.2 : 0.1), 1e-4) << c;
    }
    all[2].value[1] += 1e-3;
    const auto refused = interpolate_required(mesh, all, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::contradictory);
    EXPECT_NE(refused.error().message.find("1 (position on face 6"), std::string::npos)
        << describe(refused.error());
  }
}

}  // namespace
}  // namespace surpass

// Interpolation against dense linear algebra, naive code, and its own promises.
#include <random>
#include <span>
#include <sstream>

#include <gtest/gtest.h>

#include "generators.hpp"
#include "support/dense.hpp"
#include "support/meshes.hpp"

namespace surpass {
namespace {

TEST(Interpolation, APreparedTopologyEvaluatesLimitsToo) {
  std::mt19937_64 random(5);
  const Mesh mesh = test::random_mesh({.seed = 5, .kind = 3, .size = 6, .creases = 0.1});
  const auto solver = Interpolator::create(mesh);
  ASSERT_TRUE(solver) << describe(solver.error());
  const Mesh moved = test::jitter(mesh, random, 0.1);
  const auto limits = solver->limit_positions(moved.points);
  ASSERT_TRUE(limits);
  EXPECT_EQ(*limits, *limit_positions(moved, {}));
  const std::span<const Point> too_few = std::span(moved.points).first(3);
  ASSERT_FALSE(solver->limit_positions(too_few));
  EXPECT_EQ(solver->limit_positions(too_few).error().code, ErrorCode::mismatch);
}

TEST(Interpolation, PassesThroughEveryPointWithEverySolver) {
  test::check("interpolation", 40, [] {
    const auto [mesh, rules] = test::any_case(true);
    const Solver solver =
        rules.scheme == Scheme::catmull_clark  // whose eigenvalues may come near zero
            ? *rc::gen::element(Solver::automatic, Solver::gauss_seidel, Solver::bicgstab)
            : *rc::gen::element(Solver::automatic, Solver::chebyshev, Solver::richardson,
                                Solver::gauss_seidel, Solver::bicgstab);
    const auto result = interpolate(mesh, {.rules = rules, .solver = solver, .tolerance = 1e-13});
    RC_ASSERT(result.has_value());
    RC_ASSERT(result->report.converged);
    const auto certificate = certify(result->control, mesh.points, rules);
    RC_ASSERT(certificate->max < 2e-13);
    RC_ASSERT(std::abs(certificate->max - result->report.final.max) < 1e-15);
  });
}

TEST(Interpolation, EqualsADenseSolve) {
  test::check("dense solve", 12, [] {
    const auto [mesh, rules] = test::any_case(true);
    const test::Dense matrix = test::dense_operator(mesh, rules);
    const std::vector<Point> solution = test::solve(matrix, mesh.points);
    const auto result = interpolate(mesh, {.rules = rules, .tolerance = 1e-14});
    RC_ASSERT(result.has_value());
    double lowest = 1;
    for (const auto& value : test::eigenvalues(matrix)) lowest = std::min(lowest, std::abs(value));
    RC_ASSERT(test::max_distance(result->control.points, solution) < 1e-12 / lowest);
  });
}

TEST(Interpolation, SolversForSymmetricOperatorsAgreeWhereTheyApply) {
  test::check("conjugate gradients, MINRES", 20, [] {
    const auto [mesh, rules] = test::any_case(false);
    const auto a = interpolate(mesh, {.rules = rules, .tolerance = 1e-14});
    const auto b = interpolate(
        mesh, {.rules = rules, .solver = Solver::conjugate_gradient, .tolerance = 1e-14});
    RC_ASSERT(a.has_value());
    RC_ASSERT(b.has_value());
    RC_ASSERT(test::max_distance(a->control.points, b->control.points) < 1e-10);
    const auto c =
        interpolate(mesh, {.rules = rules, .solver = Solver::minimal_residual, .tolerance = 1e-14});
    RC_ASSERT(c.has_value());
    RC_ASSERT(test::max_distance(a->control.points, c->control.points) < 1e-10);
  });
}

TEST(Interpolation, ConjugateGradientsRefuseDartsByName) {
  Mesh mesh = test::icosahedron();
  mesh.creases = {{{0, 11}, 10}};
  const auto result = Interpolator::create(mesh, {.solver = Solver::conjugate_gradient});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::unsuitable_for_scheme);
  EXPECT_EQ(result.error().place.vertex, 0U);
}

// Equations (1) and (2) of the paper, in the plainest code there is, on a closed mesh.
TEST(Interpolation, RichardsonIsThePapersIteration) {
  const Mesh given = test::random_mesh({.seed = 9, .kind = 1});
  const Topology topology = Topology::build(given).value();
  std::vector<Point> x = given.points;
  const double side = bounding_box(given.points).side();
  std::vector<double> errors;
  for (int k = 0; k < 12; ++k) {
    std::vector<Point> next = x;
    double largest = 0;
    for (Index v = 0; v < given.vertex_count(); ++v) {
      const double n = topology.valence(v);
      const double c = 3.0 / 8 + std::cos(2 * M_PI / n) / 4;
      const double beta = 3 / (11 - 8 * (3.0 / 8 + c * c));
      Point ring = {};
      topology.for_each_spoke(v, [&](Index w, Index) {
        for (std::size_t i = 0; i < 3; ++i) ring[i] += x[w][i] / n;
      });
      double squared = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = given.points[v][i] - (beta * x[v][i] + (1 - beta) * ring[i]);
        next[v][i] += d;
        squared += d * d;
      }
      largest = std::max(largest, std::sqrt(squared));
    }
    errors.push_back(largest / side);
    x = next;
  }
  const auto result =
      interpolate(given, {.solver = Solver::richardson, .tolerance = 1e-15, .max_iterations = 12});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->report.converged);
  ASSERT_EQ(result->report.history.size(), 12U);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(result->report.history[k].max, errors[k], 1e-15);
  }
}

TEST(Interpolation, GoingDirectlyToTheLastIterationIsEnough) {
  test::check("a-priori bound", 15, [] {
    const auto [mesh, rules] =  // no bound is proven for Catmull-Clark at valence 3
        test::any_case(false, *rc::gen::element(Scheme::loop, Scheme::doo_sabin));
    const Solver solver = *rc::gen::element(Solver::chebyshev, Solver::richardson);
    const double tolerance = *rc::gen::element(1e-3, 1e-6, 1e-9);
    const InterpolateOptions options{
        .rules = rules, .solver = solver, .tolerance = tolerance, .direct = true};
    const auto result = interpolate(mesh, options);
    RC_ASSERT(result.has_value());
    RC_ASSERT(result->report.converged);
    const auto predicted = Interpolator::create(mesh, options)->predict(mesh.points);
    RC_ASSERT(result->report.boundary_iterations == predicted->boundary_sweeps);
    // Testing after every iteration needs no more.
    const auto tested =
        interpolate(mesh, {.rules = rules, .solver = solver, .tolerance = tolerance});
    RC_ASSERT(tested->report.iterations <= predicted->sweeps + 1);
  });
}

TEST(Interpolation, NoBoundIsClaimedForDarts) {
  Mesh mesh = test::icosahedron();
  mesh.creases = {{{0, 11}, 10}};
  const auto solver = Interpolator::create(mesh);
  ASSERT_TRUE(solver);
  EXPECT_FALSE(solver->predict(mesh.points));
  EXPECT_FALSE(Interpolator::create(mesh, {.direct = true}));
}

TEST(Interpolation, LeavesUnlistedVerticesAlone) {
  test::check("only", 15, [] {
    const auto [mesh, rules] = test::any_case(true);
    std::vector<Index> only;
    for (Index v = 0; v < mesh.vertex_count(); v += 3) only.push_back(v);
    const auto result = interpolate(mesh, {.rules = rules, .tolerance = 1e-13, .only = only});
    RC_ASSERT(result.has_value());
    RC_ASSERT(result->report.converged);
    const auto limit = limit_positions(result->control, rules).value();
    const double side = bounding_box(mesh.points).side();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (v % 3 == 0) {
        const Point& p = limit[v];
        const Point& q = mesh.points[v];
        RC_ASSERT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 2e-13 * side);
      } else {
        RC_ASSERT(result->control.points[v] == mesh.points[v]);
      }
    }
  });
}

// A channel that holds a linear function of the positions must come out as that of the control
// points.
TEST(Interpolation, CarriesChannelsAlong) {
  Mesh mesh = test::random_mesh({.seed = 4, .kind = 3, .creases = 0.05});
  Channel channel{"heat", {"a", "b"}, {}};
  for (const Point& p : mesh.points) {
    channel.values.push_back(2 * p[0] - p[1] + 0.5);
    channel.values.push_back(p[2] + 3 * p[1] - 1);
  }
  mesh.channels.push_back(channel);
  const Mesh control = interpolate(mesh, {.tolerance = 1e-14}).value().control;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Point& p = control.points[v];
    EXPECT_NEAR(control.channels[0].values[2 * v], 2 * p[0] - p[1] + 0.5, 1e-11);
    EXPECT_NEAR(control.channels[0].values[2 * v + 1], p[2] + 3 * p[1] - 1, 1e-11);
  }
}

TEST(Interpolation, OneSetUpServesManyPointSets) {
  const Mesh mesh = test::random_mesh({.seed = 8, .kind = 4});
  const auto solver = Interpolator::create(mesh, {.tolerance = 1e-12});
  ASSERT_TRUE(solver);
  std::mt19937_64 random(1);
  for (int frame = 0; frame < 3; ++frame) {
    const Mesh moved = test::jitter(mesh, random, 0.1);
    const auto many = solver->solve(moved.points);
    const auto once = interpolate(moved, {.tolerance = 1e-12});
    ASSERT_TRUE(many && once);
    EXPECT_EQ(many->points, once->control.points);
  }
}

// With the interior rule on an open mesh the operator can have negative eigenvalues: two triangles
// have -0.019. No iteration of ours converges there; the factorisation does.
TEST(Interpolation, InteriorRuleOnOpenMeshesIsSolvedEvenWhereItIsIndefinite) {
  const Mesh pair =
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Rules rules{Scheme::loop, Boundary::interior};
  double lowest = 1;
  for (const auto& value : test::eigenvalues(test::dense_operator(pair, rules))) {
    lowest = std::min(lowest, value.real());
  }
  EXPECT_LT(lowest, -0.01);
  for (const Mesh& mesh : {pair, test::triangle_grid(4, 4), test::triangle_grid(3, 6)}) {
    const auto result = interpolate(mesh, {.rules = rules, .tolerance = 1e-12});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_TRUE(result->report.converged);
    EXPECT_LT(certify(result->control, mesh.points, rules)->max, 1e-11);
    const auto solution = test::solve(test::dense_operator(mesh, rules), mesh.points);
    EXPECT_LT(test::max_distance(result->control.points, solution), 1e-9);
  }
}

TEST(Interpolation, StopsWhenAsked) {
  const Mesh mesh = test::random_mesh({.seed = 2, .kind = 0});
  // Chebyshev's sweeps run unattended after the first evaluation, and look for the wish themselves.
  for (const auto& [solver, when] :
       {std::pair{Solver::richardson, 3U}, std::pair{Solver::conjugate_gradient, 3U},
        std::pair{Solver::chebyshev, 1U}}) {
    std::atomic<bool> cancel{false};
    Context context;
    context.cancel = &cancel;
    int reports = 0;
    context.progress = [&, last = when](const Progress& p) {
      if (p.iteration == last) cancel = true;
      ++reports;
    };
    const auto result = interpolate(mesh, {.solver = solver, .tolerance = 1e-15}, context);
    ASSERT_FALSE(result) << name_of(solver);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_LT(reports, 8);
  }
}

TEST(Interpolation, ReportsItsErrorsHonestly) {
  const Mesh mesh = test::octahedron();
  const auto r = interpolate(mesh, {.tolerance = 1e-14}).value();
  // All vertices are alike: limit 24/55, so the first error is (1 - 24/55) / 2 of the box side 2.
  EXPECT_NEAR(r.report.initial.max, (1 - 24.0 / 55) / 2, 1e-15);
  EXPECT_NEAR(r.report.initial.mean, (1 - 24.0 / 55) / 2, 1e-15);
  EXPECT_NEAR(r.control.points[0][0], 55.0 / 24, 1e-13);
  EXPECT_EQ(r.report.box_side, 2);
  EXPECT_EQ(r.report.boundary_iterations, 0U);
  EXPECT_EQ(r.control.annotation("scheme"), "loop");
}

TEST(Interpolation, WorksAtEveryScaleOfCoordinates) {
  const Mesh base = test::random_mesh({.seed = 12, .kind = 3});
  const auto expected = interpolate(base, {.tolerance = 1e-12}).value();
  for (const double scale : {1e-300, 1e-30, 1e30, 1e200}) {
    Mesh mesh = base;
    for (Point& p : mesh.points) {
      for (double& x : p) x *= scale;
    }
    for (const Solver solver : {Solver::chebyshev, Solver::conjugate_gradient}) {
      const auto result = interpolate(mesh, {.solver = solver, .tolerance = 1e-12});
      ASSERT_TRUE(result) << describe(result.error());
      EXPECT_TRUE(result->report.converged) << scale;
      EXPECT_NEAR(result->control.points[5][0] / scale, expected.control.points[5][0], 1e-10);
    }
  }
}

// Points that are rounded where they are have their own interpolating surface; nothing more than
// the last rounding of its control points may be lost.
TEST(Interpolation, LosesNothingFarFromTheOrigin) {
  const Point place = {1e6, -3e7, 2e9};
  for (const Scheme scheme : all_schemes()) {
    SCOPED_TRACE(name_of(scheme));
    Mesh mesh = test::random_mesh({.seed = 12, .kind = 3});
    for (Point& p : mesh.points) {
      for (std::size_t k = 0; k < 3; ++k) p[k] += place[k];
    }
    Mesh near = mesh;
    for (Point& p : near.points) {
      for (std::size_t k = 0; k < 3; ++k) p[k] -= place[k];  // exact
    }
    const InterpolateOptions options{.rules = {.scheme = scheme}, .tolerance = 1e-14};
    const Mesh expected = interpolate(near, options)->control;
    const auto found = interpolate(mesh, options);
    ASSERT_TRUE(found->report.converged);
    const auto limits = limit_positions(found->control, options.rules);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double unit = std::nextafter(std::abs(place[k]), HUGE_VAL) - std::abs(place[k]);
        EXPECT_NEAR(found->control.points[v][k] - place[k], expected.points[v][k], unit);
        EXPECT_NEAR((*limits)[v][k], mesh.points[v][k], 1.5 * unit);
      }
    }
  }
}

}  // namespace
}  // namespace surpass

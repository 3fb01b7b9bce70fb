// What interpolation by similarity promises, and what it refuses.
#include <surpass/quality.hpp>
#include <surpass/similarity.hpp>

#include <atomic>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scheme/patch_rows.hpp"
#include "similarity_samples.hpp"

namespace surpass {
namespace {

// Sampled more densely, the fair surface settles: the sums tend to the integral.
TEST(Similarity, MoreSamplesTendToTheIntegral) {
  const Mesh mesh = test::jittered(test::quad_grid(4, 4));
  std::vector<std::vector<Point>> found;
  for (const unsigned samples : {3U, 5U, 9U, 17U}) {
    SimilarityOptions options;
    options.similarity = Similarity::fair;
    options.samples = samples;
    options.solver_tolerance = 1e-12;
    found.push_back(interpolate_similar(mesh, options).value().control.points);
  }
  const double first = test::max_distance(found[0], found[1]);
  const double second = test::max_distance(found[1], found[2]);
  const double third = test::max_distance(found[2], found[3]);
  EXPECT_LT(second, first / 2);
  EXPECT_LT(third, second / 2);
}

TEST(Similarity, AReferenceOfOnesOwnIsReproduced) {
  // Its own limits, to be interpolated: nothing is better than the reference itself.
  const Mesh mesh = test::jittered(test::prism(5));
  const Rules rules = {Scheme::catmull_clark};
  const auto limits = limit_positions(mesh, rules).value();
  const Mesh refined = refine(mesh, rules, 1).value();
  for (const Similarity similarity : {Similarity::vectors, Similarity::directions}) {
    SimilarityOptions options;
    options.similarity = similarity;
    options.scaling = Scaling::none;
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    for (const auto& reference : {mesh.points, refined.points}) {
      const auto found = solver.solve_like(reference, limits);
      ASSERT_TRUE(found) << describe(found.error());
      EXPECT_LT(test::max_distance(found->points, refined.points), 1e-13);
      EXPECT_EQ(found->report.solve.iterations, 0U);
    }
  }
}

// The cube's own limit is at 5/9 of it and so is stretched by 2: values of the specification.
TEST(Similarity, TheReferenceOfTheCubeIsKnown) {
  const Mesh cube = test::cube();
  const auto solver = SimilarityInterpolator::create(cube).value();
  const auto reference = solver.reference(cube.points).value();
  ASSERT_EQ(reference.size(), 26U);
  for (std::size_t v = 0; v < reference.size(); ++v) {
    const double expected = v < 8 ? 10.0 / 9 : v < 20 ? 1.5 : 2;
    const std::size_t sides = v < 8 ? 3 : v < 20 ? 2 : 1;
    std::size_t found = 0;
    for (const double x : reference[v]) {
      if (std::abs(std::abs(x) - expected) < 1e-14) ++found;
      EXPECT_LT(std::abs(x), expected + 1e-14);
    }
    EXPECT_EQ(found, sides) << v;
  }
}

TEST(Similarity, TheReferenceHasTheBoxOfTheGivenPoints) {
  for (const Scheme scheme : all_schemes()) {
    for (const Mesh& mesh :
         {test::jittered(test::triangle_grid(6, 5)), test::jittered(test::icosahedron())}) {
      SCOPED_TRACE(name_of(scheme));
      SimilarityOptions options;
      options.rules = {scheme};
      const auto solver = SimilarityInterpolator::create(mesh, options).value();
      const auto reference = solver.reference(mesh.points).value();
      const auto limits = solver.limit_positions(reference).value();
      EXPECT_GT(test::max_distance(limits, mesh.points), 1e-3) << "it need not interpolate";
      const auto box = bounding_box(limits);
      const auto given = bounding_box(mesh.points);
      EXPECT_LT(test::max_distance({box.low, box.high}, {given.low, given.high}), 1e-13);
    }
  }
}

// Of what is free; the rest is where the given points, or their substitutes, need it.
TEST(Similarity, WithoutIterationsFreeVerticesAreTheReferences) {
  Mesh mesh = test::jittered(test::quad_grid(4, 3));
  const std::size_t n = mesh.points.size();
  Mesh other = mesh;
  for (Point& p : other.points) p[2] += p[0] * p[1];
  const Requirement moved = {.kind = Requirement::Kind::position, .vertex = 6, .value = {9, 1, 2}};
  for (const OpenMeshes open : {OpenMeshes::boundary_rules, OpenMeshes::dummy_ring}) {
    SimilarityOptions options;
    options.open = open;
    options.max_iterations = 0;
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    std::vector<std::vector<Point>> seen;
    for (const auto& own : {std::vector<Point>(), other.points}) {
      for (const auto& wishes : {std::vector<Requirement>(), std::vector{moved}}) {
        const auto found = solver.solve_required(wishes, mesh.points, own).value();
        const auto reference = solver.reference(mesh.points, own, wishes).value();
        ASSERT_EQ(reference.size(), found.points.size());
        for (std::size_t v = n; v < reference.size(); ++v) {
          EXPECT_EQ(reference[v], found.points[v]) << v;
        }
        EXPECT_NE(reference[6], found.points[6]);
        for (const auto& earlier : seen) EXPECT_NE(reference, earlier);
        seen.push_back(reference);
      }
    }
  }
}

TEST(Similarity, ProgressTellsTheResidual) {
  const Mesh mesh = test::jittered(test::quad_grid(9, 7));
  std::vector<double> told;
  const auto note = [&](const Progress& p) {
    if (p.iteration == 0) return;
    told.push_back(p.residual);
    EXPECT_EQ(p.iteration, told.size());
    EXPECT_EQ(p.error, 0);
  };
  const auto solver = SimilarityInterpolator::create(mesh).value();
  const auto found = solver.solve(mesh.points, {}, {.progress = note}).value();
  EXPECT_EQ(told, found.report.residuals);
}

TEST(Similarity, WhatWasCancelledBeforeIsNotSolvedEvenWithoutIterations) {
  const std::atomic<bool> cancel = true;
  SimilarityOptions options;
  options.max_iterations = 0;
  const auto solver = SimilarityInterpolator::create(test::cube(), options).value();
  const auto stopped = solver.solve(test::cube().points, {}, {.cancel = &cancel});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

// The first iteration moves all free points along one field: a step of progressive interpolation.
TEST(Similarity, TheFirstStepIsProgressive) {
  const Mesh mesh = test::jittered(test::quad_grid(9, 7));
  const Rules rules = {Scheme::catmull_clark};
  for (const Similarity similarity :
       {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.similarity = similarity;
    options.max_iterations = 1;
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    const auto reference = solver.reference(mesh.points).value();
    const auto moved = solver.solve(mesh.points).value().points;
    const auto limits = solver.limit_positions(reference).value();
    Mesh missed = mesh;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      for (std::size_t c = 0; c < 3; ++c) missed.points[v][c] -= limits[v][c];
    }
    const std::vector<Point> step = refine(missed, rules, 1).value().points;
    double along = 0;
    double square = 0;
    for (std::size_t j = mesh.points.size(); j < step.size(); ++j) {
      for (std::size_t c = 0; c < 3; ++c) {
        along += step[j][c] * (moved[j][c] - reference[j][c]);
        square += step[j][c] * step[j][c];
      }
    }
    EXPECT_GT(along / square, 0.5);
    EXPECT_LT(along / square, 4);
    for (std::size_t j = mesh.points.size(); j < step.size(); ++j) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_NEAR(moved[j][c], reference[j][c] + along / square * step[j][c], 1e-12);
      }
    }
  }
}

TEST(Similarity, ChannelsAreInterpolatedAlong) {
  Mesh mesh = test::jittered(test::quad_grid(4, 3));
  Channel colour{"color", {"r", "g"}, {}};
  for (const Point& p : mesh.points) colour.values.insert(colour.values.end(), {p[0], 7 * p[2]});
  mesh.channels = {colour};
  for (const Similarity similarity :
       {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.similarity = similarity;
    const auto found = interpolate_similar(mesh, options).value();
    Mesh carrier = found.control;
    for (std::size_t v = 0; v < carrier.points.size(); ++v) {
      carrier.points[v] = {found.control.channels[0].values[2 * v],
                           found.control.channels[0].values[2 * v + 1], 0};
    }
    const auto limits = limit_positions(carrier, options.rules).value();
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_NEAR(limits[v][0], colour.values[2 * v], 1e-13);
      EXPECT_NEAR(limits[v][1], colour.values[2 * v + 1], 1e-13);
    }
  }
}

TEST(Similarity, RefusesWhatCannotBeMeant) {
  const Mesh cube = test::cube();
  const auto refused = [&](const SimilarityOptions& options) {
    const auto solver = SimilarityInterpolator::create(cube, options);
    return solver ? ErrorCode::not_built_in : solver.error().code;
  };
  EXPECT_EQ(refused({.samples = 4}), ErrorCode::invalid_argument);
  EXPECT_EQ(refused({.solver_tolerance = 0}), ErrorCode::invalid_argument);
  EXPECT_EQ(refused({.similarity = Similarity::fair, .thin_plate = 0}),
            ErrorCode::invalid_argument);
  EXPECT_EQ(refused({.rules = {Scheme::loop}}), ErrorCode::unsuitable_for_scheme) << "quads";
  const auto solver = SimilarityInterpolator::create(cube).value();
  EXPECT_EQ(solver.solve(std::vector<Point>(7)).error().code, ErrorCode::mismatch);
  EXPECT_EQ(solver.solve_like(std::vector<Point>(9), cube.points).error().code,
            ErrorCode::mismatch);
  EXPECT_EQ(solver.reference(std::vector<Point>(7)).error().code, ErrorCode::mismatch);
  EXPECT_EQ(solver.reference(cube.points, std::vector<Point>(9)).error().code, ErrorCode::mismatch);
  const Requirement nowhere = {.kind = Requirement::Kind::remove, .vertex = 8};
  EXPECT_EQ(solver.reference(cube.points, {}, std::vector{nowhere}).error().code,
            solver.solve_required(std::vector{nowhere}, cube.points).error().code);
  auto points = cube.points;
  points[3][1] = NAN;
  EXPECT_EQ(solver.reference(points).error().code, ErrorCode::not_finite);
  EXPECT_EQ(solver.solve(points).error().code, ErrorCode::not_finite);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(solver.solve(test::jittered(cube).points, {}, {.cancel = &stop}).error().code,
            ErrorCode::cancelled);
  EXPECT_EQ(SimilarityInterpolator::create(cube, {}, {.cancel = &stop}).error().code,
            ErrorCode::cancelled);
}

TEST(Similarity, OnlyTheRatioOfThinPlateAndMembraneMatters) {
  const Mesh mesh = test::random_polygons({.seed = 2, .kind = 1});
  const auto solve = [&](double scale) {
    const SimilarityOptions options{
        .similarity = Similarity::fair, .thin_plate = scale, .membrane = 0.25 * scale};
    return interpolate_similar(mesh, options).value();
  };
  const auto expected = solve(1);
  EXPECT_GT(expected.report.solve.iterations, 0U);
  for (const double scale : {std::ldexp(1.0, -1000), std::ldexp(1.0, 1000)}) {
    EXPECT_EQ(solve(scale).control.points, expected.control.points) << scale;
  }
}

// Around a vertex, or inside a face, of thousands: what depends on all neighbours is left out.
TEST(Similarity, ThousandsOfFacesAroundAVertexAreInterpolated) {
  constexpr Index kMany = 5000;
  Mesh disc;  // one face
  for (Index i = 0; i < kMany; ++i) {
    const double t = 2 * M_PI * i / kMany;
    disc.points.push_back({std::cos(t), std::sin(t), 0.1 * std::cos(5 * t)});
  }
  std::vector<Index> all(kMany);
  std::iota(all.begin(), all.end(), Index{0});
  disc.add_face(all);
  Mesh cone = disc;  // open
  cone.face_offsets = {0};
  cone.face_vertices.clear();
  cone.points.push_back({0, 0, 1});
  for (Index i = 0; i < kMany; ++i) cone.add_face(std::array{i, (i + 1) % kMany, kMany});
  const Mesh closed = test::bipyramid(kMany);
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::doo_sabin}) {
    for (const Mesh& mesh : {disc, cone, closed}) {
      if (scheme == Scheme::loop && mesh.face(0).size() != 3) continue;
      for (const Similarity form :
           {Similarity::vectors, Similarity::directions, Similarity::fair}) {
        SCOPED_TRACE(std::string(name_of(scheme)) + ", " + name_of(form));
        SimilarityOptions options;
        options.rules = {scheme};
        options.similarity = form;
        const auto found = interpolate_similar(mesh, options);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_LE(certify(found->control, mesh, options.rules)->max, 1e-12);
        EXPECT_LT(bounding_box(found->control.points).side(), 3) << "and not thrown about";
      }
    }
  }
}

// The rows of all kinds of patches: the order of the derivative, then the weights, ascending.
std::vector<std::vector<double>> weights_of_rows(const Mesh& mesh, const Rules& rules) {
  const auto topology = Topology::build(mesh).value();
  const auto patches = PatchRows::build(mesh, topology, rules, 1, {}, {}).value();
  std::vector<std::vector<double>> rows;
  for (const PatchKind& kind : patches.kinds()) {
    for (std::size_t r = 0; r < kind.row_count(); ++r) {
      std::vector<double>& row = rows.emplace_back();
      for (const double w : kind.row(r)) {
        if (std::abs(w) > 1e-13) row.push_back(w);
      }
      std::sort(row.begin(), row.end());
      row.insert(row.begin(), static_cast<double>(kind.derivative[r]));
    }
  }
  return rows;
}

// What is left out at many faces is what depends on all of them, and nothing else is changed.
TEST(Similarity, RowsBesideManyFacesAreThoseOfTheWholeMesh) {
  constexpr Index kMost = 256;
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::doo_sabin}) {
    SCOPED_TRACE(name_of(scheme));
    const Rules rules = {scheme};
    const auto rows_at = [&](Index n) {
      return weights_of_rows(refine(test::bipyramid(n), rules, 1).value(), rules);
    };
    const auto is_local = [](const std::vector<double>& row) { return row.size() < kMost / 4; };
    const auto is_in = [](const std::vector<double>& row, const auto& rows) {
      return std::any_of(rows.begin(), rows.end(), [&](const std::vector<double>& other) {
        return std::equal(row.begin(), row.end(), other.begin(), other.end(),
                          [](double a, double b) { return std::abs(a - b) < 1e-12; });
      });
    };
    const auto whole = rows_at(kMost);
    const auto cut = rows_at(kMost + 1);
    EXPECT_FALSE(std::all_of(whole.begin(), whole.end(), is_local));
    for (const auto& row : cut) EXPECT_TRUE(is_local(row) && is_in(row, whole)) << row.size();
    for (const auto& row : whole) {
      EXPECT_TRUE(!is_local(row) || is_in(row, cut)) << row.size();
    }
  }
}

// Rules of Hoppe et al. at the boundary: what they make of curves is left out.
TEST(Similarity, OnOpenLoopSurfacesUnderHoppeInterpolates) {
  for (const Mesh& mesh : {test::jittered(test::triangle_grid(5, 4)),
                           test::random_mesh({.seed = 4, .kind = 3, .size = 7})}) {
    for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
      for (const unsigned iterations : {0U, 1000U}) {
        SimilarityOptions options;
        options.rules = {Scheme::loop, Boundary::hoppe};
        options.similarity = form;
        options.max_iterations = iterations;
        const auto found = interpolate_similar(mesh, options);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_EQ(found->report.solver_converged, iterations > 0);
        EXPECT_LE(certify(found->control, mesh.points, options.rules)->max, 1e-12);
      }
    }
  }
}

// Points that are rounded where they are: nothing more than the last rounding of the control points
// may be lost.
TEST(Similarity, LosesNothingFarFromTheOrigin) {
  for (const double place : {1e6, 3e7, 1e9}) {
    for (const Scheme scheme : all_schemes()) {
      for (const Similarity form :
           {Similarity::vectors, Similarity::directions, Similarity::fair}) {
        SCOPED_TRACE(fmt::format("{} {} {}", place, name_of(scheme), name_of(form)));
        Mesh mesh = test::jittered(test::triangle_grid(9, 7));
        for (Point& p : mesh.points) {
          for (double& x : p) x += place;
        }
        SimilarityOptions options;
        options.rules = {scheme};
        options.similarity = form;
        options.tolerance = 0;
        const auto found = interpolate_similar(mesh, options).value();
        EXPECT_TRUE(found.report.solve.converged) << found.report.solve.final.max;
        const double unit = std::nextafter(place, HUGE_VAL) - place;
        const double side = bounding_box(mesh.points).side();
        EXPECT_LE(certify(found.control, mesh, options.rules)->max, 2 * unit / side);
      }
    }
  }
}

bool any_note(const SolveReport& report, const std::string& words) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

// A grid whose faces become ten thousand times smaller from one side to the other, or longer than
// wide as well.
Mesh graded(Mesh grid, Index side, bool slim) {
  constexpr double kTurns = 9.2;
  for (Point& p : grid.points) {
    for (double& x : p) x /= side;
    const double angle = kTurns * p[1];
    const double size = std::exp(-kTurns * p[0]);
    p = slim ? Point{p[0] * p[0] * p[0], p[1] * p[1] * p[1], p[2]}
             : Point{size * std::cos(angle), size * std::sin(angle), size * p[2]};
  }
  return grid;
}

// On large meshes the paper's tolerance is reached in single precision, by the steps of double
// precision; smaller ones, which need more steps, and those of faces that are far longer than wide
// in double precision.
TEST(Similarity, SinglePrecisionTakesTheSameSteps) {
  constexpr Index kSide = 130;
  const Mesh grid = test::jittered(test::quad_grid(kSide, kSide));
  SimilarityOptions options;
  options.similarity = Similarity::directions;
  options.max_iterations = 5;
  for (const RowWeights weights : {RowWeights::none, RowWeights::regularised}) {
    options.row_weights = weights;
    const auto distance = [&](const Mesh& mesh) {
      options.solver_tolerance = 1e-2;
      const auto single = interpolate_similar(mesh, options).value();
      options.solver_tolerance = 0.99e-2;
      const auto full = interpolate_similar(mesh, options).value();
      EXPECT_EQ(single.report.residuals.size(), full.report.residuals.size());
      EXPECT_NEAR(single.report.residual / full.report.residual, 1, 1e-5);
      const double side = bounding_box(mesh.points).side();
      return test::max_distance(single.control.points, full.control.points) / side;
    };
    for (const Mesh& mesh : {grid, graded(grid, kSide, false)}) {
      EXPECT_LT(distance(mesh), 1e-6) << name_of(weights);
      EXPECT_GT(distance(mesh), 0) << "they did differ in what they computed with";
    }
    EXPECT_EQ(distance(graded(grid, kSide, true)), 0);
  }
}

// A vertex without faces, however far away, changes no bit of the surface and stays in its place.
TEST(Similarity, IsolatedVerticesFarAwayDoNotMatter) {
  const Mesh mesh = test::jittered(test::quad_grid(4, 4));
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::doo_sabin}) {
    for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
      SimilarityOptions options;
      options.rules = {scheme};
      options.similarity = form;
      const auto alone = interpolate_similar(mesh, options).value();
      EXPECT_GT(alone.report.solve.iterations, 0U);
      for (const double far : {1e19, 1e300}) {
        SCOPED_TRACE(fmt::format("{} {} {}", name_of(scheme), name_of(form), far));
        Mesh more = mesh;
        const Point there = {far, -far / 3, far / 7};
        more.points.push_back(there);
        const auto found = interpolate_similar(more, options).value();
        EXPECT_EQ(found.report.residuals, alone.report.residuals);
        std::vector<Point> points = found.control.points;
        EXPECT_EQ(std::erase(points, there), 1U);
        EXPECT_EQ(points, alone.control.points);
        const auto solver = SimilarityInterpolator::create(more, options).value();
        const auto reference = solver.reference(more.points).value();
        EXPECT_EQ(std::count(reference.begin(), reference.end(), there), 1);
      }
    }
  }
}

TEST(Similarity, AFarTooLargeReferenceIsNamedAsTheCause) {
  const Mesh mesh = test::jittered(test::quad_grid(4, 4));
  SimilarityOptions options;
  options.scaling = Scaling::none;
  const auto solver = SimilarityInterpolator::create(mesh, options).value();
  for (const double size : {1.0, 100.0, 1e200}) {
    std::vector<Point> reference = mesh.points;
    for (Point& p : reference) {
      for (double& x : p) x *= size;
    }
    const SolveReport report = solver.solve_like(reference, mesh.points)->report.solve;
    EXPECT_EQ(report.converged, size < 1e3);
    EXPECT_EQ(any_note(report, "times as large as the given mesh"), size > 1e3) << size;
  }
}

TEST(Similarity, EmptyMeshesAndIsolatedVerticesAreTheirOwn) {
  EXPECT_TRUE(interpolate_similar(Mesh()));
  Mesh mesh = test::cube();
  mesh.points.push_back({5, 6, 7});
  const auto found = interpolate_similar(mesh).value();
  EXPECT_EQ(found.control.points[8], mesh.points[8]);
  EXPECT_NEAR(found.report.scale[0], 2, 1e-14) << "of the cube alone";
}

}  // namespace
}  // namespace surpass

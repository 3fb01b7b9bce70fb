// The schemes beside the paper's own: uniform, mean, the exponential iteration, and the quadratic
// rule.
#include <random>

#include <gtest/gtest.h>

#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

using test::irregular_sphere;
using test::largest_error;
using test::made;
using test::side;

TEST(NonstationarySchemes, UniformAtOneIsLoop) {
  const Mesh mesh = irregular_sphere(8);
  const NonstationaryOptions options{
      .rule = NonstationaryRule::uniform, .shape = 1, .weights = LoopWeights::classic};
  const auto surface = made(mesh, options, 3);
  EXPECT_LE(largest_error(surface.mesh().points, refine(mesh, {}, 3).value().points), 1e-15);
  const Mesh loop = limit_mesh(mesh, {}, 3).value();
  const Mesh ours = surface.limit_mesh().value();
  EXPECT_LE(largest_error(ours.points, loop.points), 1e-15);
  EXPECT_EQ(ours.face_vertices, loop.face_vertices);
  for (std::size_t i = 0; i < loop.channels[0].values.size(); ++i) {
    EXPECT_NEAR(ours.channels[0].values[i], loop.channels[0].values[i], 1e-12);
  }
}

// The paper's Remark 2.
TEST(NonstationarySchemes, InterpolatingWithEqualParametersIsUniform) {
  const Mesh mesh = irregular_sphere(4);
  const double shape = -0.8;
  const auto uniform = made(mesh, {.rule = NonstationaryRule::uniform, .shape = shape}, 2);
  const std::vector<double> equal(mesh.points.size(), shape);
  for (const auto rule : {NonstationaryRule::interpolating, NonstationaryRule::mean}) {
    const auto other = made(mesh, {.rule = rule, .shape = shape, .vertex_parameters = equal}, 2);
    EXPECT_LE(largest_error(other.mesh().points, uniform.mesh().points), 1e-15);
    EXPECT_LE(largest_error(other.limit_positions().value(), uniform.limit_positions().value()),
              1e-14);
    EXPECT_LE(largest_error(other.limit_normals().value(), uniform.limit_normals().value()), 1e-12);
  }
}

// Limits of schemes in which vertices leave the line to the centroid, at every level.
TEST(NonstationarySchemes, MeanHasTheSameLimitAtEveryLevel) {
  const Mesh mesh = irregular_sphere(6);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> parameter(-0.8, 1.5);
  NonstationaryOptions options{.rule = NonstationaryRule::mean};
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    options.vertex_parameters.push_back(parameter(random));
  }
  for (const auto iteration : {ParameterIteration::geometric, ParameterIteration::exponential}) {
    options.iteration = iteration;
    options.shape = 0;
    auto surface = made(mesh, options);
    auto limits = surface.limit_positions().value();
    auto normals = surface.limit_normals().value();
    for (int level = 1; level <= 3; ++level) {
      ASSERT_TRUE(surface.refine());
      auto next = surface.limit_positions().value();
      EXPECT_LE(largest_error(next, limits), 1e-14);
      auto next_normals = surface.limit_normals().value();
      EXPECT_LE(largest_error(next_normals, normals), 1e-9);
      limits = std::move(next);
      normals = std::move(next_normals);
    }
    ASSERT_TRUE(surface.refine());
    const double before = largest_error(surface.mesh().points, limits);
    ASSERT_TRUE(surface.refine());
    EXPECT_NEAR(largest_error(surface.mesh().points, limits) / before, 0.25, 0.02);
  }
}

// Parameters that interpolate with edges of their own do not where edges take means: the paper's
// reason for a parameter of the edges.
TEST(NonstationarySchemes, MeanDoesNotInterpolate) {
  const Mesh mesh = test::reference_bipyramid(3);
  const auto surface = made(mesh, {.rule = NonstationaryRule::mean, .shape = -0.5}, 2);
  EXPECT_GE(largest_error(surface.limit_positions().value(), mesh.points), 1e-2);
}

// The uniform scheme can meet the vertices of one valence: here all have it.
TEST(NonstationarySchemes, UniformInterpolatesOneValence) {
  const Mesh mesh = test::icosahedron();
  double low = -2;
  double high = 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (centroid_share(middle, 5, {.rule = NonstationaryRule::uniform}) > 0 ? high : low) = middle;
  }
  const auto surface = made(mesh, {.rule = NonstationaryRule::uniform, .shape = low}, 3);
  EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), 2e-15);
}

// The paper's Remark 3.
TEST(NonstationaryExponential, CannotInterpolate) {
  for (const Index valence : {3U, 4U, 6U, 20U}) {
    double smallest = 1;
    for (double vertex = -0.999999; vertex < 3; vertex += 0.01) {
      for (double edge = -0.999999; edge < 3; edge += 0.1) {
        const NonstationaryOptions options{.shape = edge,
                                           .iteration = ParameterIteration::exponential};
        smallest = std::min(smallest, centroid_share(vertex, valence, options));
      }
    }
    EXPECT_GT(smallest, 0.1);
  }
}

TEST(NonstationaryExponential, HasTheSameLimitAtEveryLevel) {
  for (const Mesh& mesh : {irregular_sphere(9), test::wavy_fan(5)}) {
    const NonstationaryOptions options{.rule = NonstationaryRule::uniform,
                                       .shape = 2.5,
                                       .iteration = ParameterIteration::exponential};
    auto surface = made(mesh, options, 1);
    const auto limits = surface.limit_positions().value();
    const auto normals = surface.limit_normals().value();
    for (int level = 2; level <= 3; ++level) {
      ASSERT_TRUE(surface.refine());
      EXPECT_LE(largest_error(surface.limit_positions().value(), limits), 1e-14);
      EXPECT_LE(largest_error(surface.limit_normals().value(), normals), 1e-11);
    }
  }
}

TEST(NonstationaryRates, InfinityIsLoopAfterTheFirstStep) {
  const Mesh mesh = irregular_sphere(12);
  const NonstationaryOptions options{.shape = -2,
                                     .weights = LoopWeights::classic,
                                     .rate = std::numeric_limits<double>::infinity()};
  const auto surface = made(mesh, options, 3);
  const Mesh first = made(mesh, options, 1).mesh();
  EXPECT_LE(largest_error(surface.mesh().points, refine(first, {}, 2).value().points), 1e-15);
  EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), 1e-14);
}

/// A piece of the lattice of equilateral triangles, with heights.
template <class Height>
Mesh lattice(int radius, Height&& height) {
  Mesh mesh;
  std::vector<std::vector<Index>> number(static_cast<std::size_t>(2 * radius + 1));
  const auto at = [&](int i, int j) -> Index& {
    auto& row = number[static_cast<std::size_t>(i + radius)];
    row.resize(static_cast<std::size_t>(2 * radius + 1), kNone);
    return row[static_cast<std::size_t>(j + radius)];
  };
  const auto inside = [&](int i, int j) {
    return std::abs(i) <= radius && std::abs(j) <= radius && std::abs(i + j) <= radius;
  };
  for (int i = -radius; i <= radius; ++i) {
    for (int j = -radius; j <= radius; ++j) {
      if (!inside(i, j)) continue;
      at(i, j) = mesh.vertex_count();
      const double x = i + j / 2.0;
      const double y = std::sqrt(3.0) / 2 * j;
      mesh.points.push_back({x, y, height(x, y)});
    }
  }
  for (int i = -radius; i <= radius; ++i) {
    for (int j = -radius; j <= radius; ++j) {
      if (!inside(i, j) || !inside(i + 1, j) || !inside(i, j + 1)) continue;
      mesh.add_face(std::vector<Index>{at(i, j), at(i + 1, j), at(i, j + 1)});
      if (!inside(i + 1, j + 1)) continue;
      mesh.add_face(std::vector<Index>{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(NonstationaryQuadratic, ReproducesQuadraticsOnTheLattice) {
  const auto height = [](double x, double y) {
    return 0.3 * x * x - 0.7 * x * y + 0.2 * y * y + x;
  };
  const Mesh mesh = lattice(5, height);
  for (const int levels : {1, 3}) {
    const auto surface = made(mesh, {.rule = NonstationaryRule::quadratic}, levels);
    std::size_t compared = 0;
    const auto limits = surface.limit_positions().value();
    for (const Point& p : limits) {
      if (std::hypot(p[0], p[1]) > 2) continue;
      EXPECT_NEAR(p[2], height(p[0], p[1]), 4e-15);
      ++compared;
    }
    EXPECT_GE(compared, 40);
  }
}

TEST(NonstationaryQuadratic, Interpolates) {
  for (const Mesh& mesh :
       {test::reference_tetrahedron(), test::icosahedron(), irregular_sphere(5), test::wavy_fan(6),
        test::random_mesh({.seed = 4, .kind = 3, .size = 7})}) {
    const double side = bounding_box(mesh.points).side();
    for (const LoopWeights weights : {LoopWeights::warren, LoopWeights::classic}) {
      NonstationaryOptions options{.rule = NonstationaryRule::quadratic, .weights = weights};
      for (int level = 0; level <= 3; ++level) {
        const auto surface = made(mesh, options, level);
        EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), 1e-14 * side);
      }
      for (const int steps : {1, 2, 4}) {
        options.steps = steps;
        const auto surface = made(mesh, options, steps);
        EXPECT_LE(largest_error(surface.mesh().points, mesh.points), 1e-14 * side);
      }
    }
  }
}

}  // namespace
}  // namespace surpass

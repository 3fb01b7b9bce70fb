// The same bits on any number of threads, on meshes large enough to be cut into many chunks.
#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

const Mesh& large_mesh() {
  static const Mesh mesh = [] {
    std::mt19937_64 random(17);
    Mesh m = refine(test::random_mesh({.seed = 17, .kind = 3, .size = 10, .creases = 0.05}), {}, 4)
                 .value();
    m.channels.push_back({"weight", {"weight"}, {}});
    for (const Point& p : m.points) m.channels[0].values.push_back(p[0] * p[1]);
    return test::jitter(m, random, 0.01);
  }();
  return mesh;
}

TEST(Threads, InterpolationHasTheSameBits) {
  ASSERT_GT(large_mesh().points.size(), 20000U);
  for (const auto& [solver, boundary] : {std::pair{Solver::chebyshev, Boundary::edge_and_corner},
                                         {Solver::richardson, Boundary::hoppe}}) {
    const InterpolateOptions options{
        .rules = {Scheme::loop, boundary}, .solver = solver, .tolerance = 1e-6};
    Context context;
    context.threads = 1;
    const auto one = interpolate(large_mesh(), options, context);
    ASSERT_TRUE(one);
    for (const int threads : {2, 3, 8}) {
      context.threads = threads;
      const auto many = interpolate(large_mesh(), options, context);
      ASSERT_TRUE(many);
      EXPECT_EQ(one->control, many->control) << threads;
      EXPECT_EQ(one->report.final.max, many->report.final.max);
      EXPECT_EQ(one->report.final.mean, many->report.final.mean);
    }
  }
}

// Large enough for sweeps to be shared among threads.
TEST(Threads, SharedSweepsHaveTheSameBits) {
  Mesh mesh = refine(large_mesh(), {}, 1).value();
  ASSERT_GT(mesh.points.size(), 65536U);
  Context context;
  context.threads = 1;
  const auto one = interpolate(mesh, {.tolerance = 1e-10}, context);
  ASSERT_TRUE(one) << describe(one.error());
  EXPECT_GT(one->report.iterations, 5U);
  context.threads = 2;
  const auto two = interpolate(mesh, {.tolerance = 1e-10}, context);
  ASSERT_TRUE(two);
  EXPECT_EQ(one->control, two->control);
  EXPECT_EQ(one->report.final.max, two->report.final.max);
}

TEST(Threads, ConjugateGradientsHaveTheSameBits) {
  Mesh mesh = large_mesh();
  mesh.creases.clear();
  mesh.corners.clear();
  const InterpolateOptions options{.solver = Solver::conjugate_gradient, .tolerance = 1e-6};
  Context context;
  context.threads = 1;
  const auto one = interpolate(mesh, options, context);
  ASSERT_TRUE(one) << describe(one.error());
  for (const int threads : {2, 3, 8}) {
    context.threads = threads;
    EXPECT_EQ(one->control, interpolate(mesh, options, context)->control) << threads;
  }
}

TEST(Threads, EverySchemeHasTheSameBits) {
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::doo_sabin}) {
    const InterpolateOptions options{.rules = {scheme}, .tolerance = 1e-6};
    Context context;
    context.threads = 1;
    const auto one = interpolate(large_mesh(), options, context);
    ASSERT_TRUE(one) << describe(one.error());
    context.threads = 3;
    const auto many = interpolate(large_mesh(), options, context);
    ASSERT_TRUE(many);
    EXPECT_EQ(one->control, many->control) << name_of(scheme);
    EXPECT_EQ(one->report.final.max, many->report.final.max);
  }
}

TEST(Threads, SimilarityHasTheSameBits) {
  for (const Similarity similarity :
       {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.similarity = similarity;
    Context context;
    context.threads = 1;
    Mesh mesh = refine(test::random_polygons({.seed = 17, .kind = 3, .size = 10}),
                       {Scheme::catmull_clark}, 2)
                    .value();
    const auto one = interpolate_similar(mesh, options, context);
    ASSERT_TRUE(one) << describe(one.error());
    EXPECT_GT(one->report.solve.iterations, 2U);
    for (const int threads : {2, 3, 8}) {
      context.threads = threads;
      const auto many = interpolate_similar(mesh, options, context);
      ASSERT_TRUE(many);
      EXPECT_EQ(one->control, many->control) << name_of(similarity) << ", " << threads;
      EXPECT_EQ(one->report.residual, many->report.residual);
    }
  }
}

TEST(Threads, LimitSurfacesHaveTheSameBits) {
  Context context;
  context.threads = 1;
  const auto one = limit_mesh(large_mesh(), {}, 1, context);
  ASSERT_TRUE(one);
  for (const int threads : {2, 3, 8}) {
    context.threads = threads;
    EXPECT_EQ(*one, *limit_mesh(large_mesh(), {}, 1, context)) << threads;
  }
}

}  // namespace
}  // namespace surpass

// Surfaces without curves: interpolation after exact steps and in the limit, at every level.
#include <cstring>

#include <gtest/gtest.h>

#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

using test::irregular_sphere;
using test::largest_error;
using test::made;
using test::side;

std::vector<Mesh> reference_meshes() {
  return {test::reference_tetrahedron(), test::reference_bipyramid(3),
          test::reference_bipyramid(10), test::icosahedron()};
}

class AfterSteps : public testing::TestWithParam<int> {};

TEST_P(AfterSteps, TheGivenVerticesAreThere) {
  const int steps = GetParam();
  for (const Mesh& mesh : reference_meshes()) {
    for (const double shape : {-3.0, -1.0, 1.0}) {
      if (std::ldexp(static_cast<double>(mesh.face_count()), 2 * steps) > 1e5) continue;
      const auto surface = made(mesh, {.shape = shape, .steps = steps}, steps);
      EXPECT_LE(largest_error(surface.mesh().points, mesh.points), 4e-16 * side(mesh));
    }
  }
  if (steps > 5) return;
  for (const LoopWeights weights : {LoopWeights::warren, LoopWeights::classic}) {
    const Mesh mesh = irregular_sphere(static_cast<std::uint64_t>(steps));
    const auto surface = made(mesh, {.weights = weights, .steps = steps}, steps);
    EXPECT_LE(largest_error(surface.mesh().points, mesh.points), 1e-14 * side(mesh));
  }
}

INSTANTIATE_TEST_SUITE_P(Nonstationary, AfterSteps, testing::Range(1, 8));

TEST(NonstationaryLimit, PassesThroughTheGivenVerticesAtEveryLevel) {
  for (const Mesh& mesh : reference_meshes()) {
    for (const double shape : {-3.0, -1.0, 1.0}) {
      auto surface = made(mesh, {.shape = shape});
      for (int level = 0; level <= 5; ++level) {
        EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points),
                  4e-16 * side(mesh));
        ASSERT_TRUE(surface.refine());
      }
    }
  }
}

// The parameters differ at every level, so that each level is a formula of its own.
TEST(NonstationaryLimit, OfAVertexIsTheSameAtEveryLevel) {
  for (const auto rule : {NonstationaryRule::interpolating, NonstationaryRule::uniform}) {
    for (const LoopWeights weights : {LoopWeights::warren, LoopWeights::classic}) {
      const Mesh mesh = irregular_sphere(11);
      auto surface = made(mesh, {.rule = rule, .shape = -2.5, .weights = weights});
      auto before = surface.limit_positions().value();
      for (int level = 1; level <= 3; ++level) {
        ASSERT_TRUE(surface.refine());
        auto next = surface.limit_positions().value();
        EXPECT_LE(largest_error(next, before), 1e-14 * side(mesh));
        before = std::move(next);
      }
    }
  }
}

TEST(NonstationaryLimit, IsWhatRefinementTendsTo) {
  const Mesh mesh = test::reference_bipyramid(7);
  auto surface = made(mesh, {.rule = NonstationaryRule::uniform, .shape = -2}, 1);
  const auto limit = surface.limit_positions().value();
  double before = 0;
  for (int level = 2; level <= 7; ++level) {
    ASSERT_TRUE(surface.refine());
    const double error = largest_error(surface.mesh().points, limit);
    if (level > 3) {
      EXPECT_NEAR(error / before, 0.25, 0.01);  // the slowest mode's eigenvalue
    }
    before = error;
  }
  EXPECT_LE(before, 1e-3);
}

TEST(NonstationaryNormals, AreLoopsAtTheGivenVertices) {
  for (const Mesh& mesh : {irregular_sphere(3), test::reference_bipyramid(9)}) {
    const auto loop = limit_normals(mesh, {}).value();
    for (const double shape : {-3.0, 0.5}) {
      const auto surface = made(mesh, {.shape = shape});
      EXPECT_LE(largest_error(surface.limit_normals().value(), loop), 1e-13);
    }
  }
}

TEST(NonstationaryNormals, AreTheSameAtEveryLevelAndThoseOfTheFacesInTheLimit) {
  const Mesh mesh = test::reference_bipyramid(5, 0.7, 0.8);
  auto surface = made(mesh, {.shape = -2}, 1);
  const auto normals = surface.limit_normals().value();
  double before = 180;
  for (int level = 2; level <= 6; ++level) {
    ASSERT_TRUE(surface.refine());
    EXPECT_LE(largest_error(surface.limit_normals().value(), normals), 1e-12);
    // The slowest of the modes here has 2/3 of the tangents' eigenvalue, at valence 4.
    const double angle = test::worst_angle(surface.mesh(), normals);
    EXPECT_LE(angle, 0.7 * before);
    before = angle;
  }
  EXPECT_LE(before, 10);
}

TEST(NonstationaryTargets, AreMetAndTheOthersStay) {
  const Mesh mesh = test::icosahedron();
  NonstationaryOptions options{.targets = {{2, 0.3}, {7, -0.5}, {4, 0.1}}};
  for (const int steps : {0, 4}) {
    options.steps = steps;
    const auto surface = made(mesh, options, 4);
    const auto found = steps == 0 ? surface.limit_positions().value() : surface.mesh().points;
    EXPECT_LE(largest_error(found, surface.aims()), 1e-15 * side(mesh));
    // Neighbours of a vertex of an icosahedron have their centroid on its axis, at 1 / sqrt(5).
    for (const LineTarget& target : options.targets) {
      const double scale = 1 - target.along + target.along / std::sqrt(5.0);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[target.vertex][c], scale * mesh.points[target.vertex][c], 2e-15);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[0][c], mesh.points[0][c], 1e-15);
  }
}

TEST(NonstationaryMesh, CarriesWhatHangsOnIt) {
  Mesh mesh = test::icosahedron();
  Channel copy{"copy", {"a", "b", "c"}, {}};
  for (const Point& p : mesh.points) copy.values.insert(copy.values.end(), p.begin(), p.end());
  mesh.channels = {copy};
  mesh.hole_faces = {3};
  mesh.face_sets = {{FaceSet::Kind::group, "top", {1, 2}}};
  const auto surface = made(mesh, {}, 2);
  const auto equal = [](const Mesh& m, const Channel& channel) {
    return std::memcmp(channel.values.data(), m.points.data(), channel.values.size() * 8) == 0 &&
           channel.values.size() == 3 * m.points.size();
  };
  EXPECT_TRUE(equal(surface.mesh(), surface.mesh().channels[0]));
  EXPECT_EQ(surface.mesh().face_sets[0].faces.size(), 32);
  EXPECT_EQ(surface.mesh().hole_faces.size(), 16);
  const Mesh limit = surface.limit_mesh().value();
  EXPECT_TRUE(equal(limit, limit.channels[0]));
  EXPECT_EQ(limit.channels[1].name, "normal");
  EXPECT_EQ(limit.face_count(), 19 * 16);
  EXPECT_LE(largest_error(limit.points, mesh.points), 1e-15);
}

TEST(NonstationaryMesh, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = test::random_mesh({.seed = 5, .kind = 3, .size = 30});
  std::vector<Mesh> found;
  for (const int threads : {1, 3}) {
    const Context context{.threads = threads};
    auto surface = NonstationaryLoop::create(mesh, {}, context).value();
    for (int level = 0; level < 3; ++level) ASSERT_TRUE(surface.refine(context));
    found.push_back(surface.limit_mesh(context).value());
  }
  EXPECT_GT(found[0].face_count(), 50000);
  EXPECT_TRUE(found[0] == found[1]);
}

Mesh scaled(Mesh mesh, double factor) {
  for (Point& p : mesh.points) {
    for (double& x : p) x *= factor;
  }
  return mesh;
}

// Where products of lengths leave the range of doubles.
TEST(LimitNormals, AreThoseOfTheMeshInAnySize) {
  for (const Mesh& mesh : {test::icosahedron(), irregular_sphere(4), test::wavy_fan(6, true)}) {
    const std::vector<Point> expected = made(mesh, {}, 1).limit_normals().value();
    const std::vector<Point> plain = limit_normals(mesh, {}).value();
    const std::vector<Point> dual = limit_normals(mesh, {Scheme::doo_sabin}).value();
    for (const double factor : {0x1p532, 0x1p1000, 0x1p-532, 0x1p-900}) {
      const Mesh other = scaled(mesh, factor);
      EXPECT_LE(largest_error(made(other, {}, 1).limit_normals().value(), expected), 1e-14);
      EXPECT_LE(largest_error(limit_normals(other, {}).value(), plain), 1e-14);
      EXPECT_LE(largest_error(limit_normals(other, {Scheme::doo_sabin}).value(), dual), 1e-14);
    }
  }
  const auto mean = [](double factor) {
    return made(scaled(test::icosahedron(), factor), {.rule = NonstationaryRule::mean}, 1)
        .limit_normals()
        .value();
  };
  EXPECT_LE(largest_error(mean(0x1p532), mean(1)), 1e-14);
}

// Differences of such points are no numbers any more; normals still are, or zero.
TEST(LimitNormals, AreNumbersAtTheEndOfTheRange) {
  const Mesh mesh = scaled(test::icosahedron(), 1e308);
  for (const auto& normals :
       {made(mesh, {}).limit_normals().value(), limit_normals(mesh, {}).value()}) {
    for (const Point& n : normals) {
      for (const double x : n) EXPECT_LE(std::abs(x), 1);
    }
  }
}

}  // namespace
}  // namespace surpass

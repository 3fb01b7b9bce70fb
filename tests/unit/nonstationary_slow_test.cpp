// As many steps as a computer's memory takes: the vertices are there after each number of them.
#include <surpass/fairness.hpp>
#include <surpass/io.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

class AfterManySteps : public testing::TestWithParam<int> {};

TEST_P(AfterManySteps, TheGivenVerticesAreThere) {
  const int steps = GetParam();
  for (const Mesh& mesh : {test::reference_tetrahedron(), test::reference_bipyramid(3),
                           test::icosahedron(), test::reference_bipyramid(10)}) {
    if (std::ldexp(static_cast<double>(mesh.face_count()), 2 * steps) > 7e6) continue;
    for (const double shape : {-3.0, 1.0}) {
      const auto surface = test::made(mesh, {.shape = shape, .steps = steps}, steps);
      EXPECT_LE(test::largest_error(surface.mesh().points, mesh.points),
                4e-16 * bounding_box(mesh.points).side());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Nonstationary, AfterManySteps, testing::Range(7, 11));

// Meshes whose bending has narrow spikes over the shapes.
TEST(FairestShapeSlow, IsThatOfABruteForceScan) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  for (const char* name : {"/tri/paper_turtle_445.off", "/tri/paper_bird_1129.off"}) {
    const Mesh mesh = read_mesh(test::data_folder() + name).value().mesh;
    const auto found = fairest_shape(mesh, {}, {.levels = 4}).value();
    const auto energy = [&](double shape) {
      return fairness(mesh, NonstationaryOptions{.shape = shape}, {.levels = 4})
          .value()
          .trimmed_bending;
    };
    EXPECT_EQ(energy(found.shape), found.trimmed_bending);
    double least = found.trimmed_bending;
    for (int i = 0; i <= 80; ++i) least = std::min(least, energy(-3.99 + 7.98 / 80 * i));
    EXPECT_LE(found.trimmed_bending, 1.01 * least) << name;
  }
}

}  // namespace
}  // namespace surpass

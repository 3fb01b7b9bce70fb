// As many steps as a computer's memory takes: the vertices are there after each number of them.
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

}  // namespace
}  // namespace surpass

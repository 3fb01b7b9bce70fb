// The same on every mesh of a folder given from outside, which takes minutes.
#include <gtest/gtest.h>

#include "similar_meshes.hpp"

namespace surpass {
namespace {

TEST(EveryMeshBySimilarity, GivenTrianglesAreInterpolated) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(test::interpolated_by_similarity(test::real_meshes("tri")), 95);
}

TEST(EveryMeshBySimilarity, GivenPolygonsAreInterpolated) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  EXPECT_GE(test::interpolated_by_similarity(test::real_meshes("quad")), 60);
}

}  // namespace
}  // namespace surpass

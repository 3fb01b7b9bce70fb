// Similarity and fair interpolation on every committed mesh, and where plain interpolation has no
// answer: to 1e-12, judged by OpenSubdiv.
#include <surpass/similarity.hpp>

#include <gtest/gtest.h>

#include "similar_meshes.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

TEST(EveryMeshBySimilarity, CommittedOnesAreInterpolated) {
  EXPECT_EQ(test::interpolated_by_similarity(test::committed_meshes()),
            static_cast<int>(test::committed_meshes().size()));
}

TEST(EveryMeshBySimilarity, SamplesOfEverySpecialCase) {
  for (const test::Sample& sample : test::polygon_samples()) {
    SCOPED_TRACE(sample.name);
    EXPECT_TRUE(test::is_interpolated_by_similarity(sample.mesh));
  }
}

// Where plain interpolation has no answer.
TEST(EveryMeshBySimilarity, CubesPrismsAndDualsHaveSurfaces) {
  Mesh cube = test::cube();
  for (double& x : cube.points[6]) x *= 2;
  std::mt19937_64 random(4);
  for (const Mesh& given : {cube, test::jitter(test::prism(4), random, 0.1),
                            test::jitter(test::prism(8), random, 0.1)}) {
    const auto plain = interpolate(given, {.rules = {Scheme::catmull_clark}});
    ASSERT_FALSE(plain);
    EXPECT_EQ(plain.error().code, ErrorCode::singular);
    EXPECT_TRUE(test::is_interpolated_by_similarity(given));
  }
  EXPECT_TRUE(test::is_interpolated_by_similarity(
      test::jitter(test::dual(test::icosahedron()), random, 0.1)));
}

}  // namespace
}  // namespace surpass

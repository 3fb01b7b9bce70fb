// Similarity and fair interpolation on every committed mesh, and where plain interpolation has no
// answer: to 1e-12, judged by OpenSubdiv.
#include <surpass/fairness.hpp>
#include <surpass/similarity.hpp>

#include <numbers>

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

// A sphere bends by 8 pi; surfaces with ripples or folds, by many times that.
void expect_clean(const Mesh& given) {
  for (const Similarity form : {Similarity::vectors, Similarity::directions}) {
    SimilarityOptions options;
    options.similarity = form;
    const auto found = interpolate_similar(given, options);
    ASSERT_TRUE(found);
    const auto measured = fairness(found->control, options.rules, {.levels = 3});
    ASSERT_TRUE(measured);
    EXPECT_LT(measured->bending, 2 * 8 * std::numbers::pi);
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
    expect_clean(given);
  }
  const Mesh dodecahedron = test::jitter(test::dual(test::icosahedron()), random, 0.1);
  EXPECT_TRUE(test::is_interpolated_by_similarity(dodecahedron));
  expect_clean(dodecahedron);
}

}  // namespace
}  // namespace surpass

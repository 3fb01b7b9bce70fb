// The clouds of the size of the Doo-Sabin reconstruction paper's Table 1.
#include <cstdlib>
#include <filesystem>

#include "reconstruct_clouds.hpp"

namespace surpass::test {
namespace {

struct Model {
  const char* file;
  std::size_t genus;
  Index vertices;
};
constexpr Model kModels[] = {{"paper3_CubeHC_like_82016.ply", 5, 7666},
                             {"paper3_Goblet_like_129343.ply", 0, 8082},
                             {"paper3_Rockarm_like_204051.ply", 1, 13984}};

class PaperClouds : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    const char* data = std::getenv("SURPASS_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of clouds";
    const auto loaded = read_points(std::filesystem::path(data) / "bench_points" / GetParam().file);
    ASSERT_TRUE(loaded) << describe(loaded.error());
    cloud_ = loaded->mesh.points;
  }
  Cloud cloud_;
};

TEST_P(PaperClouds, HaveTheirGenusAndKeepEveryPoint) {
  const Reconstruction found = reconstructed(cloud_);
  expect_closed(found, GetParam().genus);
  expect_input_points(found, cloud_);
  EXPECT_TRUE(found.unused.empty());
}

TEST_P(PaperClouds, HaveTheirGenusWithThePapersNumberOfVertices) {
  const Reconstruction found = reconstructed(cloud_, {.vertices = GetParam().vertices});
  expect_closed(found, GetParam().genus);
  expect_input_points(found, cloud_);
  EXPECT_EQ(found.mesh.vertex_count(), GetParam().vertices);
}

TEST_P(PaperClouds, AreNeverFurtherThanATolerance) {
  const double side = bounding_box(cloud_).side();
  for (const double tolerance : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3}) {
    SCOPED_TRACE(tolerance);
    const Reconstruction found = reconstructed(cloud_, {.tolerance = tolerance});
    const auto measured = point_distances(cloud_, found.mesh);
    ASSERT_TRUE(measured);
    EXPECT_LE(measured->max, tolerance * side);
    expect_closed(found, GetParam().genus);
  }
}

TEST(EveryCloud, EndsInAMesh) {
  const char* data = std::getenv("SURPASS_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of clouds";
  std::size_t met = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(data) / "points")) {
    SCOPED_TRACE(entry.path().filename());
    const auto loaded = read_points(entry.path());
    ASSERT_TRUE(loaded) << describe(loaded.error());
    const auto found = reconstruct(loaded->mesh.points, loaded->mesh.channels);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(Topology::build(found->mesh));
    EXPECT_GT(found->mesh.face_count(), 0U);
    ++met;
  }
  EXPECT_GT(met, 10U);
}

INSTANTIATE_TEST_SUITE_P(Table1, PaperClouds, testing::ValuesIn(kModels),
                         [](const auto& model) { return std::string(model.param.file, 7, 4); });

}  // namespace
}  // namespace surpass::test

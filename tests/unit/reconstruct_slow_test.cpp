// The clouds of the size of the Doo-Sabin reconstruction paper's Table 1.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "reconstruct_clouds.hpp"

namespace surpass::test {
namespace {

struct Model {
  const char* file;
  std::size_t genus;
  Index vertices;
  std::size_t unused;  // at most: the bust has sheets that nearly touch
  double limit;        // largest distance of a used point from the limit surface, of the box side
};
constexpr Model kModels[] = {{"paper3_CubeHC_like_82016.ply", 5, 7666, 0, 0.0088},
                             {"paper3_Goblet_like_129343.ply", 0, 8082, 0, 0.0023},
                             {"paper3_Rockarm_like_204051.ply", 1, 13984, 0, 0.0016},
                             {"paper3_Beethoven_like_262038.ply", 0, 16378, 30, 0.0035}};

class PaperClouds : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    const char* data = std::getenv("SURPASS_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of clouds";
    const auto loaded = read_points(std::filesystem::path(data) / "bench_points" / GetParam().file);
    ASSERT_TRUE(loaded) << describe(loaded.error());
    cloud_ = loaded->mesh.points;
  }
  // The points that a mesh uses.
  [[nodiscard]] Cloud used(const Reconstruction& found) const {
    Cloud points;
    for (Index i = 0; i < cloud_.size(); ++i) {
      if (!std::binary_search(found.unused.begin(), found.unused.end(), i)) {
        points.push_back(cloud_[i]);
      }
    }
    return points;
  }
  Cloud cloud_;
};

TEST_P(PaperClouds, HaveTheirGenusAndKeepEveryPoint) {
  const Reconstruction found = reconstructed(cloud_);
  expect_closed(found, GetParam().genus);
  expect_input_points(found, cloud_);
  EXPECT_LE(found.unused.size(), GetParam().unused);
}

TEST_P(PaperClouds, HaveTheirGenusWithThePapersNumberOfVertices) {
  const Reconstruction found = reconstructed(cloud_, {.vertices = GetParam().vertices});
  expect_closed(found, GetParam().genus);
  expect_input_points(found, cloud_);
  EXPECT_EQ(found.mesh.vertex_count(), GetParam().vertices);
  const Rules rules{.scheme = Scheme::doo_sabin};
  const auto control = interpolate(found.mesh, {.rules = rules, .tolerance = 1e-12});
  ASSERT_TRUE(control) << describe(control.error());
  EXPECT_LE(certify(control->control, found.mesh.points, rules)->max, 1e-12);
  const auto distances =
      limit_distances(cloud_, found.source, found.unused, control->control, rules);
  ASSERT_TRUE(distances);
  EXPECT_LE(distances->used.max, GetParam().limit * bounding_box(cloud_).side());
}

TEST_P(PaperClouds, AreNeverFurtherThanATolerance) {
  const double side = bounding_box(cloud_).side();
  for (const double tolerance : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3}) {
    SCOPED_TRACE(tolerance);
    const Reconstruction found = reconstructed(cloud_, {.tolerance = tolerance});
    const auto measured = point_distances(used(found), found.mesh);
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

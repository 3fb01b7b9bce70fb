// Clouds of a folder of data: scans, noise, outliers. Skipped where SURPASS_TEST_DATA names none.
#include <cstdlib>
#include <filesystem>

#include "reconstruct_clouds.hpp"

namespace surpass::test {
namespace {

namespace fs = std::filesystem;

class CloudFiles : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("SURPASS_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of clouds";
    folder_ = data;
  }
  Cloud cloud(const std::string& name) const {
    const auto loaded = read_points(folder_ / name);
    EXPECT_TRUE(loaded) << (loaded ? "" : describe(loaded.error()));
    return loaded ? loaded->mesh.points : Cloud{};
  }
  fs::path folder_;
};

TEST_F(CloudFiles, NoiseOfAThirdOfASpacing) {
  const Reconstruction found = reconstructed(cloud("points/sampled_rocker_20001_noise03.ply"));
  expect_closed(found, 1);
  EXPECT_GT(found.report.smoothing_passes, 0U);
}

TEST_F(CloudFiles, FivePercentOfOutliers) {
  const Cloud given = cloud("points/sampled_rocker_21001_outliers5pct.ply");
  const Reconstruction found = reconstructed(given);
  expect_closed(found, 1);
  expect_input_points(found, given);
}

TEST_F(CloudFiles, AScanOfABunny) {
  const Cloud given = cloud("points/meshlab_bunny_16130.ply");
  const Reconstruction found = reconstructed(given);
  expect_closed(found, 0);
  expect_input_points(found, given);
  EXPECT_TRUE(found.unused.empty());
}

TEST_F(CloudFiles, NastyOnesEndInAMeshOrASentence) {
  std::size_t met = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "nasty" / "made")) {
    if (entry.path().extension() != ".xyz") continue;
    SCOPED_TRACE(entry.path().filename());
    ++met;
    const auto loaded = read_points(entry.path());
    if (!loaded) {
      EXPECT_TRUE(loaded.error().place.line || loaded.error().message == "the file is empty");
      continue;
    }
    const auto found = reconstruct(loaded->mesh.points);
    if (found) {
      EXPECT_TRUE(Topology::build(found->mesh));
    } else {
      EXPECT_FALSE(found.error().message.empty());
    }
  }
  EXPECT_GT(met, 8U);
}

}  // namespace
}  // namespace surpass::test

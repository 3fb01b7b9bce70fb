// The same on every mesh of a folder given from outside, which takes minutes: in parts that can be
// run one by one.
#include <tuple>

#include <gtest/gtest.h>

#include "similar_meshes.hpp"

namespace surpass {
namespace {

constexpr std::size_t kParts = 4;

class GivenMeshesBySimilarity
    : public testing::TestWithParam<std::tuple<const char*, std::size_t>> {};

TEST_P(GivenMeshesBySimilarity, AreInterpolated) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  const auto [folder, part] = GetParam();
  const auto all = test::real_meshes(folder);
  std::vector<std::string> paths;
  for (std::size_t k = part; k < all.size(); k += kParts) paths.push_back(all[k]);
  // The rest is refused, and not manifold.
  EXPECT_GE(10 * test::interpolated_by_similarity(paths), 6 * static_cast<int>(paths.size()));
  EXPECT_GE(paths.size(), 10U);
}

INSTANTIATE_TEST_SUITE_P(Triangles, GivenMeshesBySimilarity,
                         testing::Combine(testing::Values("tri"),
                                          testing::Range<std::size_t>(0, kParts)));
INSTANTIATE_TEST_SUITE_P(Polygons, GivenMeshesBySimilarity,
                         testing::Combine(testing::Values("quad"),
                                          testing::Range<std::size_t>(0, kParts)));

}  // namespace
}  // namespace surpass

// The fuzzers' entry point without a fuzzer: the committed corpus as it stands, cut off everywhere,
// and with bytes changed.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "fuzz/parse.hpp"

namespace surpass {
namespace {

namespace fs = std::filesystem;

struct Seed {
  std::string name;
  std::string bytes;
};

std::vector<Seed> corpus() {
  std::vector<Seed> seeds;
  for (const auto& entry : fs::directory_iterator(SURPASS_FUZZ_CORPUS)) {
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    seeds.push_back({entry.path().filename().string(), bytes.str()});
  }
  std::sort(seeds.begin(), seeds.end(),
            [](const Seed& a, const Seed& b) { return a.name < b.name; });
  return seeds;
}

TEST(Fuzz, CorpusAsEveryFormat) {
  const std::vector<Seed> seeds = corpus();
  ASSERT_GE(seeds.size(), 13U);
  for (const Seed& seed : seeds) {
    for (const Format format :
         {Format::automatic, Format::obj, Format::ply, Format::off, Format::stl, Format::xyz}) {
      EXPECT_EQ(complaint_about(seed.bytes, format), "") << seed.name << " as " << name_of(format);
    }
  }
}

TEST(Fuzz, CorpusCutOffAnywhere) {
  for (const Seed& seed : corpus()) {
    const Format format = format_of_path(seed.name);
    for (std::size_t size = 0; size < seed.bytes.size(); ++size) {
      EXPECT_EQ(complaint_about(seed.bytes.substr(0, size), format), "")
          << seed.name << " cut off after " << size;
    }
  }
}

TEST(Fuzz, CorpusWithBytesChanged) {
  constexpr int kTries = 2000;
  constexpr std::string_view kLikely("0129-+./#\\ \t\r\n\0\x7F\xFFvfe", 20);
  std::mt19937 random(1);
  for (const Seed& seed : corpus()) {
    const Format format = format_of_path(seed.name);
    for (int k = 0; k < kTries; ++k) {
      std::string bytes = seed.bytes;
      for (auto changes = 1 + random() % 4; changes > 0; --changes) {
        bytes[random() % bytes.size()] = kLikely[random() % kLikely.size()];
      }
      ASSERT_EQ(complaint_about(bytes, format), "") << seed.name << ", try " << k << ":\n" << bytes;
    }
  }
}

}  // namespace
}  // namespace surpass

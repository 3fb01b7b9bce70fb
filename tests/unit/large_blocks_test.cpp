// The program's store of large blocks. The source is a mapping of the system's whose pages are
// counted, so that what is held is known from elsewhere than the store.
#include "large_blocks.hpp"

#include <algorithm>
#include <cstring>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mman.h>

namespace surpass::cli {
namespace {

constexpr std::size_t kMega = std::size_t{1} << 20;
constexpr std::size_t kHuge = LargeBlocks::kHugePage;

// What is mapped, page by page, and what the source does when asked.
struct Pages {
  std::set<char*> mapped;  // every page
  std::size_t limit = ~std::size_t{0};
  bool may_move = true;
  std::size_t moves = 0;
  std::size_t maps = 0;

  [[nodiscard]] std::size_t bytes() const { return mapped.size() * LargeBlocks::kPage; }
};
Pages kept_pages;  // the source is plain functions

template <class Use>
void for_each_page(void* begin, std::size_t bytes, Use&& use) {
  for (std::size_t at = 0; at < bytes; at += LargeBlocks::kPage)
    use(static_cast<char*>(begin) + at);
}

void* map(std::size_t bytes) {
  EXPECT_EQ(bytes % LargeBlocks::kPage, 0U);
  if (kept_pages.bytes() + bytes > kept_pages.limit) return nullptr;
  ++kept_pages.maps;
  void* begin = system_pages().map(bytes);
  for_each_page(begin, bytes,
                [](char* page) { EXPECT_TRUE(kept_pages.mapped.insert(page).second); });
  return begin;
}

void unmap(void* begin, std::size_t bytes) {
  for_each_page(begin, bytes, [](char* page) { EXPECT_EQ(kept_pages.mapped.erase(page), 1U); });
  system_pages().unmap(begin, bytes);
}

bool move(void* from, std::size_t bytes, void* to) {
  if (!kept_pages.may_move) return false;
  ++kept_pages.moves;
  for_each_page(to, bytes, [](char* page) { EXPECT_TRUE(kept_pages.mapped.contains(page)); });
  for_each_page(from, bytes, [](char* page) { EXPECT_EQ(kept_pages.mapped.erase(page), 1U); });
  const bool moved = system_pages().move(from, bytes, to);
  EXPECT_TRUE(moved);
  return moved;
}

class LargeBlocksTest : public testing::Test {
 protected:
  void SetUp() override { kept_pages = {}; }
  void TearDown() override {
    store_.give_back();
    EXPECT_EQ(store_.figures().used, 0U);
    EXPECT_EQ(kept_pages.bytes(), 0U);
  }

  // Written all over, so that a page that is not there would be noticed.
  unsigned char* take(std::size_t size, unsigned char with = 1) {
    auto* block = static_cast<unsigned char*>(store_.allocate(size, 16));
    if (block == nullptr) return nullptr;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % kHuge, 0U);
    EXPECT_TRUE(LargeBlocks::may_be(block));
    std::memset(block, with, size);
    expect_bound();
    return block;
  }
  void drop(unsigned char* block) {
    EXPECT_TRUE(store_.free(block));
    expect_bound();
  }
  void expect_bound() const {
    const LargeBlocks::Figures figures = store_.figures();
    EXPECT_EQ(figures.used + figures.kept, kept_pages.bytes());
    EXPECT_LE(figures.used + figures.kept, figures.most);
  }

  LargeBlocks store_{{map, unmap, move}};
};

TEST_F(LargeBlocksTest, AFreedBlockServesTheNext) {
  unsigned char* first = take(10 * kMega, 7);
  drop(first);
  unsigned char* second = take(10 * kMega - 5, 7);
  EXPECT_EQ(second, first);
  EXPECT_EQ(kept_pages.maps, 1U);
  drop(second);
}

TEST_F(LargeBlocksTest, ALargeBlockServesSeveralSmallerOnesAndBack) {
  unsigned char* large = take(24 * kMega);
  drop(large);
  std::vector<unsigned char*> parts;
  for (int k = 0; k < 4; ++k) parts.push_back(take(6 * kMega));
  EXPECT_EQ(kept_pages.maps, 1U);
  for (unsigned char* part : parts) {
    EXPECT_GE(part, large);
    EXPECT_LT(part, large + 24 * kMega);
    drop(part);
  }
  EXPECT_EQ(take(24 * kMega), large);
  EXPECT_EQ(kept_pages.maps, 1U);
  drop(large);
}

TEST_F(LargeBlocksTest, SmallPiecesMoveIntoALargerBlock) {
  std::vector<unsigned char*> parts;
  for (int k = 0; k < 6; ++k) parts.push_back(take(5 * kMega + 4096));
  for (unsigned char* part : parts) drop(part);
  unsigned char* large = take(25 * kMega, 9);
  EXPECT_GT(kept_pages.moves, 0U);
  EXPECT_TRUE(std::all_of(large, large + 25 * kMega, [](unsigned char c) { return c == 9; }));
  drop(large);
}

TEST_F(LargeBlocksTest, PagesOfAMovedBlockMoveAgain) {
  std::vector<unsigned char*> parts;
  for (int k = 0; k < 6; ++k) parts.push_back(take(4 * kMega));
  for (unsigned char* part : parts) drop(part);
  for (const std::size_t size : {10 * kMega, 18 * kMega, 23 * kMega}) drop(take(size));
  EXPECT_GT(kept_pages.moves, 3U);
}

TEST_F(LargeBlocksTest, WithoutMovingEverythingIsFresh) {
  kept_pages.may_move = false;
  unsigned char* a = take(4 * kMega);
  unsigned char* b = take(4 * kMega);
  drop(a);
  drop(b);
  unsigned char* c = take(8 * kMega + 1);
  ASSERT_NE(c, nullptr);
  drop(c);
}

TEST_F(LargeBlocksTest, NothingIsKeptBeyondTheMostThatWasUsed) {
  unsigned char* a = take(8 * kMega);
  drop(a);
  EXPECT_EQ(store_.figures().kept, 8 * kMega);
  unsigned char* b = take(12 * kMega);  // more than what is kept
  EXPECT_EQ(store_.figures().most, 12 * kMega);
  EXPECT_EQ(store_.figures().kept, 0U);
  drop(b);
}

TEST_F(LargeBlocksTest, WhereMemoryEndsWhatIsKeptIsGivenBackFirst) {
  kept_pages.limit = 32 * kMega;
  unsigned char* a = take(20 * kMega);
  unsigned char* b = take(6 * kMega);
  drop(a);
  unsigned char* c = take(22 * kMega);  // only if the 20 are given back before
  ASSERT_NE(c, nullptr);
  EXPECT_EQ(store_.allocate(16 * kMega, 16), nullptr);
  EXPECT_EQ(store_.allocate(~std::size_t{0}, 16), nullptr);
  expect_bound();
  drop(b);
  drop(c);
}

TEST_F(LargeBlocksTest, WhatIsNotItsOwnIsNotFreed) {
  unsigned char* block = take(3 * kMega);
  EXPECT_FALSE(store_.free(block + kHuge));
  int other = 0;
  EXPECT_FALSE(store_.free(&other));
  drop(block);
  EXPECT_FALSE(store_.free(block));
}

TEST_F(LargeBlocksTest, LargerAlignmentsAreKept) {
  drop(take(16 * kMega));
  void* block = store_.allocate(3 * kMega, 4 * kHuge);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % (4 * kHuge), 0U);
  EXPECT_TRUE(store_.free(block));
  expect_bound();
}

TEST_F(LargeBlocksTest, BlocksInUseNeverMeet) {
  std::mt19937 random(11);
  struct Block {
    unsigned char* begin;
    std::size_t size;
    unsigned char with;
  };
  std::vector<Block> used;
  const auto holds = [](const Block& b) {
    return std::all_of(b.begin, b.begin + b.size, [&](unsigned char c) { return c == b.with; });
  };
  for (int round = 0; round < 600; ++round) {
    if (used.size() < 6 && random() % 2 == 0) {
      const std::size_t size = kHuge + random() % (9 * kMega);
      const auto with = static_cast<unsigned char>(round);
      used.push_back({take(size, with), size, with});
    } else if (!used.empty()) {
      std::swap(used[random() % used.size()], used.back());
      ASSERT_TRUE(holds(used.back()));
      drop(used.back().begin);
      used.pop_back();
    }
  }
  for (const Block& block : used) {
    EXPECT_TRUE(holds(block));
    drop(block.begin);
  }
  EXPECT_GT(kept_pages.moves, 0U);
}

TEST(LargeBlocks, ThreadsShareThem) {
  LargeBlocks store(system_pages());
  std::vector<std::size_t> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    threads.emplace_back([&, k] {
      std::mt19937 random(static_cast<unsigned>(k));
      for (int round = 0; round < 100; ++round) {
        const std::size_t size = kHuge + random() % (3 * kMega);
        auto* block = static_cast<unsigned char*>(store.allocate(size, 16));
        std::memset(block, static_cast<int>(k), size);
        wrong[k] += static_cast<std::size_t>(
            std::count_if(block, block + size, [&](unsigned char c) { return c != k; }));
        wrong[k] += store.free(block) ? 0U : 1U;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<std::size_t>(4, 0));
  EXPECT_EQ(store.figures().used, 0U);
  store.give_back();
}

}  // namespace
}  // namespace surpass::cli

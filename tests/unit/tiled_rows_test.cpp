// Rows in tiles, against the plain ones: the same bits.
#include "scheme/tiled_rows.hpp"

#include <array>
#include <cstring>

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace surpass::test {
namespace {

struct Row {
  std::vector<Index> columns;
  std::vector<double> weights;
};

// Lengths from 0 to beyond the longest that has a kernel of its own; a few lists of weights for
// each length, among them some that differ in their last number only.
std::vector<Row> random_rows(std::size_t count, Index columns, std::mt19937_64& random) {
  std::vector<Row> rows(count);
  for (Row& row : rows) {
    const std::size_t length = random() % 8 == 0 ? random() % 40 : 3 + random() % 5;
    for (std::size_t k = 0; k < length; ++k) {
      row.columns.push_back(static_cast<Index>(random() % columns));
      row.weights.push_back(1.0 / static_cast<double>(length + k));
    }
    if (length > 0) row.weights.back() += 0.1 * static_cast<double>(random() % 3);
  }
  return rows;
}

TiledRows tiled(const std::vector<Row>& rows, int threads) {
  TiledRows made;
  make_rows({.threads = threads}, static_cast<Index>(rows.size()), made,
            [&](Index i, RowTile& tile) {
              const auto [columns, weights] = tile.add_row(rows[i].columns.size());
              std::copy(rows[i].columns.begin(), rows[i].columns.end(), columns.begin());
              std::copy(rows[i].weights.begin(), rows[i].weights.end(), weights.begin());
            });
  return made;
}

TEST(TiledRows, HaveTheBitsOfPlainRows) {
  constexpr Index kColumns = 500;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const std::size_t count : std::array<std::size_t, 5>{0, 1, kTile, kTile + 1, 9000}) {
    const auto rows = random_rows(count, kColumns, random);
    for (const std::size_t width : std::array<std::size_t, 6>{1, 2, 3, 4, 5, 9}) {
      std::vector<double> x(kColumns * width);
      for (double& value : x) value = uniform(random);
      x[1] = 0, x[kColumns / 2] = -0.0;
      std::vector<double> expected(count * width);
      for (std::size_t i = 0; i < count; ++i) {
        RowView{rows[i].columns, rows[i].weights.data()}.times(
            width, x.data(), [&](std::size_t c, double s) { expected[i * width + c] = s; });
      }
      for (const int threads : {1, 3}) {
        std::vector<double> found(count * width, 7.0);
        tiled(rows, threads).apply({.threads = threads}, width, x, found);
        const bool same =
            count == 0 || std::memcmp(found.data(), expected.data(),
                                      count * width * sizeof(double)) == 0;  // bits: -0 is not 0
        EXPECT_TRUE(same) << count << " rows, width " << width;
      }
    }
  }
}

TEST(RowTile, ARowCanEndEarly) {
  RowTile tile;
  for (int pass = 0; pass < 2; ++pass) {
    tile.clear();
    for (const Index length : {5U, 1U, 100U}) {
      const auto [columns, weights] = tile.add_row(length);
      for (Index k = 0; k < length; ++k) columns[k] = k, weights[k] = 1.0 + length;
      if (length == 5) tile.shorten_row(2);
    }
    ASSERT_EQ(3U, tile.row_count());
    EXPECT_EQ(2U, tile.row(0).columns.size());
    EXPECT_EQ(6.0, tile.row(0).weights[1]);
    EXPECT_EQ(2.0, tile.row(1).weights[0]);
    EXPECT_EQ(99U, tile.row(2).columns[99]);
    EXPECT_EQ(101.0, tile.row(2).weights[99]);
  }
}

}  // namespace
}  // namespace surpass::test

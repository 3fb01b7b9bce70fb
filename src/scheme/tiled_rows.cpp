#include "scheme/tiled_rows.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <utility>

#include "scheme/weight_lists.hpp"

namespace surpass {
namespace {

// Rows up to that long have a kernel of their own; longer ones are rare.
constexpr std::size_t kLongest = 16;

// Two values, which all processors that we know multiply and add at once.
using Pair [[gnu::vector_size(16)]] = double;

Pair load(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}

// Where the run's entries, places and values begin.
struct Cursor {
  const Index* columns;
  const std::uint16_t* order;
  const double* weights;
  const double* x;
  double* y;  // of the tile
};

// kLength is the rows' length, or 0 for any.
template <std::size_t kWidth, std::size_t kLength>
void multiply(const TiledRows::Run& run, const Cursor& at) {
  constexpr std::size_t kPairs = kWidth / 2;
  const std::size_t length = kLength != 0 ? kLength : run.length;
  std::array<double, kLength> kept;  // in registers
  for (std::size_t k = 0; k < kLength; ++k) kept[k] = at.weights[k];
  const Index* columns = at.columns;
  for (Index i = 0; i < run.rows; ++i, columns += length) {
    std::array<Pair, kPairs> pairs = {};
    double last = 0;
    for (std::size_t k = 0; k < length; ++k) {
      const double weight = kLength != 0 ? kept[kLength != 0 ? k : 0] : at.weights[k];
      const double* const values = at.x + kWidth * columns[k];
      for (std::size_t c = 0; c < kPairs; ++c) pairs[c] += weight * load(values + 2 * c);
      if constexpr (kWidth % 2 != 0) last += weight * values[kWidth - 1];
    }
    double* const y = at.y + kWidth * at.order[i];
    if constexpr (kPairs != 0) std::memcpy(y, pairs.data(), sizeof pairs);
    if constexpr (kWidth % 2 != 0) y[kWidth - 1] = last;
  }
}

template <std::size_t kWidth>
void multiply_run(const TiledRows::Run& run, const Cursor& at) {
  using Kernel = void (*)(const TiledRows::Run&, const Cursor&);
  static constexpr auto kKernels = []<std::size_t... kLengths>(std::index_sequence<kLengths...>) {
    return std::array<Kernel, sizeof...(kLengths)>{multiply<kWidth, kLengths>...};
  }
  (std::make_index_sequence<kLongest + 1>());
  kKernels[run.length <= kLongest ? run.length : 0](run, at);
}

void multiply_any_width(const TiledRows::Run& run, std::size_t width, const Cursor& at) {
  for (Index i = 0; i < run.rows; ++i) {
    const RowView row{{at.columns + i * run.length, run.length}, at.weights};
    double* const y = at.y + width * at.order[i];
    row.times(width, at.x, [&](std::size_t c, double product) { y[c] = product; });
  }
}

void multiply_tile(const TiledRows::Tile& tile, std::size_t width, const double* x, double* y) {
  Cursor at{tile.columns.data(), tile.order.data(), nullptr, x, y};
  for (const TiledRows::Run& run : tile.runs) {
    at.weights = tile.weights.data() + run.weights;
    switch (width) {
      case 1: multiply_run<1>(run, at); break;
      case 2: multiply_run<2>(run, at); break;
      case 3: multiply_run<3>(run, at); break;
      case 4: multiply_run<4>(run, at); break;
      default: multiply_any_width(run, width, at);
    }
    at.columns += std::size_t{run.rows} * run.length;
    at.order += run.rows;
  }
}

}  // namespace

void TiledRows::expect(Index rows) {
  row_count_ = rows;
  tiles_.resize((std::size_t{rows} + kTile - 1) / kTile);
}

void TiledRows::take(Index first, const RowTile& rows) {
  Tile& tile = tiles_[first / kTile];
  const Index count = rows.row_count();
  WeightLists lists;
  std::vector<Index> list(count);
  for (Index i = 0; i < count; ++i) {
    const RowView row = rows.row(i);
    list[i] = lists.number_of({row.weights, row.columns.size()});
  }
  const auto length = [&](Index i) { return rows.row(i).columns.size(); };
  tile.order.resize(count);
  std::iota(tile.order.begin(), tile.order.end(), std::uint16_t{0});
  std::sort(tile.order.begin(), tile.order.end(), [&](std::uint16_t a, std::uint16_t b) {
    return std::tuple(length(a), list[a], a) < std::tuple(length(b), list[b], b);
  });
  Index before = kNone;  // list of the row before
  for (const std::uint16_t i : tile.order) {
    const auto columns = rows.row(i).columns;
    if (list[i] != before) {
      tile.runs.push_back({0, static_cast<Index>(columns.size()), lists.start(list[i])});
    }
    before = list[i];
    ++tile.runs.back().rows;
    tile.columns.insert(tile.columns.end(), columns.begin(), columns.end());
  }
  tile.weights = std::move(lists).take_weights();
}

void TiledRows::apply(const Context& context, std::size_t width, std::span<const double> x,
                      std::span<double> y) const {
  parallel::for_ranges(context, row_count_, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; begin += kTile) {
      multiply_tile(tiles_[begin / kTile], width, x.data(), y.data() + width * begin);
    }
  });
}

}  // namespace surpass

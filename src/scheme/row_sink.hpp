// Rows of weights that are handed on as they are made, a tile at a time, so that nobody has to keep
// more of them than the nearest cache holds.
#pragma once

#include <surpass/context.hpp>

#include <algorithm>
#include <vector>

#include "parallel/parallel.hpp"
#include "scheme/row_product.hpp"

namespace surpass {

/// Rows a tile. It divides a chunk of threads' work.
inline constexpr Index kTile = 1024;
static_assert(parallel::kChunk % kTile == 0);

/// Consecutive rows.
class RowTile {
 public:
  void clear() {
    starts_.resize(1);
    used_ = 0;
  }

  /// Room for the entries of one more row; what was given by the call before is no longer valid.
  struct Room {
    std::span<Index> columns;
    std::span<double> weights;
  };
  Room add_row(std::size_t length) {
    if (used_ + length > columns_.size()) {
      columns_.resize(2 * (used_ + length));
      weights_.resize(columns_.size());
    }
    const Room room{{columns_.data() + used_, length}, {weights_.data() + used_, length}};
    used_ += length;
    starts_.push_back(static_cast<Index>(used_));
    return room;
  }
  /// The row that was added last ends after `length` entries.
  void shorten_row(std::size_t length) {
    used_ = starts_[starts_.size() - 2] + length;
    starts_.back() = static_cast<Index>(used_);
  }

  [[nodiscard]] Index row_count() const { return static_cast<Index>(starts_.size() - 1); }
  [[nodiscard]] RowView row(Index i) const {
    return {{columns_.data() + starts_[i], columns_.data() + starts_[i + 1]},
            weights_.data() + starts_[i]};
  }

 private:
  std::vector<Index> starts_ = {0};
  std::vector<Index> columns_;  // used_ of them count
  std::vector<double> weights_;
  std::size_t used_ = 0;
};

/// Who receives rows.
class RowSink {
 public:
  virtual ~RowSink() = default;

  /// So many rows will come.
  virtual void expect(Index rows) = 0;
  /// Rows `first` and following; `first` is a multiple of kTile. Called once for each tile, in any
  /// order and from several threads at once.
  virtual void take(Index first, const RowTile& rows) = 0;

 protected:
  RowSink() = default;
  RowSink(const RowSink&) = default;
  RowSink(RowSink&&) = default;
  RowSink& operator=(const RowSink&) = default;
  RowSink& operator=(RowSink&&) = default;
};

/// write(i, tile) adds row i to the tile, for i from 0 to n.
template <class Write>
void make_rows(const Context& context, Index n, RowSink& sink, Write&& write) {
  sink.expect(n);
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    RowTile tile;
    for (std::size_t first = begin; first < end; first += kTile) {
      tile.clear();
      for (std::size_t i = first; i < std::min(end, first + kTile); ++i) {
        write(static_cast<Index>(i), tile);
      }
      sink.take(static_cast<Index>(first), tile);
    }
  });
}

}  // namespace surpass

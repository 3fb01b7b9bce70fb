#include "interpolate/ordered_rows.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace surpass {
namespace {

std::vector<std::uint16_t>& columns_of(OrderedRows& rows, std::uint16_t) { return rows.near; }
std::vector<Index>& columns_of(OrderedRows& rows, Index) { return rows.far; }

// Level after level, so that what is read to find the next one is still in the cache when the
// columns are written.
template <class Column>
class Orderer {
 public:
  Orderer(const SparseRows& rows, const std::vector<Index>& block)
      : rows_(rows),
        block_(block),
        waiting_(rows.row_count(), 0),
        place_(rows.row_count(), kNone),
        next_(rows.weights().size() + 1, 0) {}

  /// Nothing came of it, but something might with wider columns.
  [[nodiscard]] bool is_too_far() const { return is_too_far_; }

  std::optional<OrderedRows> run() {
    Index entries = 0;
    for (const Index v : block_) {
      waiting_[v] = 1;
      entries += rows_.row_length(v);
    }
    out_.row_count = static_cast<Index>(block_.size());
    out_.weights = rows_.weights();
    out_.vertices.reserve(block_.size());
    columns_.reserve(entries);
    // A part that is not connected to what was reached starts with a level of its own.
    for (const Index seed : block_) {
      if (waiting_[seed] != 0 && !order_from(seed)) return std::nullopt;
    }
    out_.vertices.insert(out_.vertices.end(), known_.begin(), known_.end());
    return std::move(out_);
  }

 private:
  // Rows ahead of the one at work for which memory is asked: their places in it look random.
  static constexpr Index kAhead = 16;
  // Rows that are sorted at a time. A run of equal weights goes through all of the places that its
  // piece looks at, so these are few enough to stay in the nearest cache from one run to the next.
  static constexpr std::size_t kPiece = 1024;
  static constexpr bool kNear = sizeof(Column) < sizeof(Index);
  struct Row {
    Index vertex;
    Index weights;
  };
  struct Level {
    Index begin;
    Index end;
    std::size_t first_run;
  };

  bool order_from(Index seed) {
    const Index start = placed();
    waiting_[seed] = 0;
    next_level_.assign(1, seed);
    Level before{last_level_, start, 0};
    for (Level level = place_level(); level.begin < level.end;) {
      find_neighbours();
      const Level next = place_level();
      if (!fill_columns(level, before.begin, next.end)) return false;
      before = level;
      last_level_ = level.begin;
      level = next;
    }
    return true;
  }

  [[nodiscard]] Index placed() const { return static_cast<Index>(out_.vertices.size()); }

  // In the order in which the level itself was found, so that rows near each other stay so. Whether
  // a neighbour still waits cannot be foreseen, so each is written and only some are counted.
  void find_neighbours() {
    std::size_t found = 0;
    for (std::size_t i = 0; i < level_.size(); ++i) {
      if (i + 2 * kAhead < level_.size()) rows_.prefetch_row(level_[i + 2 * kAhead]);
      if (i + kAhead < level_.size()) rows_.prefetch_columns(level_[i + kAhead]);
      const std::span<const Index> columns = rows_.row_columns(level_[i]);
      if (next_level_.size() < found + columns.size())
        next_level_.resize(2 * (found + columns.size()));
      Index* next = next_level_.data();
      for (const Index w : columns) {
        next[found] = w;
        found += waiting_[w];
        waiting_[w] = 0;
      }
    }
    next_level_.resize(found);
  }

  // Gives places to what was reached.
  Level place_level() {
    level_.swap(next_level_);
    next_level_.clear();
    const Level level{placed(), placed() + static_cast<Index>(level_.size()), out_.runs.size()};
    if (level_.empty()) return level;
    out_.vertices.resize(level.end);
    for (std::size_t begin = 0; begin < level_.size(); begin += kPiece) {
      place_piece(level.begin + static_cast<Index>(begin),
                  std::span(level_).subspan(begin, std::min(kPiece, level_.size() - begin)));
    }
    out_.levels.push_back(static_cast<Index>(out_.runs.size()));
    return level;
  }

  // From place `end` on, sorted by weights by counting. Rows with equal weights stay in the order
  // in which they were found.
  void place_piece(Index end, std::span<const Index> piece) {
    sorted_.clear();
    lists_.clear();
    for (const Index v : piece) {
      const Index weights = rows_.weights_start(v);
      sorted_.push_back({v, weights});
      if (next_[weights]++ == 0) lists_.push_back({v, weights});
    }
    std::sort(lists_.begin(), lists_.end(),
              [](const Row& a, const Row& b) { return a.weights < b.weights; });
    for (const auto& [v, weights] : lists_) {
      const Index begin = std::exchange(end, end + next_[weights]);
      out_.runs.push_back({begin, end, rows_.row_length(v), weights, entries_, true,
                           weights_alike(rows_.row_weights(v))});
      entries_ += (end - begin) * rows_.row_length(v);
      next_[weights] = begin;
    }
    for (const auto& [v, weights] : sorted_) {
      place_[v] = next_[weights]++;
      out_.vertices[place_[v]] = v;
    }
    for (const Row& list : lists_) next_[list.weights] = 0;
  }

  // All that the level reads must be placed from `low` to `high`, or known.
  bool fill_columns(const Level& level, Index low, Index high) {
    std::size_t at = columns_.size();
    const Index origin = kNear ? low : 0;
    for (std::size_t r = level.first_run; r < out_.runs.size() && out_.runs[r].begin < level.end;
         ++r) {
      OrderedRows::Run& run = out_.runs[r];
      columns_.resize(at + std::size_t{run.end - run.begin} * run.length);
      for (Index i = run.begin; i < run.end; ++i) {
        prefetch_places(i, level.end);
        for (const Index w : rows_.row_columns(out_.vertices[i])) {
          if (place_[w] == kNone && !learn(w)) return false;
          const Index place = place_[w];
          if (place < out_.row_count && (place < low || place >= high)) return false;
          const Index column = (place - origin) * OrderedRows::kStride;
          if (kNear && column > std::numeric_limits<Column>::max()) return too_far();
          columns_[at++] = static_cast<Column>(column);
        }
        run.own_first &= rows_.row_columns(out_.vertices[i]).front() == out_.vertices[i];
      }
    }
    return true;
  }

  bool too_far() {
    is_too_far_ = true;
    return false;
  }

  // A row, its columns and their places lie in three different parts of memory. Inlined at once:
  // GCC takes a function that only asks for memory ahead for one that does nothing, and drops the
  // call.
  [[gnu::always_inline]] void prefetch_places(Index i, Index end) const {
    if (i + 3 * kAhead < end) rows_.prefetch_row(out_.vertices[i + 3 * kAhead]);
    if (i + 2 * kAhead < end) rows_.prefetch_columns(out_.vertices[i + 2 * kAhead]);
    if (i + kAhead >= end) return;
    for (const Index w : rows_.row_columns(out_.vertices[i + kAhead])) {
      __builtin_prefetch(&place_[w]);
    }
  }

  // A place for what is read and not owned.
  bool learn(Index w) {
    if (waiting_[w] != 0) return false;
    place_[w] = out_.row_count + static_cast<Index>(known_.size());
    known_.push_back(w);
    return true;
  }

  const SparseRows& rows_;
  const std::vector<Index>& block_;
  std::vector<unsigned char> waiting_;  // #V: 1 for those of the block that are not yet reached
  std::vector<Index> place_;            // #V
  std::vector<Index> known_;            // outside the block, in the order of their places
  std::vector<Index> level_;            // the newest, in the order in which it was found
  std::vector<Index> next_level_;
  std::vector<Row> sorted_;
  std::vector<Row> lists_;   // of each list of weights in the level, the row that was reached first
  std::vector<Index> next_;  // by start of weights: how many rows, then the place of the next one
  Index entries_ = 0;
  Index last_level_ = 0;  // where the last level begins that was filled
  bool is_too_far_ = false;
  OrderedRows out_;
  std::vector<Column>& columns_ = columns_of(out_, Column{});
};

}  // namespace

std::optional<OrderedRows> order_rows(const SparseRows& rows, const std::vector<Index>& block) {
  if (block.size() == rows.row_count()) {  // else there may be known values, which lie far away
    Orderer<std::uint16_t> orderer(rows, block);
    auto near = orderer.run();
    if (!orderer.is_too_far()) return near;
  }
  return Orderer<Index>(rows, block).run();
}

}  // namespace surpass

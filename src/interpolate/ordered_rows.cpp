#include "interpolate/ordered_rows.hpp"

#include <algorithm>

namespace surpass {
namespace {

// Level after level, so that what is read to find the next one is still in the cache when the
// columns are written.
class Orderer {
 public:
  Orderer(const SparseRows& rows, const std::vector<Index>& block)
      : rows_(rows),
        block_(block),
        waiting_(rows.row_count(), false),
        place_(rows.row_count(), kNone),
        next_(rows.weights().size() + 1, 0) {}

  std::optional<OrderedRows> run() {
    Index entries = 0;
    for (const Index v : block_) {
      waiting_[v] = true;
      entries += rows_.row_length(v);
    }
    out_.row_count = static_cast<Index>(block_.size());
    out_.weights = rows_.weights();
    out_.vertices.reserve(block_.size());
    out_.columns.reserve(entries);
    // A part that is not connected to what was reached starts with a level of its own.
    for (const Index seed : block_) {
      if (waiting_[seed] && !order_from(seed)) return std::nullopt;
    }
    out_.vertices.insert(out_.vertices.end(), known_.begin(), known_.end());
    return std::move(out_);
  }

 private:
  static constexpr Index kAhead = 8;
  struct Level {
    Index begin;
    Index end;
    std::size_t first_run;
  };

  struct Reached {
    Index vertex;
    Index weights;
  };

  bool order_from(Index seed) {
    Level before{0, 0, 0};
    before.begin = before.end = placed();
    reach(seed);
    for (Level level = finish_level(before.end); level.begin < level.end;) {
      find_neighbours(level);
      const Level next = finish_level(level.end);
      if (!fill_columns(level, before.begin, next.end)) return false;
      before = level;
      level = next;
    }
    return true;
  }

  [[nodiscard]] Index placed() const { return static_cast<Index>(out_.vertices.size()); }

  void reach(Index v) {
    waiting_[v] = false;
    rows_.prefetch_row(v);
    out_.vertices.push_back(v);
  }

  void find_neighbours(const Level& level) {
    for (Index i = level.begin; i < level.end; ++i) {
      if (i + 2 * kAhead < level.end) rows_.prefetch_row(out_.vertices[i + 2 * kAhead]);
      if (i + kAhead < level.end) rows_.prefetch_columns(out_.vertices[i + kAhead]);
      for (const Index w : rows_.row_columns(out_.vertices[i])) {
        if (waiting_[w]) reach(w);
      }
    }
  }

  // Sorts what was reached since `begin` by weights, by counting. Rows with equal weights keep
  // their order, so that vertices found one after the other stay near each other.
  Level finish_level(Index begin) {
    const Level level{begin, placed(), out_.runs.size()};
    if (level.begin == level.end) return level;
    reached_.clear();
    firsts_.clear();
    for (Index i = begin; i < level.end; ++i) {
      const Index v = out_.vertices[i];
      reached_.push_back({v, rows_.weights_start(v)});
      if (next_[reached_.back().weights]++ == 0) firsts_.push_back(v);
    }
    std::sort(firsts_.begin(), firsts_.end(),
              [&](Index v, Index w) { return rows_.weights_start(v) < rows_.weights_start(w); });
    for (const Index v : firsts_) {
      const Index weights = rows_.weights_start(v);
      const Index end = begin + next_[weights];
      out_.runs.push_back({begin, end, rows_.row_length(v), weights, entries_});
      entries_ += (end - begin) * rows_.row_length(v);
      next_[weights] = begin;
      begin = end;
    }
    for (const Reached& row : reached_) {
      const Index place = next_[row.weights]++;
      place_[row.vertex] = place;
      out_.vertices[place] = row.vertex;
    }
    for (const Index v : firsts_) next_[rows_.weights_start(v)] = 0;
    out_.levels.push_back(static_cast<Index>(out_.runs.size()));
    return level;
  }

  // All that the level reads must be placed from `low` to `high`, or known.
  bool fill_columns(const Level& level, Index low, Index high) {
    std::size_t at = out_.columns.size();
    for (std::size_t r = level.first_run; r < out_.runs.size() && out_.runs[r].begin < level.end;
         ++r) {
      const OrderedRows::Run& run = out_.runs[r];
      out_.columns.resize(at + std::size_t{run.end - run.begin} * run.length);
      for (Index i = run.begin; i < run.end; ++i) {
        if (i + 3 * kAhead < level.end) rows_.prefetch_row(out_.vertices[i + 3 * kAhead]);
        if (i + 2 * kAhead < level.end) rows_.prefetch_columns(out_.vertices[i + 2 * kAhead]);
        if (i + kAhead < level.end) {
          for (const Index w : rows_.row_columns(out_.vertices[i + kAhead]))
            __builtin_prefetch(&place_[w]);
        }
        for (const Index w : rows_.row_columns(out_.vertices[i])) {
          if (place_[w] == kNone && !learn(w)) return false;
          const Index place = place_[w];
          if (place < out_.row_count && (place < low || place >= high)) return false;
          out_.columns[at++] = place * OrderedRows::kStride;
        }
      }
    }
    return true;
  }

  // A place for what is read and not owned.
  bool learn(Index w) {
    if (waiting_[w]) return false;
    place_[w] = out_.row_count + static_cast<Index>(known_.size());
    known_.push_back(w);
    return true;
  }

  const SparseRows& rows_;
  const std::vector<Index>& block_;
  std::vector<bool> waiting_;     // #V: of the block, not yet reached
  std::vector<Index> place_;      // #V
  std::vector<Index> known_;      // outside the block, in the order of their places
  std::vector<Reached> reached_;  // of the level, in the order in which they were found
  std::vector<Index>
      firsts_;               // of each list of weights in the level, the row that was reached first
  std::vector<Index> next_;  // by start of weights: how many rows, then the place of the next one
  Index entries_ = 0;
  OrderedRows out_;
};

}  // namespace

std::optional<OrderedRows> order_rows(const SparseRows& rows, const std::vector<Index>& block) {
  return Orderer(rows, block).run();
}

}  // namespace surpass

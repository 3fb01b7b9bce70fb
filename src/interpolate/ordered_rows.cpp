#include "interpolate/ordered_rows.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <unordered_map>

namespace surpass {
namespace {

// Lists of weights, each kept once; compared bit by bit.
class Patterns {
 public:
  struct Pattern {
    Index length;
    Index weights;
  };

  explicit Patterns(std::vector<double>& weights) : weights_(weights) {}

  Index of(std::span<const double> row) {
    Recent& recent = recent_[slot_of(row)];
    if (recent.row.size() == row.size() &&
        std::memcmp(recent.row.data(), row.data(), row.size_bytes()) == 0) {
      return recent.number;
    }
    const std::string_view bytes(reinterpret_cast<const char*>(row.data()), row.size_bytes());
    const auto [at, added] = numbers_.try_emplace(bytes, static_cast<Index>(patterns_.size()));
    if (added) {
      patterns_.push_back({static_cast<Index>(row.size()), static_cast<Index>(weights_.size())});
      weights_.insert(weights_.end(), row.begin(), row.end());
    }
    recent = {row, at->second};
    return recent.number;
  }

  [[nodiscard]] std::size_t size() const { return patterns_.size(); }
  [[nodiscard]] const Pattern& operator[](Index number) const { return patterns_[number]; }

 private:
  // Most rows are like one that was seen shortly before, which saves hashing them.
  struct Recent {
    std::span<const double> row;
    Index number = 0;
  };
  static constexpr std::size_t kSlots = 256;
  static std::size_t slot_of(std::span<const double> row) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &row.back(), sizeof bits);
    return (row.size() + (bits >> 52) + (bits >> 20)) % kSlots;
  }

  std::vector<double>& weights_;
  std::vector<Pattern> patterns_;
  std::unordered_map<std::string_view, Index> numbers_;  // keys point into the given rows
  std::array<Recent, kSlots> recent_;
};

class Orderer {
 public:
  Orderer(const SparseRows& rows, const std::vector<Index>& block)
      : rows_(rows), block_(block), place_(rows.row_count(), kNone), patterns_(out_.weights) {}

  std::optional<OrderedRows> run() {
    out_.row_count = static_cast<Index>(block_.size());
    out_.vertices.reserve(block_.size());
    find_patterns();
    find_levels();
    make_runs();
    if (!fill_columns()) return std::nullopt;
    return std::move(out_);
  }

 private:
  static constexpr Index kWaiting = kNone - 1;  // of the block, not yet reached

  void find_patterns() {
    pattern_.resize(rows_.row_count());
    for (const Index v : block_) pattern_[v] = patterns_.of(rows_.row_weights(v));
  }

  // Breadth first; a part that is not connected to what was reached starts with a level of its own.
  void find_levels() {
    for (const Index v : block_) place_[v] = kWaiting;
    for (const Index seed : block_) {
      if (place_[seed] != kWaiting) continue;
      reach(seed);
      for (std::size_t at = out_.vertices.size() - 1; at < out_.vertices.size();) {
        level_starts_.push_back(static_cast<Index>(at));
        for (const std::size_t end = out_.vertices.size(); at < end; ++at) {
          for (const Index w : rows_.row_columns(out_.vertices[at])) {
            if (place_[w] == kWaiting) reach(w);
          }
        }
      }
    }
    level_starts_.push_back(out_.row_count);
  }

  void reach(Index v) {
    place_[v] = static_cast<Index>(out_.vertices.size());
    out_.vertices.push_back(v);
  }

  // Sorts each level by pattern, by counting; rows of a pattern keep their order, so that vertices
  // found one after the other stay near each other.
  void make_runs() {
    std::vector<Index> level;
    std::vector<Index> present;
    std::vector<Index> next(patterns_.size(), 0);  // per pattern: its number, then the next place
    Index entries = 0;
    for (std::size_t l = 0; l + 1 < level_starts_.size(); ++l) {
      const auto first = out_.vertices.begin() + level_starts_[l];
      level.assign(first, out_.vertices.begin() + level_starts_[l + 1]);
      present.clear();
      for (const Index v : level) {
        if (next[pattern_[v]]++ == 0) present.push_back(pattern_[v]);
      }
      std::sort(present.begin(), present.end());
      Index begin = level_starts_[l];
      for (const Index p : present) {
        const auto& [length, weights] = patterns_[p];
        const Index end = begin + next[p];
        out_.runs.push_back({begin, end, length, weights, entries});
        entries += (end - begin) * length;
        next[p] = begin;
        begin = end;
      }
      for (const Index v : level) {
        place_[v] = next[pattern_[v]]++;
        out_.vertices[place_[v]] = v;
      }
      for (const Index p : present) next[p] = 0;
      out_.levels.push_back(static_cast<Index>(out_.runs.size()));
    }
    out_.columns.reserve(entries);
  }

  bool fill_columns() {
    for (std::size_t l = 0; l + 1 < level_starts_.size(); ++l) {
      const Index low = level_starts_[l > 0 ? l - 1 : 0];
      const Index high = level_starts_[std::min(l + 2, level_starts_.size() - 1)];
      for (Index i = level_starts_[l]; i < level_starts_[l + 1]; ++i) {
        for (const Index w : rows_.row_columns(out_.vertices[i])) {
          if (place_[w] == kNone) reach(w);  // known: read, not owned
          const Index place = place_[w];
          if (place < out_.row_count && (place < low || place >= high)) return false;
          out_.columns.push_back(place * OrderedRows::kStride);
        }
      }
    }
    return true;
  }

  const SparseRows& rows_;
  const std::vector<Index>& block_;
  std::vector<Index> place_;         // #V
  std::vector<Index> pattern_;       // #V
  std::vector<Index> level_starts_;  // first row of each level, and the number of rows
  OrderedRows out_;
  Patterns patterns_;
};

}  // namespace

std::optional<OrderedRows> order_rows(const SparseRows& rows, const std::vector<Index>& block) {
  return Orderer(rows, block).run();
}

}  // namespace surpass

// The rows of a block, put into an order in which they are fast to sweep over.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scheme/sparse_rows.hpp"

namespace surpass {

/// Rows in breadth-first levels: each reads only its own level, the one before and the one after,
/// so a sweep can follow another at a distance of one level (see wavefront.hpp). Inside a level, or
/// a piece of a large one, rows with equal weights lie side by side: such a run shares one list of
/// weights, and its columns are all that has to be read of the operator.
struct OrderedRows {
  struct Run {
    Index begin;  ///< rows begin .. end
    Index end;
    Index length;    ///< entries a row
    Index weights;   ///< where its weights start in `weights`
    Index columns;   ///< where its first row's columns start
    bool own_first;  ///< the first entry of each row is its own place
    bool alike;      ///< all weights but the first are the same; see weights_alike
  };

  /// Columns are places times this: numbers in arrays of so many a place, ready to be added.
  static constexpr Index kStride = 3;

  std::vector<Run> runs;
  std::vector<Index> levels = {0};  ///< level l has the runs levels[l] .. levels[l + 1]
  /// Columns, row after row, each in the order of the given row; in `near` from the origin of the
  /// level on, which halves what has to be read, or, where that is too little, in `far` from 0 on.
  std::vector<std::uint16_t> near;
  std::vector<Index> far;
  std::vector<double> weights;
  /// Of each place: the rows' vertices, in their order, then those that rows read but do not own.
  std::vector<Index> vertices;
  Index row_count = 0;

  [[nodiscard]] std::size_t level_count() const { return levels.size() - 1; }
  [[nodiscard]] bool is_near() const { return far.empty(); }
  [[nodiscard]] Index level_begin(std::size_t level) const {
    return levels[level] < runs.size() ? runs[levels[level]].begin : row_count;
  }
  /// The place from which a level's columns count.
  [[nodiscard]] Index origin(std::size_t level) const {
    return is_near() && level > 0 ? level_begin(level - 1) : 0;
  }
};

/// Whether all weights of a row but the first are the same, as around a vertex of a Loop surface:
/// in sweeps of single precision they are multiplied once, with the sum of what they are for.
[[nodiscard]] inline bool weights_alike(std::span<const double> weights) {
  return weights.size() > 1 &&
         std::all_of(weights.begin() + 2, weights.end(), [&](double w) { return w == weights[1]; });
}

/// The rows of `block` (ascending). Nothing if some row reads farther than the neighbouring levels,
/// which rows that do not see each other mutually can. O(#entries), and sorting inside levels.
[[nodiscard]] std::optional<OrderedRows> order_rows(const SparseRows& rows,
                                                    const std::vector<Index>& block);

}  // namespace surpass

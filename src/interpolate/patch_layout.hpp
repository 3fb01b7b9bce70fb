// The patches of a mesh in chunks that have their own copies of the control points they need. What
// chunks add up is then added in an order that does not depend on the number of threads. Within a
// chunk, patches of one kind come together, several of them abreast.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "interpolate/lanes.hpp"
#include "parallel/parallel.hpp"
#include "scheme/patch_rows.hpp"

namespace surpass {

/// to = from, width numbers; three is what matters, and too few for a call.
inline void copy_numbers(const double* from, std::size_t width, double* to) {
  if (width == 3) {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  } else {
    std::copy_n(from, width, to);
  }
}

class PatchLayout {
 public:
  /// Patches a chunk.
  static constexpr std::size_t kPatches = 2048;

  /// `order`: of the patches; chunks are cut from it.
  PatchLayout(PatchRows rows, std::vector<Index> order, Index control_points);

  [[nodiscard]] const PatchRows& rows() const { return rows_; }
  [[nodiscard]] Index control_count() const { return control_points_; }

  /// A chunk of patches, in an order of its own.
  struct Chunk {
    std::span<const Index> patches;  ///< sorted by kind
    std::span<const Index> points;   ///< the control points that they need
    const Index* local;  ///< for the columns of each patch in turn, numbers among the points
    std::size_t own;     ///< so many of the points, the first ones, no other chunk needs

    /// The points' numbers (#control points by width) together.
    [[nodiscard]] std::vector<double> copy(std::size_t width, std::span<const double> x) const {
      std::vector<double> values(points.size() * width);
      for (std::size_t k = 0; k < points.size(); ++k) {
        copy_numbers(x.data() + points[k] * width, width, values.data() + k * width);
      }
      return values;
    }
  };

  /// Calls body(kind's number, local, lanes) for groups of up to kLanes patches of one kind: patch
  /// l of the group has its columns at local + l * columns of the kind.
  template <class Body>
  void for_groups(const Chunk& chunk, Body&& body) const {
    const Index* local = chunk.local;
    for (std::size_t i = 0; i < chunk.patches.size();) {
      const Index kind = rows_.kind_number(chunk.patches[i]);
      std::size_t lanes = 1;
      while (lanes < kLanes && i + lanes < chunk.patches.size() &&
             rows_.kind_number(chunk.patches[i + lanes]) == kind) {
        ++lanes;
      }
      body(kind, local, lanes);
      i += lanes;
      local += lanes * rows_.kinds()[kind].columns;
    }
  }

  /// y = the sum of what the chunks add up: work(chunk, values) finds `width` zeros for each of the
  /// chunk's points and adds to them. y: #control points by width.
  template <class Work>
  void add_up(const Context& context, std::size_t width, std::span<double> y, Work&& work) const {
    const auto shared = std::make_unique_for_overwrite<double[]>(places_.size() * width);
    for_chunks(context, [&](const Chunk& chunk, std::size_t number) {
      std::vector<double> values(chunk.points.size() * width, 0.0);
      work(chunk, std::span(values));
      for (std::size_t k = 0; k < chunk.own; ++k) {
        copy_numbers(values.data() + k * width, width, y.data() + chunk.points[k] * width);
      }
      std::copy(values.begin() + static_cast<std::ptrdiff_t>(chunk.own * width), values.end(),
                shared.get() + shared_[number] * width);
    });
    parallel::for_ranges(context, several_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double* to = y.data() + several_[i] * width;
        std::fill_n(to, width, 0.0);
        for (Index k = occurs_[i]; k < occurs_[i + 1]; ++k) {
          const double* from = shared.get() + std::size_t{places_[k]} * width;
          for (std::size_t c = 0; c < width; ++c) to[c] += from[c];
        }
      }
    });
  }

  /// Calls body(chunk, its number).
  template <class Body>
  void for_chunks(const Context& context, Body&& body) const {
    parallel::for_ranges(
        context, rows_.patch_count(),
        [&](std::size_t first, std::size_t last) {
          const std::size_t number = first / kPatches;
          const std::size_t at = chunks_[number];
          const Chunk chunk{std::span(order_).subspan(first, last - first),
                            std::span(points_).subspan(at, chunks_[number + 1] - at),
                            local_.data() + local_starts_[number],
                            chunks_[number + 1] - at - (shared_[number + 1] - shared_[number])};
          body(chunk, number);
        },
        kPatches);
  }

  /// The chunks' patches one after the other: combine(sum, part(chunk)).
  template <class T, class Part, class Combine>
  T reduce(const Context& context, T first, Part&& part, Combine&& combine) const {
    std::vector<T> parts(chunks_.size() - 1, first);
    for_chunks(context,
               [&](const Chunk& chunk, std::size_t number) { parts[number] = part(chunk); });
    for (const T& p : parts) first = combine(first, p);
    return first;
  }

 private:
  void number_points();
  void share_points();

  PatchRows rows_;
  Index control_points_;
  std::vector<Index> order_;               // the patches, those of each chunk sorted by kind
  std::vector<Index> points_;              // of each chunk, chunk after chunk; its own ones first
  std::vector<std::size_t> chunks_;        // where those of each start
  std::vector<Index> local_;               // of every column of every patch, in that order
  std::vector<std::size_t> local_starts_;  // where those of each chunk start
  std::vector<std::size_t> shared_;  // where the points of each chunk start that others need, too
  std::vector<Index> several_;       // control points of several chunks, or of none
  std::vector<Index> occurs_;        // where the places of each of these start
  std::vector<Index> places_;        // among the shared points of all chunks, ascending
};

}  // namespace surpass

// The patches of a mesh in chunks that have their own copies of the control points they need. What
// chunks add up is then added in an order that does not depend on the number of threads. Within a
// chunk, patches of one kind come together, four and four of them abreast.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "interpolate/lanes.hpp"
#include "parallel/parallel.hpp"
#include "scheme/patch_rows.hpp"

namespace surpass {

class PatchLayout {
 public:
  PatchLayout(PatchRows rows, Index control_points);

  [[nodiscard]] const PatchRows& rows() const { return rows_; }
  [[nodiscard]] Index control_count() const { return control_points_; }

  static constexpr std::size_t kLanes = Lanes::kCount;

  /// A chunk of patches, in an order of its own.
  struct Chunk {
    std::span<const Index> patches;  ///< sorted by kind
    std::span<const Index> points;   ///< the control points that they need
    const Index* local;  ///< for the columns of each patch in turn, numbers among the points
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
    std::vector<double> values(points_.size() * width, 0.0);
    for_chunks(context, [&](const Chunk& chunk, std::size_t number) {
      work(chunk, std::span(values).subspan(chunks_[number] * width, chunk.points.size() * width));
    });
    parallel::for_ranges(context, control_points_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) {
        std::fill_n(y.data() + j * width, width, 0.0);
        for (Index k = occurs_[j]; k < occurs_[j + 1]; ++k) {
          const double* from = values.data() + std::size_t{places_[k]} * width;
          for (std::size_t c = 0; c < width; ++c) y[j * width + c] += from[c];
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
                            local_.data() + rows_.columns_start(first)};
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
  static constexpr std::size_t kPatches = 512;

  PatchRows rows_;
  Index control_points_;
  std::vector<Index> order_;         // the patches of each chunk, sorted by kind
  std::vector<Index> points_;        // of each chunk, chunk after chunk
  std::vector<std::size_t> chunks_;  // where those of each start
  std::vector<Index> local_;         // of every column of every patch, in that order
  std::vector<Index> occurs_;        // where the places of each control point start
  std::vector<Index> places_;        // among points_, ascending
};

}  // namespace surpass

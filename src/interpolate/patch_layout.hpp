// The patches of a mesh in chunks that have their own copies of the control points they need. What
// chunks add up is then added in an order that does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "parallel/parallel.hpp"
#include "scheme/patch_rows.hpp"

namespace surpass {

class PatchLayout {
 public:
  PatchLayout(PatchRows rows, Index control_points, const Context& context);

  [[nodiscard]] const PatchRows& rows() const { return rows_; }
  [[nodiscard]] Index control_count() const { return control_points_; }

  /// A chunk of patches: [first, last), and for the columns of each the numbers of the control
  /// points among the `points` of the chunk.
  struct Chunk {
    std::size_t first;
    std::size_t last;
    std::span<const Index> points;
    const Index* local;  ///< of the first column of patch `first`, then on and on
  };

  /// y = the sum of what the chunks add up: work(chunk, values) finds `width` zeros for each of the
  /// chunk's points and adds to them. y: #control points by width.
  template <class Work>
  void add_up(const Context& context, std::size_t width, std::span<double> y, Work&& work) const {
    std::vector<double> values(points_.size() * width, 0.0);
    for_chunks(context, [&](const Chunk& chunk, std::size_t at) {
      work(chunk, std::span(values).subspan(at * width, chunk.points.size() * width));
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

  /// Calls body(chunk, number of its first point among those of all chunks).
  template <class Body>
  void for_chunks(const Context& context, Body&& body) const {
    parallel::for_ranges(
        context, rows_.patch_count(),
        [&](std::size_t first, std::size_t last) {
          const std::size_t number = first / kPatches;
          const std::size_t at = chunks_[number];
          const Chunk chunk{first, last, std::span(points_).subspan(at, chunks_[number + 1] - at),
                            local_.data() + rows_.columns_start(first)};
          body(chunk, at);
        },
        kPatches);
  }

  /// The chunks' patches one after the other: combine(sum, part(chunk)).
  template <class T, class Part, class Combine>
  T reduce(const Context& context, T first, Part&& part, Combine&& combine) const {
    std::vector<T> parts(chunks_.size() - 1, first);
    for_chunks(context, [&](const Chunk& chunk, std::size_t) {
      parts[chunk.first / kPatches] = part(chunk);
    });
    for (const T& p : parts) first = combine(first, p);
    return first;
  }

 private:
  static constexpr std::size_t kPatches = 512;

  PatchRows rows_;
  Index control_points_;
  std::vector<Index> points_;        // of each chunk, ascending, chunk after chunk
  std::vector<std::size_t> chunks_;  // where those of each start
  std::vector<Index> local_;         // of every column of every patch
  std::vector<Index> occurs_;        // where the places of each control point start
  std::vector<Index> places_;        // among points_, ascending
};

}  // namespace surpass

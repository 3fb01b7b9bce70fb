// The patches of a mesh in chunks that have their own copies of the control points they need. What
// chunks add up is then added in an order that does not depend on the number of threads. Within a
// chunk, patches of one kind come together, several of them abreast.
#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "interpolate/lane_points.hpp"
#include "parallel/parallel.hpp"
#include "scheme/patch_rows.hpp"

namespace surpass {

/// to = from, width numbers; three is what matters, and too few for a call.
template <class From, class To>
void copy_numbers(const From* from, std::size_t width, To* to) {
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
  /// A chunk ends with the patch with which it has so many columns. Its points are no more than
  /// these and those of a patch, so that 16 bits number them.
  static constexpr std::size_t kColumns = 32768;

  /// Memory is asked for so many points ahead: where they lie looks random to the processor.
  static constexpr std::size_t kAhead = 24;

  /// `order`: of the patches; chunks are cut from it.
  PatchLayout(PatchRows rows, std::vector<Index> order, Index control_points);

  /// Without their columns.
  [[nodiscard]] const PatchRows& rows() const { return rows_; }
  [[nodiscard]] Index control_count() const { return control_points_; }

  /// A chunk of patches, in an order of its own.
  struct Chunk {
    std::span<const Index> patches;  ///< sorted by kind
    std::span<const Index> points;   ///< the control points that they need
    const LocalIndex* local;  ///< for the columns of each patch in turn, numbers among the points
    std::size_t own;          ///< so many of the points, the first ones, no other chunk needs
    std::size_t start;        ///< of its points among those of all chunks

    /// The points' numbers (#control points by width) together, `stride` from one to the next.
    void copy_to(std::size_t width, std::size_t stride, std::span<const double> x,
                 double* values) const {
      for (std::size_t k = 0; k < points.size(); ++k, values += stride) {
        if (k + kAhead < points.size()) __builtin_prefetch(x.data() + points[k + kAhead] * width);
        copy_numbers(x.data() + points[k] * width, width, values);
        for (std::size_t c = width; c < stride; ++c) values[c] = 0;
      }
    }
  };

  /// The points of all chunks.
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }

  /// Calls body(kind's number, local, lanes) for groups of up to kMost patches of one kind: patch
  /// l of the group has its columns at local + l * columns of the kind.
  template <std::size_t kMost, class Body>
  void for_groups(const Chunk& chunk, Body&& body) const {
    const LocalIndex* local = chunk.local;
    for (std::size_t i = 0; i < chunk.patches.size();) {
      const Index kind = rows_.kind_number(chunk.patches[i]);
      std::size_t lanes = 1;
      while (lanes < kMost && i + lanes < chunk.patches.size() &&
             rows_.kind_number(chunk.patches[i + lanes]) == kind) {
        ++lanes;
      }
      body(kind, local, lanes);
      i += lanes;
      local += lanes * rows_.kinds()[kind].columns;
    }
  }

  /// y = the sum of what the chunks add up: work(chunk, values) finds `stride` zeros for each of
  /// the chunk's points, and adds to the first `width` of them. y: #control points by width. Back
  /// comes the sum of the numbers that work returns.
  template <class Real, class Sum, class Work>
  double add_up(const Context& context, std::size_t width, std::size_t stride, std::span<Sum> y,
                Work&& work) const {
    const auto shared = std::make_unique_for_overwrite<Real[]>(places_.size() * width);
    std::vector<double> parts(chunks_.size() - 1);
    for_chunks(context, [&](const Chunk& chunk, std::size_t number) {
      std::vector<Real> values(chunk.points.size() * stride, Real{0});
      parts[number] = work(chunk, std::span(values));
      const Real* from = values.data();
      for (std::size_t k = 0; k < chunk.own; ++k, from += stride) {
        if (k + kAhead < chunk.own) {
          __builtin_prefetch(y.data() + chunk.points[k + kAhead] * width, 1);
        }
        copy_numbers(from, width, y.data() + chunk.points[k] * width);
      }
      Real* to = shared.get() + shared_[number] * width;
      for (std::size_t k = chunk.own; k < chunk.points.size(); ++k, from += stride, to += width) {
        copy_numbers(from, width, to);
      }
    });
    parallel::for_ranges(context, several_.size(), [&](std::size_t begin, std::size_t end) {
      if (width == 3) {
        add_shared<3>(shared.get(), width, y.data(), begin, end);
      } else {
        add_shared<0>(shared.get(), width, y.data(), begin, end);
      }
    });
    return std::accumulate(parts.begin(), parts.end(), 0.0);
  }

  /// Calls use(patch, the control points of its columns), one patch after the other.
  template <class Use>
  void for_patches(Use&& use) const {
    const Context one_thread{.threads = 1};
    std::vector<Index> columns;
    for_chunks(one_thread, [&](const Chunk& chunk, std::size_t) {
      const LocalIndex* local = chunk.local;
      for (const Index patch : chunk.patches) {
        columns.clear();
        for (std::size_t c = 0; c < rows_.kind(patch).columns; ++c) {
          columns.push_back(chunk.points[*local++]);
        }
        use(patch, std::span<const Index>(columns));
      }
    });
  }

  /// Calls body(chunk, its number).
  template <class Body>
  void for_chunks(const Context& context, Body&& body) const {
    parallel::for_ranges(
        context, chunks_.size() - 1,
        [&](std::size_t number, std::size_t) { body(chunk_at(number), number); }, 1);
  }

  /// The chunks' patches one after the other: combine(sum, part(chunk)).
  template <class T, class Part, class Combine>
  T reduce(const Context& context, T first, Part&& part, Combine&& combine) const {
    return parallel::reduce(
        context, chunks_.size() - 1, first,
        [&](std::size_t number, std::size_t) { return part(chunk_at(number)); }, combine, 1);
  }

 private:
  [[nodiscard]] Chunk chunk_at(std::size_t number) const {
    const std::size_t first = patches_[number];
    const std::size_t at = chunks_[number];
    return {std::span(order_).subspan(first, patches_[number + 1] - first),
            std::span(points_).subspan(at, chunks_[number + 1] - at),
            local_.data() + local_starts_[number],
            chunks_[number + 1] - at - (shared_[number + 1] - shared_[number]), at};
  }

  // The sums of the points of several chunks, from `begin` to `end`; kWidth is 0 for any width.
  template <std::size_t kWidth, class Real, class Sum>
  void add_shared(const Real* shared, std::size_t any_width, Sum* y, std::size_t begin,
                  std::size_t end) const {
    const std::size_t width = kWidth == 0 ? any_width : kWidth;
    const Index last = occurs_[end];
    for (std::size_t i = begin; i < end; ++i) {
      Sum* to = y + several_[i] * width;
      Sum in_registers[kWidth == 0 ? 1 : kWidth];
      Sum* const sum = kWidth == 0 ? to : in_registers;
      for (std::size_t c = 0; c < width; ++c) sum[c] = 0;
      for (Index k = occurs_[i]; k < occurs_[i + 1]; ++k) {
        if (last - k > kAhead) __builtin_prefetch(shared + places_[k + kAhead] * width);
        const Real* from = shared + places_[k] * width;
        for (std::size_t c = 0; c < width; ++c) sum[c] += from[c];
      }
      for (std::size_t c = 0; c < kWidth; ++c) to[c] = sum[c];
    }
  }

  void cut();
  void number_points();
  void share_points();

  PatchRows rows_;
  Index control_points_;
  std::vector<Index> order_;               // the patches, those of each chunk sorted by kind
  std::vector<std::size_t> patches_;       // where those of each chunk start
  std::vector<Index> points_;              // of each chunk, chunk after chunk; its own ones first
  std::vector<std::size_t> chunks_;        // where those of each start
  std::vector<LocalIndex> local_;          // of every column of every patch, in that order
  std::vector<std::size_t> local_starts_;  // where those of each chunk start
  std::vector<std::size_t> shared_;  // where the points of each chunk start that others need, too
  std::vector<Index> several_;       // control points of several chunks, or of none
  std::vector<Index> occurs_;        // where the places of each of these start
  std::vector<Index> places_;        // among the shared points of all chunks, ascending
};

}  // namespace surpass

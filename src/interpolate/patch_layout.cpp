#include "interpolate/patch_layout.hpp"

namespace surpass {

PatchLayout::PatchLayout(PatchRows rows, std::vector<Index> order, Index control_points)
    : rows_(std::move(rows)), control_points_(control_points), order_(std::move(order)) {
  cut();
  number_points();
  rows_.forget_columns();
  share_points();
}

// Cuts the order into chunks, in each of which patches of a kind come together.
void PatchLayout::cut() {
  patches_ = {0};
  std::size_t columns = 0;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    columns += rows_.kind(order_[i]).columns;
    if (columns < kColumns && i + 1 < order_.size()) continue;
    std::stable_sort(order_.begin() + static_cast<std::ptrdiff_t>(patches_.back()),
                     order_.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     [&](Index a, Index b) { return rows_.kind_number(a) < rows_.kind_number(b); });
    patches_.push_back(i + 1);
    columns = 0;
  }
}

// The points of each chunk, in the order in which its patches meet them.
void PatchLayout::number_points() {
  local_.resize(rows_.column_count());
  points_.reserve(control_points_ + std::size_t{control_points_} / 3);  // about what grids need
  chunks_ = {0};
  std::vector<Index> number(control_points_, kNone);  // in the chunk at hand
  std::size_t at = 0;
  for (std::size_t c = 0; c + 1 < patches_.size(); ++c) {
    const std::size_t begin = points_.size();
    local_starts_.push_back(at);
    for (std::size_t i = patches_[c]; i < patches_[c + 1]; ++i) {
      for (const Index v : rows_.columns(order_[i])) {
        if (number[v] == kNone) {
          number[v] = static_cast<Index>(points_.size() - begin);
          points_.push_back(v);
        }
        local_[at++] = static_cast<LocalIndex>(number[v]);
      }
    }
    for (std::size_t k = begin; k < points_.size(); ++k) number[points_[k]] = kNone;
    chunks_.push_back(points_.size());
  }
  local_starts_.push_back(at);
}

// Points that one chunk alone needs come first in it: their sums need no place beside.
void PatchLayout::share_points() {
  constexpr Index kSeveral = 2;
  std::vector<unsigned char> uses(control_points_, 0);
  for (const Index v : points_) {
    uses[v] = static_cast<unsigned char>(std::min<Index>(kSeveral, uses[v] + Index{1}));
  }
  std::vector<Index> place(control_points_, kNone);  // among several_
  for (Index v = 0; v < control_points_; ++v) {
    if (uses[v] == 1) continue;
    place[v] = static_cast<Index>(several_.size());
    several_.push_back(v);
  }
  shared_ = {0};
  std::vector<Index> of_shared;  // places among several_
  std::vector<Index> moved;      // new numbers of a chunk's points
  std::vector<Index> sorted;
  for (std::size_t c = 0; c + 1 < chunks_.size(); ++c) {
    const std::span<Index> points =
        std::span(points_).subspan(chunks_[c], chunks_[c + 1] - chunks_[c]);
    moved.resize(points.size());
    sorted.clear();
    for (const bool own : {true, false}) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        if ((uses[points[k]] == 1) != own) continue;
        moved[k] = static_cast<Index>(sorted.size());
        sorted.push_back(points[k]);
        if (!own) of_shared.push_back(place[points[k]]);
      }
    }
    std::copy(sorted.begin(), sorted.end(), points.begin());
    shared_.push_back(of_shared.size());
    for (std::size_t k = local_starts_[c]; k < local_starts_[c + 1]; ++k) {
      local_[k] = static_cast<LocalIndex>(moved[local_[k]]);
    }
  }
  occurs_.assign(several_.size() + 1, 0);
  for (const Index i : of_shared) ++occurs_[i + 1];
  for (std::size_t i = 1; i < occurs_.size(); ++i) occurs_[i] += occurs_[i - 1];
  places_.resize(of_shared.size());
  std::vector<Index> next(occurs_.begin(), occurs_.end() - 1);
  for (std::size_t k = 0; k < of_shared.size(); ++k) {
    places_[next[of_shared[k]]++] = static_cast<Index>(k);
  }
}

}  // namespace surpass

#include "interpolate/patch_layout.hpp"

#include <numeric>

namespace surpass {

PatchLayout::PatchLayout(PatchRows rows, Index control_points)
    : rows_(std::move(rows)), control_points_(control_points) {
  const std::size_t patches = rows_.patch_count();
  order_.resize(patches);
  std::iota(order_.begin(), order_.end(), Index{0});
  local_.resize(rows_.column_count());
  chunks_ = {0};
  std::vector<Index> number(control_points, kNone);  // in the chunk at hand
  std::size_t at = 0;
  for (std::size_t first = 0; first < patches; first += kPatches) {
    const std::size_t last = std::min(patches, first + kPatches);
    std::stable_sort(order_.begin() + static_cast<std::ptrdiff_t>(first),
                     order_.begin() + static_cast<std::ptrdiff_t>(last),
                     [&](Index a, Index b) { return rows_.kind_number(a) < rows_.kind_number(b); });
    const std::size_t begin = points_.size();
    for (std::size_t i = first; i < last; ++i) {
      for (const Index v : rows_.columns(order_[i])) {
        if (number[v] == kNone) {
          number[v] = static_cast<Index>(points_.size() - begin);
          points_.push_back(v);
        }
        local_[at++] = number[v];
      }
    }
    for (std::size_t k = begin; k < points_.size(); ++k) number[points_[k]] = kNone;
    chunks_.push_back(points_.size());
  }
  occurs_.assign(std::size_t{control_points} + 1, 0);
  for (const Index v : points_) ++occurs_[v + 1];
  for (std::size_t j = 1; j < occurs_.size(); ++j) occurs_[j] += occurs_[j - 1];
  places_.resize(points_.size());
  std::vector<Index> next(occurs_.begin(), occurs_.end() - 1);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    places_[next[points_[k]]++] = static_cast<Index>(k);
  }
}

}  // namespace surpass

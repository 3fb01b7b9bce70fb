#include "interpolate/patch_layout.hpp"

namespace surpass {

PatchLayout::PatchLayout(PatchRows rows, Index control_points, const Context& context)
    : rows_(std::move(rows)), control_points_(control_points) {
  const std::size_t patches = rows_.patch_count();
  const std::size_t count = (patches + kPatches - 1) / kPatches;
  local_.resize(rows_.column_count());
  std::vector<std::vector<Index>> points(count);
  parallel::for_ranges(
      context, patches,
      [&](std::size_t first, std::size_t last) {
        std::vector<Index>& own = points[first / kPatches];
        for (std::size_t p = first; p < last; ++p) {
          const auto columns = rows_.columns(p);
          own.insert(own.end(), columns.begin(), columns.end());
        }
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        std::size_t at = rows_.columns_start(first);
        for (std::size_t p = first; p < last; ++p) {
          for (const Index v : rows_.columns(p)) {
            local_[at++] =
                static_cast<Index>(std::lower_bound(own.begin(), own.end(), v) - own.begin());
          }
        }
      },
      kPatches);
  chunks_ = {0};
  for (const auto& own : points) {
    points_.insert(points_.end(), own.begin(), own.end());
    chunks_.push_back(points_.size());
  }
  occurs_.assign(std::size_t{control_points} + 1, 0);
  for (const Index v : points_) ++occurs_[v + 1];
  for (std::size_t j = 1; j < occurs_.size(); ++j) occurs_[j] += occurs_[j - 1];
  places_.resize(points_.size());
  std::vector<Index> next(occurs_.begin(), occurs_.end() - 1);
  for (std::size_t k = 0; k < points_.size(); ++k)
    places_[next[points_[k]]++] = static_cast<Index>(k);
}

}  // namespace surpass

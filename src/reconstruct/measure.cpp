// How dense the points are, how far they scatter, and whether sheets lie close together.
#include <algorithm>
#include <cmath>

#include "reconstruct/cloud.hpp"
#include "reconstruct/local_fit.hpp"
#include "reconstruct/point_loop.hpp"

namespace surpass::reconstruction {
namespace {

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<double> spacing_of(const Cloud& cloud, const Neighbours& neighbours,
                          const Context& context) {
  constexpr std::size_t kNeighbours = 6;
  std::vector<double> means(cloud.points.size());
  const auto done =
      for_points(context, "spacing", means.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<Index> near;
        for (const Index i : neighbours.in_space().subspan(begin, end - begin)) {
          neighbours.nearest(i, kNeighbours, near);
          for (const Index j : near) means[i] += distance(cloud.points[i], cloud.points[j]);
          means[i] /= static_cast<double>(near.size());
        }
      });
  if (!done) return tl::make_unexpected(done.error());
  return median(std::move(means));
}

Result<Roughness> roughness_of(const Cloud& cloud, const Neighbours& neighbours, double spacing,
                               const Context& context) {
  constexpr std::size_t kSamples = 5000;
  // As many as reach 2.4 spacings far in a flat piece: a second sheet further away is not seen.
  constexpr std::size_t kNeighbours = 18;
  const std::size_t n = cloud.points.size();
  const std::size_t count = std::min(n, kSamples);
  std::vector<double> deviations(count);
  std::vector<double> gaps(count);
  const auto done = for_points(context, "noise", count, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> near;
    for (std::size_t k = begin; k < end; ++k) {
      const auto i = static_cast<Index>(k * n / count);
      neighbours.nearest(i, kNeighbours, near);
      gaps[k] = gap_between_sheets(cloud.points, i, near) / spacing;
      if (near.size() > 6) deviations[k] = fit_quadric(cloud.points, i, near).deviation / spacing;
    }
  });
  if (!done) return tl::make_unexpected(done.error());
  std::vector<double> at_single_sheets;
  std::vector<double> sheets;
  for (std::size_t k = 0; k < count; ++k) {
    // Less than half a spacing is scatter.
    (gaps[k] > 0.5 ? sheets : at_single_sheets).push_back(gaps[k] > 0.5 ? gaps[k] : deviations[k]);
  }
  Roughness found;
  found.noise = median(std::move(at_single_sheets));
  found.share_of_sheets = static_cast<double>(sheets.size()) / static_cast<double>(count);
  if (!sheets.empty()) found.sheet_gap = median(std::move(sheets));
  return found;
}

}  // namespace surpass::reconstruction

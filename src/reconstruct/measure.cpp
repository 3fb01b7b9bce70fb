// How dense the points are, how far they scatter, and whether sheets lie close together.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "reconstruct/cloud.hpp"
#include "reconstruct/local_fit.hpp"
#include "reconstruct/point_loop.hpp"
#include "reconstruct/sheets.hpp"

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

constexpr std::size_t kSamples = 5000;
// As many as reach 2.4 spacings far in a flat piece: a second sheet further away is not seen.
constexpr std::size_t kWide = 18;
// The eight around a point of a grid: what curvature does to them is a tenth of what it does to 18.
constexpr std::size_t kNear = 8;
// Where the neighbourhood is no small part of the cloud, curvature cannot be told from scatter, nor
// the far side from a second sheet.
constexpr std::size_t kLeastPoints = 10 * kWide;

struct Sample {
  std::optional<double> near;   // deviation from the quadric of the nearest few on the own sheet
  std::optional<double> wide;   // of all of them
  std::optional<double> sheet;  // distance to a second sheet
};

// The median of a standard deviation is a little below the true one: by the Wilson-Hilferty
// approximation of chi-squared's median.
double unbiased_deviation(std::span<const Point> points, Index i, std::span<const Index> near) {
  const double freedom = static_cast<double>(near.size()) + 1 - 6;
  return fit_quadric(points, i, near).deviation / std::pow(1 - 2 / (9 * freedom), 1.5);
}

Sample sample_at(std::span<const Point> points, Index i, std::span<const Index> near,
                 double spacing) {
  constexpr double kLeastSpace = 0.5;  // less is scatter
  const Sheets sheets = tell_sheets(points, i, near, kLeastSpace * spacing);
  Sample sample;
  sample.sheet = sheets.distance;
  if (sheets.own.size() < kNear) return sample;
  sample.near = unbiased_deviation(points, i, std::span(sheets.own).first(kNear));
  sample.wide = unbiased_deviation(points, i, sheets.own);
  return sample;
}

// Scatter is the same in both neighbourhoods, and steadier in the wide one. What curvature leaves
// behind a quadric falls off much faster than the neighbourhood does.
double noise_of(double near, double wide) {
  constexpr double kIsCurvature = 2.0 / 3;
  return near < kIsCurvature * wide ? near : wide;
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
  const std::size_t n = cloud.points.size();
  if (n < kLeastPoints) return Roughness();
  std::vector<Sample> samples(std::min(n, kSamples));
  const auto done =
      for_points(context, "noise", samples.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<Index> near;
        for (std::size_t k = begin; k < end; ++k) {
          const auto i = static_cast<Index>(k * n / samples.size());
          neighbours.nearest(i, kWide, near);
          samples[k] = sample_at(cloud.points, i, near, spacing);
        }
      });
  if (!done) return tl::make_unexpected(done.error());
  std::vector<double> near;
  std::vector<double> wide;
  std::vector<double> distances;
  for (const Sample& sample : samples) {
    if (sample.near) near.push_back(*sample.near / spacing);
    if (sample.wide) wide.push_back(*sample.wide / spacing);
    if (sample.sheet) distances.push_back(*sample.sheet / spacing);
  }
  Roughness found;
  found.share_of_sheets =
      static_cast<double>(distances.size()) / static_cast<double>(samples.size());
  if (!distances.empty()) found.sheet_gap = median(std::move(distances));
  if (!near.empty()) found.noise = noise_of(median(std::move(near)), median(std::move(wide)));
  return found;
}

}  // namespace surpass::reconstruction

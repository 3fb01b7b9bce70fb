// The reference surface in the size of the given points: Lai and Cheng 2006, section 2.1. They do
// not say about which point they stretch; the boxes are equal only if their centres are, too. The
// limit of the factors is ours: it keeps a side that the reference has almost lost, because the
// given points oscillate along it, from being blown up.
#include <algorithm>
#include <cmath>

#include "interpolate/similarity_prepared.hpp"

namespace surpass {
namespace {

constexpr double kLargestFactor = 8;
constexpr double kFlat = 1e-9;  // of the box's diagonal; shorter sides stay as they are

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  [[nodiscard]] double length() const { return high > low ? high - low : 0; }
  [[nodiscard]] double centre() const { return low / 2 + high / 2; }
};

double diagonal(const std::vector<Range>& ranges) {
  double sum = 0;
  for (const Range& range : ranges) sum += range.length() * range.length();
  return std::sqrt(sum);
}

std::vector<double> factors(const std::vector<Range>& limits, const std::vector<Range>& given,
                            bool isotropic) {
  const double shortest = kFlat * diagonal(given);
  std::vector<double> found(given.size(), 1.0);
  double logarithms = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < given.size(); ++c) {
    if (given[c].length() <= shortest || limits[c].length() <= shortest) continue;
    found[c] = std::min(given[c].length() / limits[c].length(), kLargestFactor);
    logarithms += std::log(found[c]);
    ++count;
  }
  if (isotropic && count > 0) {
    found.assign(given.size(), std::exp(logarithms / static_cast<double>(count)));
  }
  return found;
}

}  // namespace

std::vector<double> scale_reference(const SimilarityPrepared& prepared, Scaling scaling,
                                    std::size_t width, std::span<const double> given,
                                    const Context& context, std::span<double> reference) {
  const std::size_t n = prepared.given_count();
  if (scaling == Scaling::none || n == 0) return std::vector<double>(width, 1.0);
  std::vector<double> limit(n * width);
  prepared.elimination.limits().apply(context, width, reference, limit);
  std::vector<Range> limit_box(width);
  std::vector<Range> given_box(width);
  for (std::size_t i = 0; i < n; ++i) {
    if (prepared.isolated[i] != 0) continue;
    for (std::size_t c = 0; c < width; ++c) {
      limit_box[c].include(limit[i * width + c]);
      given_box[c].include(given[i * width + c]);
    }
  }
  if (limit_box.front().low > limit_box.front().high) return std::vector<double>(width, 1.0);
  const auto scale = factors(limit_box, given_box, scaling == Scaling::isotropic);
  parallel::for_ranges(context, prepared.control_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      for (std::size_t c = 0; c < width; ++c) {
        double& x = reference[j * width + c];
        x = given_box[c].centre() + scale[c] * (x - limit_box[c].centre());
      }
    }
  });
  return scale;
}

}  // namespace surpass

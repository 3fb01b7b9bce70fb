// The parameter that interpolates.
//
// For -4 < beta < 4, ring weights below 5/8 and two steps or more, lambda grows with alpha from
// -infinity to 1/2 + beta / 8 at alpha_max = (4 + beta) / (8 ring): below that every target has one
// solution, which lies in the bracket used here. There are others far above, which a search without
// a bracket would find.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scheme/nonstationary_parameters.hpp"

namespace surpass {
namespace {

Result<void> check_solvable(Index valence, const NonstationaryOptions& options, double along) {
  if (valence < 3) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the valence is {}; there are rules for 3 and more", valence));
  }
  if (options.iteration == ParameterIteration::exponential) {
    return fail(ErrorCode::invalid_argument,
                "the exponential iteration keeps parameters positive and cannot interpolate; take "
                "the rule uniform, or give the vertices' parameters");
  }
  const double shape = options.shape;
  if (!(shape > -4 && shape < 4)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the shape parameter is {}; it must lie between -4 and 4", shape));
  }
  if (!(options.rate > 1)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the rate is {}; it must be above 1", options.rate));
  }
  const double bound = 0.5 + shape / 8;
  if (!(along < bound) || !std::isfinite(along)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a target lies at {} of the way to the centroid; with the shape "
                            "parameter {} it must be below {}",
                            along, shape, bound));
  }
  return {};
}

}  // namespace

std::pair<double, double> shape_range(bool valence_3) {
  return {kLowestShape, valence_3 ? kHighestShapeAtValence3 : kHighestShape};
}

Result<double> interpolating_parameter(Index valence, const NonstationaryOptions& options,
                                       double along) {
  if (auto ok = check_solvable(valence, options, along); !ok) {
    return tl::make_unexpected(ok.error());
  }
  const double ring = nonstationary::ring_weight(valence, options.weights);
  const double beta = options.shape;
  if (options.steps == 1) return along / ring;  // lambda is ring * alpha
  const double reach = 0.5 + beta / 8;
  double low = -(reach - along) / (ring * (0.5 - nonstationary::iterated(beta, 1, options) / 8));
  double high = along == 0 ? 0 : reach / ring;
  double x = 0.5 * (low + high);
  constexpr int kMost = 200;  // of halvings, were Newton's steps never to help
  for (int i = 0; i < kMost; ++i) {
    const auto share = nonstationary::share_of_centroid(x, beta, ring, options.steps, options);
    const double f = share.value - along;
    (f > 0 ? high : low) = x;
    double next = share.derivative > 0 ? x - f / share.derivative : low;
    if (std::abs(next - x) <= 2e-15 * std::max(1.0, std::abs(x))) return next;
    if (!(low < next && next < high)) next = 0.5 * (low + high);
    if (high - low <= 1e-16) return next;
    x = next;
  }
  return x;
}

}  // namespace surpass

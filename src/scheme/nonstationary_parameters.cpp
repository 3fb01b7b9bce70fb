// With p a vertex, c the centroid of its ring, and a_k the ring's weight in the vertex rule,
//     p - c at level k + 1  =  m_k (p - c) at level k,   m_k = 1/2 + beta_k / 8 - a_k,
// so that p moves along one line: after K steps it is p_0 - lambda (p_0 - c_0),
//     lambda = sum over k < K of a_k m_0 ... m_{k-1}  (the paper's Theorem 3, appendix C).
#include "scheme/nonstationary_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "scheme/loop_masks.hpp"

namespace surpass {

const char* name_of(LoopWeights weights) {
  return weights == LoopWeights::classic ? "classic" : "warren";
}

const char* name_of(ParameterIteration iteration) {
  return iteration == ParameterIteration::exponential ? "exponential" : "geometric";
}

const char* name_of(NonstationaryRule rule) {
  switch (rule) {
    case NonstationaryRule::interpolating: return "interpolating";
    case NonstationaryRule::uniform: return "uniform";
    case NonstationaryRule::mean: return "mean";
    case NonstationaryRule::quadratic: return "quadratic";
  }
  return "unknown";
}

namespace nonstationary {
namespace {

double decay(int steps, double rate) {
  if (steps == 0) return 1;
  return std::isfinite(rate) ? std::pow(rate, -steps) : 0;
}

}  // namespace

double iterated(double v, int steps, const NonstationaryOptions& options) {
  if (options.iteration == ParameterIteration::exponential) {
    for (int k = 0; k < steps; ++k) v = std::sqrt((1 + v) / 2);
    return v;
  }
  return 1 + (v - 1) * decay(steps, options.rate);
}

double in_mask(double v, const NonstationaryOptions& options) {
  return options.iteration == ParameterIteration::exponential ? iterated(v, 1, options) : v;
}

int settling_levels(const NonstationaryOptions& options) {
  constexpr double kDigits = 20;
  const double rate = options.iteration == ParameterIteration::exponential ? 4 : options.rate;
  if (!std::isfinite(rate)) return 2;
  return std::max(2, static_cast<int>(std::ceil(kDigits * std::log(10.0) / std::log(rate))));
}

double ring_weight(Index valence, LoopWeights weights) {
  if (weights == LoopWeights::classic) return loop::alpha(valence);
  return valence == 3 ? 9.0 / 16 : 3.0 / 8;
}

Share share_of_centroid(double alpha, double beta, double ring, int steps,
                        const NonstationaryOptions& options) {
  // Backwards: lambda of the levels from k on is a_k + m_k lambda of those from k + 1 on. In the
  // limit the tail is Loop's.
  const int levels = steps > 0 ? steps : settling_levels(options);
  Share share{steps > 0 ? 0.0 : ring / (ring + 3.0 / 8), 0.0};
  const bool geometric = options.iteration == ParameterIteration::geometric;
  for (int k = levels - 1; k >= 0; --k) {
    const double r = geometric ? decay(k, options.rate) : 0;
    const double a =
        ring * (geometric ? 1 + (alpha - 1) * r : in_mask(iterated(alpha, k, options), options));
    const double b = geometric ? 1 + (beta - 1) * r : in_mask(iterated(beta, k, options), options);
    const double m = 0.5 + b / 8 - a;
    share.derivative = ring * r * (1 - share.value) + m * share.derivative;
    share.value = a + m * share.value;
  }
  return share;
}

BendFactors bend_factors(double alpha, double beta, const NonstationaryOptions& options) {
  // In a ring of six the mode of frequency 0 shrinks by m_k, those of frequency 2 by 1/2 - 2 d_k,
  // d_k = beta_k / 8; both are 1/4 in Loop's rules.
  BendFactors factors;
  const double ring = ring_weight(6, options.weights);
  for (int k = 0; k < settling_levels(options); ++k) {
    const double a = ring * in_mask(iterated(alpha, k, options), options);
    const double b = in_mask(iterated(beta, k, options), options);
    factors.laplacian *= 2 + b / 2 - 4 * a;
    factors.deviator *= 2 - b;
  }
  return factors;
}

}  // namespace nonstationary

double centroid_share(double vertex_parameter, Index valence, const NonstationaryOptions& options) {
  const bool uniform = options.rule == NonstationaryRule::uniform;
  return nonstationary::share_of_centroid(
             vertex_parameter, uniform ? vertex_parameter : options.shape,
             nonstationary::ring_weight(valence, options.weights), options.steps, options)
      .value;
}

}  // namespace surpass

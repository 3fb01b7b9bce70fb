// Colours are mixed in Oklab (B. Ottosson, A perceptual color space for image processing, 2020),
// where distances are about as large as they look. Diverging maps: K. Moreland, Diverging color
// maps for scientific visualization, 2009; hues are told apart by most colour-blind people, too.
#include "render/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace surpass::picture {
namespace {

struct Anchor {
  double lightness;
  double chroma;
  double hue;  // degrees
};

// Blue below, nearly white in the middle, red above.
constexpr std::array<Anchor, 5> kDiverging = {{{0.40, 0.14, 258},
                                               {0.73, 0.10, 250},
                                               {0.955, 0.004, 90},
                                               {0.75, 0.13, 48},
                                               {0.44, 0.165, 27}}};
// Darker is more.
constexpr std::array<Anchor, 5> kSequential = {
    {{0.965, 0.02, 100}, {0.86, 0.12, 85}, {0.70, 0.17, 50}, {0.50, 0.18, 22}, {0.27, 0.11, 355}}};

const Colour kUnknown = {0.25F, 0.25F, 0.25F};

using Lab = Eigen::Vector3d;

Lab lab(const Anchor& a) {
  const double hue = a.hue * std::numbers::pi / 180;
  return {a.lightness, a.chroma * std::cos(hue), a.chroma * std::sin(hue)};
}

Colour to_linear(const Lab& c) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(c[0] + 0.3963377774 * c[1] + 0.2158037573 * c[2]);
  const double m = cube(c[0] - 0.1055613458 * c[1] - 0.0638541728 * c[2]);
  const double s = cube(c[0] - 0.0894841775 * c[1] - 1.2914855480 * c[2]);
  const Eigen::Array3d light(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                             -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                             -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
  return light.max(0).min(1).cast<float>();
}

}  // namespace

Colour colour_of(double value, const ColourField& field) {
  if (std::isnan(value)) return kUnknown;
  const std::span<const Anchor> anchors = field.diverging ? kDiverging : kSequential;
  const double share = std::clamp((value - field.low) / (field.high - field.low), 0.0, 1.0);
  const double place = share * static_cast<double>(anchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double t = place - static_cast<double>(below);
  return to_linear((1 - t) * lab(anchors[below]) + t * lab(anchors[below + 1]));
}

}  // namespace surpass::picture

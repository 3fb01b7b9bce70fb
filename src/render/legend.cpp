#include "render/legend.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "render/backdrop.hpp"
#include "render/colour_map.hpp"
#include "render/lettering.hpp"
#include "render/srgb.hpp"

namespace surpass::picture {
namespace {

constexpr int kNumbers = 5;
constexpr int kLeastWidth = 240;  // of a picture with a scale
constexpr int kLeastHeight = 160;

float text_height(int height) { return std::clamp(static_cast<float>(height) / 48, 7.0F, 24.0F); }

std::string number(const ColourField& field, int i) {
  const double share = static_cast<double>(i) / (kNumbers - 1);
  const double value = field.low + share * (field.high - field.low);
  // What is left of the middle of -0.3 to 0.3 by rounding is zero.
  const double least = 1e-12 * std::max(std::abs(field.low), std::abs(field.high));
  return fmt::format("{:.3g}", std::abs(value) <= least ? 0.0 : value);
}

struct Bar {
  int left, right, top, bottom;
};

Bar bar_of(int height) {
  const float text = text_height(height);
  const int thickness = static_cast<int>(std::lround(1.4F * text));
  const int left = static_cast<int>(std::lround(0.8F * text));
  return {left, left + thickness, static_cast<int>(0.16F * static_cast<float>(height)),
          static_cast<int>(0.90F * static_cast<float>(height))};
}

}  // namespace

int legend_width(const RenderOptions& options) {
  const bool wanted = options.field && options.field->legend;
  if (!wanted || options.width < kLeastWidth || options.height < kLeastHeight) return 0;
  const float text = text_height(options.height);
  float widest = 0;
  for (int i = 0; i < kNumbers; ++i) {
    widest = std::max(widest, text_width(number(*options.field, i), text));
  }
  const float beside_bar = static_cast<float>(bar_of(options.height).right) + 0.8F * text + widest;
  const float titled = text + text_width(options.field->title, text);
  const auto width = static_cast<int>(std::ceil(std::max(beside_bar, titled) + text));
  return std::min(width, options.width / 2);
}

Image draw_legend(const ColourField& field, int width, int height) {
  const SrgbTable to_srgb;
  const Bar bar = bar_of(height);
  const auto length = static_cast<double>(bar.bottom - bar.top);
  Image strip = blank(width, height);
  for (int y = bar.top; y < bar.bottom; ++y) {
    const double up = (static_cast<double>(bar.bottom - y) - 0.5) / length;
    const Colour colour = colour_of(field.low + up * (field.high - field.low), field);
    for (int x = bar.left; x < std::min(bar.right, width); ++x) {
      const auto at = std::size_t{3} * static_cast<std::size_t>(y * width + x);
      for (std::size_t k = 0; k < 3; ++k)
        strip.pixels[at + k] = to_srgb(colour[static_cast<int>(k)]);
    }
  }
  const float text = text_height(height);
  for (int i = 0; i < kNumbers; ++i) {
    const double y = bar.bottom - length * i / (kNumbers - 1);
    write_text(strip, number(field, i), static_cast<float>(bar.right) + 0.8F * text,
               static_cast<float>(y) + text / 2, text);
  }
  write_text(strip, field.title, static_cast<float>(bar.left),
             static_cast<float>(bar.top) - 1.6F * text, text);
  return strip;
}

}  // namespace surpass::picture

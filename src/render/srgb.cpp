#include "render/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace surpass::picture {
namespace {
constexpr int kLast = 65535;
}

SrgbTable::SrgbTable() {
  bytes_.reserve(kLast + 1);
  for (int i = 0; i <= kLast; ++i) {
    const double x = static_cast<double>(i) / kLast;
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    bytes_.push_back(static_cast<std::uint8_t>(std::lround(255 * s)));
  }
}

std::uint8_t SrgbTable::operator()(float linear) const {
  if (!(linear > 0)) return 0;
  return bytes_[static_cast<std::size_t>(std::min(linear, 1.0F) * kLast + 0.5F)];
}

}  // namespace surpass::picture

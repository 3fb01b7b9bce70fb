// From linear light to the bytes of an sRGB picture.
#pragma once

#include <cstdint>
#include <vector>

namespace surpass::picture {

/// A table of IEC 61966-2-1's curve, fine enough that a step is at most a twentieth of a byte.
class SrgbTable {
 public:
  SrgbTable();
  /// Values outside 0..1 are cut off; NaN is 0.
  [[nodiscard]] std::uint8_t operator()(float linear) const;

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace surpass::picture

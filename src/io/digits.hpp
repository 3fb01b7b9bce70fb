// Digits in text, eight at a time. What is written in any unusual way is left to others.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace surpass::io {

/// How far behind the place where they start the functions here may look.
inline constexpr std::size_t kDigitsWindow = 32;

struct Digits {
  std::uint64_t value = 0;
  unsigned count = 0;  ///< 0 to 8
};

/// The digits at `at`, up to the eighth; eight bytes must be there. They go to the upper end of a
/// word, zeros below them, and neighbours are joined into numbers of two, four and eight digits.
[[nodiscard]] inline Digits eight_digits(const char* at) {
  if constexpr (std::endian::native != std::endian::little) {
    Digits digits;
    for (; digits.count < 8 && *at >= '0' && *at <= '9'; ++at, ++digits.count) {
      digits.value = 10 * digits.value + static_cast<std::uint64_t>(*at - '0');
    }
    return digits;
  }
  constexpr std::uint64_t kZeros = 0x3030303030303030;
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  const std::uint64_t others =
      ((word + 0x4646464646464646) | (word - kZeros) | word) & 0x8080808080808080;
  const auto count = static_cast<unsigned>(std::countr_zero(others)) / 8;
  const unsigned half = 4 * (8 - count);  // in two steps, as 64 bits at once are too many
  word = ((word - kZeros) << half) << half;
  word = (word * 10 + (word >> 8)) & 0x00FF00FF00FF00FF;
  word = (word * 100 + (word >> 16)) & 0x0000FFFF0000FFFF;
  return {(word * 10000 + (word >> 32)) & 0xFFFFFFFF, count};
}

/// Reads [-]digits[.digits] with at most 7 digits before the point and 11 behind it, and moves
/// `at` behind it. False, and nothing is moved, for all else: there must be kDigitsWindow bytes.
/// The value is the nearest double: numerator and power of ten are exact, so that the division
/// rounds once (Clinger, How to read floating point numbers accurately, 1990).
[[nodiscard]] inline bool plain_decimal(const char*& at, double& value) {
  static constexpr std::uint64_t kPowers[] = {1,      10,      100,      1000,     10000,
                                              100000, 1000000, 10000000, 100000000};
  static constexpr double kDivisors[] = {1e0, 1e1, 1e2, 1e3, 1e4,  1e5,
                                         1e6, 1e7, 1e8, 1e9, 1e10, 1e11};
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  const bool negative = *at == '-';
  const char* p = at + (negative ? 1 : 0);
  const Digits whole = eight_digits(p);
  p += whole.count;
  std::uint64_t numerator = whole.value;
  unsigned behind = 0;
  if (*p == '.') {
    Digits digits = eight_digits(++p);
    p += digits.count;
    behind = digits.count;
    numerator = numerator * kPowers[digits.count] + digits.value;
    if (behind == 8) {
      digits = eight_digits(p);
      if (digits.count > 3) return false;
      p += digits.count;
      behind += digits.count;
      numerator = numerator * kPowers[digits.count] + digits.value;
    }
  }
  if (whole.count == 8 || whole.count + behind == 0 || numerator > kExact) return false;
  const double magnitude =
      static_cast<double>(static_cast<std::int64_t>(numerator)) / kDivisors[behind];
  const auto sign = static_cast<std::uint64_t>(negative) << 63;  // as good as random: no branch
  value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) | sign);
  at = p;
  return true;
}

}  // namespace surpass::io

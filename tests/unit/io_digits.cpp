// Plain decimals are read by a short way of our own: the C library says what they are worth.
#include <bit>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "io/digits.hpp"

namespace surpass::io {
namespace {

std::string padded(const std::string& text) { return text + std::string(kDigitsWindow, ' '); }

// The bits of what was read, and how many characters that took; nothing if it was left alone.
testing::AssertionResult reads_as_the_c_library(const std::string& text) {
  const std::string all = padded(text);
  const char* at = all.c_str();
  double value = 0;
  if (!plain_decimal(at, value)) return testing::AssertionFailure() << text << " is not taken";
  char* end = nullptr;
  const double expected = std::strtod(all.c_str(), &end);
  if (at != end) return testing::AssertionFailure() << text << " ends elsewhere";
  if (std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(expected)) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << text << " became " << value;
}

bool is_left_alone(const std::string& text) {
  const std::string all = padded(text);
  const char* at = all.c_str();
  double value = 1;
  return !plain_decimal(at, value) && at == all.c_str();
}

TEST(Digits, PlainDecimalsAreTheNearestDoubles) {
  std::mt19937_64 random(7);
  const auto digits = [&](std::size_t count) {
    std::string text;
    while (text.size() < count) text += static_cast<char>('0' + random() % 10);
    return text;
  };
  for (int i = 0; i < 200000; ++i) {
    const std::size_t whole = random() % 8;
    const std::size_t most = std::min<std::size_t>(11, 15 - whole);
    const std::size_t behind = random() % (most + 1);
    if (whole + behind == 0) continue;
    std::string text = (random() % 2 == 0 ? "-" : "") + digits(whole);
    if (behind != 0 || random() % 2 == 0) text += '.' + digits(behind);
    ASSERT_TRUE(reads_as_the_c_library(text));
  }
}

TEST(Digits, UnusualDecimalsToo) {
  for (const char* text : {"0", "-0", "-0.0", "5.", ".5", "-.25", "0000001", "9999999.99999999",
                           "0.00000000001", "900719.9254740991", "0.1", "1234567.12345678"}) {
    EXPECT_TRUE(reads_as_the_c_library(text));
  }
}

TEST(Digits, AllElseIsLeftAlone) {
  for (const char* text : {"", "-", ".", "-.", "+1", "x", "12345678", "12345678.5", "nan",
                           "0.123456789012", "900719.92547409931", "--1", " 1"}) {
    EXPECT_TRUE(is_left_alone(text)) << text;
  }
}

TEST(Digits, EightAtATime) {
  const auto read = [](const char* text) { return eight_digits(text); };
  for (const char* text : {"xxxxxxxx", "1/345678", "1:345678", "12345678", "00000000", "1234567\n",
                           "7\xb0\xb1yyyyy"}) {
    char* end = nullptr;
    const std::string first(text, 8);
    const std::uint64_t value = std::strtoull(first.c_str(), &end, 10);
    EXPECT_EQ(read(text).value, value) << text;
    EXPECT_EQ(read(text).count, static_cast<unsigned>(end - first.c_str())) << text;
  }
}

}  // namespace
}  // namespace surpass::io

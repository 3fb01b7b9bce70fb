// One pointer over the text of a mesh file, shared by all readers. It owns no text and keeps no
// line numbers: those are counted only when an error needs them.
#pragma once

#include <surpass/result.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <fast_float/fast_float.h>

#include "io/digits.hpp"

namespace surpass::io {

/// A whole number from 1 on, and its first digit.
struct PlainIndex {
  std::uint32_t number;
  const char* place;
};

/// Lines end with LF, CR LF or CR. Functions that return bool return false after `fail`, which
/// keeps the error for the caller at the top; on the way up nothing is left to do but to return.
class Scanner {
 public:
  /// `comment` starts a comment that runs to the end of its line; '\n' where a format has none.
  Scanner(std::string_view text, std::string_view name, char comment = '\n')
      : begin_(text.data()),
        end_(text.data() + text.size()),
        at_(begin_),
        name_(name),
        comment_(comment) {}

  /// Takes "nan" and "inf" for numbers too; binary readers ask for it as well.
  void allow_not_finite() { not_finite_ = true; }
  [[nodiscard]] bool allows_not_finite() const { return not_finite_; }

  // Place.
  [[nodiscard]] bool done() const { return at_ == end_; }
  [[nodiscard]] const char* at() const { return at_; }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return ahead < left() ? at_[ahead] : '\n';
  }
  void move_to(const char* place) { at_ = place; }
  void advance(std::size_t bytes) { at_ += bytes; }

  // Blanks and lines.
  /// Skips spaces, tabs, and line ends after a backslash.
  void skip_blanks() {
    for (;; ++at_) {
      while (at_ != end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
      if (at_ == end_ || *at_ != '\\' || !skip_continuation()) return;
    }
  }
  /// Skips blanks, comments and line ends.
  void skip_space();
  /// True before a line end, a comment or the end of the text; skips the blanks before it.
  [[nodiscard]] bool at_line_end() {
    skip_blanks();
    return done() || is_line_end(*at_) || *at_ == comment_;
  }
  /// Moves behind the next line end; a backslash is a character like others.
  void skip_line();
  /// The same, but a line that ends with a backslash goes on.
  void skip_statement();
  /// Moves behind the line end; anything else than blanks and a comment before it is an error.
  [[nodiscard]] bool end_line() {
    if (at_ == end_ || *at_ != '\n') return end_other_line();
    ++at_;
    return true;
  }

  // Words and numbers, at the place where they begin.
  /// Up to the next blank, comment or line end; empty at a line end.
  [[nodiscard]] std::string_view word();
  /// What is left of the line, without blanks around it and without a comment behind a blank.
  [[nodiscard]] std::string_view rest_of_line();
  /// A finite number. `what` names it in an error: "an x coordinate".
  template <class T>
  [[nodiscard]] bool number(T& value, const char* what) {
    const char* start = at_;
    if constexpr (std::is_same_v<T, double>) {  // nearly all of them
      const char* plain = start;
      if (left() > kDigitsWindow && plain_decimal(plain, value) && ends_word(plain)) {
        at_ = plain;
        return true;
      }
    }
    const char* digits = start + (peek() == '+' && peek(1) != '-' ? 1 : 0);
    const auto [stop, failure] = fast_float::from_chars(digits, end_, value);
    if (failure != std::errc() || !ends_word(stop) || (!std::isfinite(value) && !not_finite_)) {
      return refuse_number(what);
    }
    at_ = stop;
    return true;
  }
  /// Digits, whatever follows them; a value of more than 18 digits stays somewhere above those.
  [[nodiscard]] bool digits(std::uint64_t& value) {
    constexpr std::uint64_t kEnough = 1000000000000000000;
    const char* start = at_;
    value = 0;
    if (left() > kDigitsWindow) {
      const Digits few = eight_digits(start);
      if (few.count < 8) {
        value = few.value;
        at_ = start + few.count;
        return few.count != 0;
      }
    }
    for (; at_ != end_ && *at_ >= '0' && *at_ <= '9'; ++at_) {
      if (value < kEnough) value = 10 * value + static_cast<std::uint64_t>(*at_ - '0');
    }
    return at_ != start;
  }
  /// What nearly every index is: up to seven digits, not all zeros, and a blank or line end behind.
  /// False, and nothing is moved, for all else.
  [[nodiscard]] bool plain_index(std::uint64_t& value) {
    if (left() <= kDigitsWindow) return false;
    const Digits few = eight_digits(at_);
    const char behind = at_[few.count];
    if (few.count == 8 || few.value == 0 || (behind != ' ' && behind != '\n')) return false;
    value = few.value;
    at_ += few.count;
    return true;
  }
  /// What nearly every point is: plain decimals, one blank before each. False, and nothing is
  /// moved, for all else.
  template <std::size_t kCount>
  [[nodiscard]] bool plain_decimals(std::array<double, kCount>& values) {
    if (left() <= kCount * kDigitsWindow) return false;
    const char* p = at_;
    for (double& value : values) {
      if (*p++ != ' ' || !plain_decimal(p, value)) return false;
    }
    if (!ends_word(p)) return false;
    at_ = p;
    return true;
  }
  /// What nearly every face is: plain indices, one blank before each, and the line end, behind
  /// which this moves. How many, at most kMost; 0, and nothing is moved, for all else.
  template <std::size_t kMost>
  [[nodiscard]] std::size_t plain_indices(std::array<PlainIndex, kMost>& indices) {
    if (left() <= kMost * kDigitsWindow) return 0;
    const char* p = at_;
    for (std::size_t count = 0; count < kMost;) {
      if (*p++ != ' ') return 0;
      const Digits few = eight_digits(p);
      if (few.count == 8 || few.value == 0) return 0;
      indices[count++] = {static_cast<std::uint32_t>(few.value), p};
      p += few.count;
      if (*p == ' ') continue;
      if (*p == '\r') ++p;
      if (*p != '\n') return 0;
      at_ = p + 1;
      return count;
    }
    return 0;
  }
  /// A number without sign and fraction.
  [[nodiscard]] bool whole(std::uint64_t& value, const char* what);

  // Errors.
  /// Records the error with line and column of `place`; false.
  bool fail(ErrorCode code, std::string message, const char* place);
  bool fail(ErrorCode code, std::string message) { return fail(code, std::move(message), at_); }
  /// The same with the byte, for binary files.
  bool fail_at_byte(ErrorCode code, std::string message, const char* place);
  /// The same with the file only.
  bool fail_as_a_whole(ErrorCode code, std::string message);
  [[nodiscard]] const Error& error() const { return error_; }

  [[nodiscard]] static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  [[nodiscard]] bool ends_word(const char* place) const {
    if (place == end_) return true;
    const char c = *place;
    return c == ' ' || c == '\t' || is_line_end(c) || c == comment_;
  }

 private:
  bool end_other_line();

  bool skip_continuation();
  void skip_line_end();
  void skip_to_line_end();
  bool refuse_number(const char* what);

  const char* begin_;
  const char* end_;
  const char* at_;
  std::string name_;
  char comment_;
  bool not_finite_ = false;
  Error error_;
};

/// Printable form of a piece of a file for messages: in quotes, unprintable bytes as dots, cut
/// where it is long.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace surpass::io

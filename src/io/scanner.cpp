#include "io/scanner.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace surpass::io {

void Scanner::skip_space() {
  for (;;) {
    skip_blanks();
    if (done()) return;
    if (*at_ == comment_) {
      skip_line();
    } else if (is_line_end(*at_)) {
      ++at_;
    } else {
      return;
    }
  }
}

// Moves from a backslash to the last byte of the line end behind it, if there is one.
bool Scanner::skip_continuation() {
  if (left() < 2 || !is_line_end(at_[1])) return false;
  at_ += (at_[1] == '\r' && peek(2) == '\n' && left() > 2) ? 2 : 1;
  return true;
}

void Scanner::skip_line_end() {
  if (done()) return;
  const bool carriage_return = *at_ == '\r';
  ++at_;
  if (carriage_return && !done() && *at_ == '\n') ++at_;
}

void Scanner::skip_to_line_end() {
  while (!done() && !is_line_end(*at_)) ++at_;
}

void Scanner::skip_line() {
  skip_to_line_end();
  skip_line_end();
}

void Scanner::skip_statement() {
  for (;;) {
    const char* start = at_;
    skip_to_line_end();
    const bool goes_on = at_ != start && at_[-1] == '\\';
    skip_line_end();
    if (!goes_on || done()) return;
  }
}

bool Scanner::end_other_line() {
  if (!at_line_end()) {
    const char* start = at_;
    return fail(ErrorCode::syntax,
                fmt::format("{} is more than this line may hold; remove it", quoted(word())),
                start);
  }
  skip_line();
  return true;
}

std::string_view Scanner::word() {
  const char* start = at_;
  while (!ends_word(at_)) ++at_;
  return {start, static_cast<std::size_t>(at_ - start)};
}

std::string_view Scanner::rest_of_line() {
  skip_blanks();
  const char* start = at_;
  const char* stop = at_;
  while (!at_line_end()) {
    while (!done() && !is_line_end(*at_) && *at_ != ' ' && *at_ != '\t') ++at_;
    stop = at_;
  }
  return {start, static_cast<std::size_t>(stop - start)};
}

bool Scanner::whole(std::uint64_t& value, const char* what) {
  const char* start = at_;
  if (digits(value) && ends_word(at_)) return true;
  at_ = start;
  if (done()) return fail(ErrorCode::unexpected_end, fmt::format("the file ends before {}", what));
  return fail(ErrorCode::syntax,
              fmt::format("expected {}, a whole number from 0, but found {}", what,
                          at_line_end() ? "the end of the line" : quoted(word())),
              start);
}

namespace {

bool looks_like_fortran(std::string_view word) {
  const std::size_t d = word.find_first_of("dD");
  return d != std::string_view::npos && d > 0 &&
         word.find_first_not_of("+-.0123456789dD") == std::string_view::npos;
}

bool names_no_finite_number(std::string_view word) {
  const std::size_t start = word.find_first_not_of("+-");
  if (start == std::string_view::npos) return false;
  std::string head(word.substr(start, 3));
  std::transform(head.begin(), head.end(), head.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return head == "nan" || head == "inf";
}

}  // namespace

bool Scanner::refuse_number(const char* what) {
  const char* start = at_;
  if (done()) return fail(ErrorCode::unexpected_end, fmt::format("the file ends before {}", what));
  if (at_line_end()) {
    return fail(ErrorCode::syntax,
                fmt::format("the line ends before {}; a number is missing", what), start);
  }
  at_ = start;
  const std::string_view found = word();
  const std::string text = quoted(found);
  if (names_no_finite_number(found)) {
    return fail(
        ErrorCode::not_finite,
        fmt::format("{} is {}; only finite numbers can be used, correct or remove it", what, text),
        start);
  }
  if (found.find(',') != std::string_view::npos) {
    return fail(ErrorCode::bad_number,
                fmt::format("{} is written {}; use a decimal point, and blanks between numbers, "
                            "in the place of commas",
                            what, text),
                start);
  }
  if (looks_like_fortran(found)) {
    return fail(ErrorCode::bad_number,
                fmt::format("{} is written {} with a Fortran exponent; write e in the place of d",
                            what, text),
                start);
  }
  double value = 0;
  const auto parsed = fast_float::from_chars(found.data(), found.data() + found.size(), value);
  if (parsed.ec == std::errc() && parsed.ptr == found.data() + found.size()) {
    return fail(ErrorCode::bad_number,
                fmt::format("{} is {}, too large for a floating-point number; scale the model down",
                            what, text),
                start);
  }
  return fail(ErrorCode::bad_number, fmt::format("expected {}, but {} is not a number", what, text),
              start);
}

bool Scanner::fail(ErrorCode code, std::string message, const char* place) {
  std::uint64_t line = 1;
  const char* line_start = begin_;
  for (const char* p = begin_; p < place; ++p) {
    if (!is_line_end(*p) || (*p == '\r' && p + 1 != end_ && p[1] == '\n')) continue;
    ++line;
    line_start = p + 1;
  }
  error_ = {code, std::move(message), {.file = name_}};
  error_.place.line = line;
  error_.place.column = static_cast<std::uint64_t>(std::max(place, line_start) - line_start) + 1;
  return false;
}

bool Scanner::fail_at_byte(ErrorCode code, std::string message, const char* place) {
  error_ = {code, std::move(message), {.file = name_}};
  error_.place.byte = static_cast<std::uint64_t>(place - begin_);
  return false;
}

bool Scanner::fail_as_a_whole(ErrorCode code, std::string message) {
  error_ = {code, std::move(message), {.file = name_}};
  return false;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) shown += (c < ' ' || c > '~') ? '.' : c;
  shown += text.size() > kLongest ? "...'" : "'";
  return shown;
}

}  // namespace surpass::io

// Numbers and lines appended to a string.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include <fmt/compile.h>
#include <fmt/format.h>

namespace surpass::io {

/// The shortest digits that read back as the same number.
template <std::floating_point T>
void append_number(std::string& out, T value) {
  char buffer[40];
  out.append(buffer, fmt::format_to(buffer, FMT_COMPILE("{}"), value));
}
template <std::integral T>
void append_number(std::string& out, T value) {
  const fmt::format_int digits(value);
  out.append(digits.data(), digits.size());
}

/// A space and the number.
template <class T>
void append_spaced(std::string& out, T value) {
  out += ' ';
  append_number(out, value);
}

/// A comment line; what would end the line or go on behind it becomes a space.
inline void append_comment(std::string& out, std::string_view mark, std::string_view text) {
  if (text.empty()) return;
  out += mark;
  out += ' ';
  for (const char c : text) out += (c >= 0 && c < ' ') || c == '\\' ? ' ' : c;
  out += '\n';
}

}  // namespace surpass::io

#pragma once

#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace surpass {

/// "1 face", "3 faces".
[[nodiscard]] inline std::string counted(std::size_t n, std::string_view one,
                                         std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// "a, b, c" for the separator ", ". What fmt::join would do, of which GCC 12 at -O3 warns falsely.
[[nodiscard]] inline std::string joined(std::span<const std::string> words,
                                        std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

}  // namespace surpass

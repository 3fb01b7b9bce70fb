// Sentences that are right in the singular, too.
#pragma once

#include <string>

#include <fmt/format.h>

namespace surpass::cli {

/// "1 level", "3 levels".
template <class Number>
[[nodiscard]] std::string counted(Number n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace surpass::cli

#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace surpass {

/// "1 face", "3 faces".
[[nodiscard]] inline std::string counted(std::size_t n, std::string_view one,
                                         std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace surpass

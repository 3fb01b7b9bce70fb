#pragma once

#include <surpass/io.hpp>

#include <string_view>

namespace surpass::io {

/// The format that the first bytes show beyond doubt, or automatic.
[[nodiscard]] Format format_of_bytes(std::string_view bytes);

}  // namespace surpass::io

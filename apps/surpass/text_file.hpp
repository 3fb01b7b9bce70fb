// A small text file in memory: lists and requirements beside the meshes.
#pragma once

#include <surpass/result.hpp>

#include <string>

namespace surpass::cli {

/// The whole file; "-" is the standard input. Fails with cannot_open or cannot_read, also for
/// folders.
[[nodiscard]] Result<std::string> read_text(const std::string& path);

}  // namespace surpass::cli

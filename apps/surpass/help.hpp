// The text of --help and --version.
#pragma once

#include <string>

namespace surpass::cli {

/// `surpass --help`: the commands and the exit codes.
[[nodiscard]] std::string overview();

/// `surpass --version`: the version and the components built in.
[[nodiscard]] std::string version_text();

}  // namespace surpass::cli

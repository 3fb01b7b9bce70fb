// Commands that are programs of their own, because their licence is another.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace surpass::cli {

/// Becomes `surpass-NAME`, which lies beside this program or on the PATH: its exit code and its
/// answer to signals are those of the command. Returns (an exit code) only where there is no such
/// program, and then has said so.
int run_other_program(const CommandEntry& entry, const std::vector<std::string>& words);

/// Whether there is such a program beside this one.
[[nodiscard]] bool has_other_program(const CommandEntry& entry);

}  // namespace surpass::cli

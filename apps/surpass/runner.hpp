// Runs a command: reads its options, does its work, and turns the outcome into an exit code.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace surpass::cli {

/// `words` are what follows the command's name. Returns the exit code.
int run_command(const CommandEntry& entry, const std::vector<std::string>& words);

/// Prints data on stdout, or says why it cannot; the exit code.
int print_out(const std::string& text, Console& console);

/// The sentence, and where to read on.
[[nodiscard]] std::string pointing_to_help(const std::string& sentence, const std::string& name);

}  // namespace surpass::cli

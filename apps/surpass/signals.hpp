// Ctrl-C and kill: the first asks the computation to stop, the second ends the program at once.
#pragma once

#include <atomic>

namespace surpass::cli {

/// Installs handlers for SIGINT and SIGTERM and ignores SIGPIPE, so that a closed pipe is an error
/// of writing. Returns the flag that the first signal sets.
const std::atomic<bool>& catch_signals();

}  // namespace surpass::cli

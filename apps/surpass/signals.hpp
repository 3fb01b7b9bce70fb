// Ctrl-C and kill: the first asks the computation to stop, the second ends the program at once.
#pragma once

#include <atomic>
#include <string>

namespace surpass::cli {

/// Installs handlers for SIGINT and SIGTERM, and ignores SIGPIPE and SIGXFSZ, so that a closed pipe
/// and a file above the user's limit are errors of writing. Returns the flag that the first signal
/// sets.
const std::atomic<bool>& catch_signals();

/// While it lives, a second signal waits too: the library writes a neighbour of `path`, which must
/// not be left behind. Writing to a stream can be stopped at any time.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& path);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();
};

}  // namespace surpass::cli

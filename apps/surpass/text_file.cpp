#include "text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace surpass::cli {

Result<std::string> read_text(const std::string& path) {
  std::ifstream file;
  if (path != "-") {
    file.open(path, std::ios::binary);
    if (!file) {
      return fail(ErrorCode::cannot_open, fmt::format("cannot be opened: {}", std::strerror(errno)),
                  Place{.file = path});
    }
  }
  std::istream& in = path == "-" ? std::cin : file;
  std::ostringstream text;
  // A folder opens, and fails when it is read. An empty file gives nothing to insert, which counts
  // as a failure of `text`, too.
  errno = 0;
  text << in.rdbuf();
  if (errno != 0) {
    return fail(ErrorCode::cannot_read, fmt::format("cannot be read: {}", std::strerror(errno)),
                Place{.file = path});
  }
  return std::move(text).str();
}

}  // namespace surpass::cli

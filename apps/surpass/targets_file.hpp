// The file of `--targets`: a vertex number from 0 and a position along its line, pair after pair,
// separated by white space; # starts a comment.
#pragma once

#include <surpass/nonstationary.hpp>

#include <string>
#include <vector>

namespace surpass::cli {

/// In the order of the file. Fails, with line and column, on anything else, on vertices that do not
/// exist, and on a file without any.
[[nodiscard]] Result<std::vector<LineTarget>> read_targets(const std::string& path,
                                                           Index vertex_count);

}  // namespace surpass::cli

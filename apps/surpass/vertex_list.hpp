// The file of `--only`: vertex numbers from 0, separated by white space; # starts a comment.
#pragma once

#include <surpass/result.hpp>

#include <string>
#include <vector>

namespace surpass::cli {

/// Ascending and without repeats. Fails, with line and column, on anything that is no number below
/// `vertex_count`, and on a file without any.
[[nodiscard]] Result<std::vector<Index>> read_vertex_list(const std::string& path,
                                                          Index vertex_count);

}  // namespace surpass::cli

// The nearest right word for a wrong one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surpass::cli {

/// The candidate with the smallest edit distance to `word`, or "" if none is near enough to be
/// meant.
[[nodiscard]] std::string nearest(std::string_view word,
                                  const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" for the nearest candidate, or "".
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates);

}  // namespace surpass::cli

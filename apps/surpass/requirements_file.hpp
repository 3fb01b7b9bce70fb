// Requirements as JSON: docs/requirements.schema.json.
#pragma once

#include <surpass/requirements.hpp>

#include <string>

namespace surpass::cli {

/// Errors name the file, and the requirement by its place in the list; for a syntax error the byte.
[[nodiscard]] Result<std::vector<Requirement>> read_requirements(const std::string& path);

}  // namespace surpass::cli

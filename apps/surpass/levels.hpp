// --levels, and the refusal of refinements that no computer at hand can hold.
#pragma once

#include <surpass/mesh.hpp>

#include <string>

#include "options.hpp"

namespace surpass::cli {

Option add_levels(Options& options, int& levels, const std::string& description);

/// Fails where the refined mesh would have more than 2^31 face corners.
[[nodiscard]] Result<void> check_levels(const Mesh& mesh, int levels);

}  // namespace surpass::cli

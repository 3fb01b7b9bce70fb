// --levels, and the refusal of refinements that no computer at hand can hold.
#pragma once

#include <surpass/mesh.hpp>

#include <string>

#include <CLI/App.hpp>

namespace surpass::cli {

CLI::Option* add_levels(CLI::App& app, int& levels, const std::string& description);

/// Fails where the refined mesh would have more than 2^31 face corners.
[[nodiscard]] Result<void> check_levels(const Mesh& mesh, int levels);

}  // namespace surpass::cli

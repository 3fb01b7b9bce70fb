// The program itself, as a user starts it, and its own account of a run.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace surpass::bench {

/// Runs `surpass` with these arguments, on one thread and quietly; throws if it fails.
void run_program(std::vector<std::string> arguments);

/// The same once more, with the report that it writes. What the system says of a child begins with
/// the memory of this process.
[[nodiscard]] nlohmann::json report_of_program(std::vector<std::string> arguments);

}  // namespace surpass::bench

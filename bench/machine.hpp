// The facts about a machine and a build without which a figure says little.
#pragma once

#include <map>
#include <string>

namespace surpass::bench {

/// Processor, memory, kernel, compiler, thread backend, and the versions of the rivals.
[[nodiscard]] std::map<std::string, std::string> machine_facts();

}  // namespace surpass::bench

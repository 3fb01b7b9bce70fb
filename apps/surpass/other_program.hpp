// Commands that are programs of their own: their licence is another, or what they are linked to
// takes longer to load than a small mesh to interpolate.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace surpass::cli {

inline constexpr CommandEntry kReconstruct = {
    "reconstruct", "from a cloud of points to a mesh, and a smooth surface through its vertices",
    nullptr, "CGAL and nanoflann (Debian: libcgal-dev libnanoflann-dev)"};
inline constexpr CommandEntry kRender = {
    "render", "draw a shaded picture without a display", nullptr,
    "Embree, libpng and nanoflann (Debian: libembree-dev libpng-dev libnanoflann-dev)"};

/// Becomes `surpass-NAME`, which lies beside this program or on the PATH: its exit code and its
/// answer to signals are those of the command. Returns (an exit code) only where there is no such
/// program, and then has said so.
int run_other_program(const CommandEntry& entry, const std::vector<std::string>& words);

/// Becomes the program of this name that lies beside this one, with these words after its name.
/// Returns only where that is not possible; `errno` says why.
void become_program_beside(const std::string& name, const std::vector<std::string>& words);

/// Whether another program of this name lies beside this one, and may be started.
[[nodiscard]] bool is_beside(const std::string& name);

/// Says why, by `errno`; an exit code.
int tell_not_started(const std::string& name);

/// Whether there is such a program where run_other_program() looks.
[[nodiscard]] bool has_other_program(const CommandEntry& entry);

}  // namespace surpass::cli

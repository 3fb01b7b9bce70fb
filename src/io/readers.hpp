// The readers' common form. Each fills `out` and returns true, or leaves its error in the scanner.
#pragma once

#include <surpass/io.hpp>

#include "io/scanner.hpp"

namespace surpass::io {

[[nodiscard]] bool read_obj(Scanner& scan, LoadedMesh& out);
[[nodiscard]] bool read_ply(Scanner& scan, LoadedMesh& out);
[[nodiscard]] bool read_off(Scanner& scan, LoadedMesh& out);
[[nodiscard]] bool read_stl(Scanner& scan, LoadedMesh& out);
[[nodiscard]] bool read_xyz(Scanner& scan, LoadedMesh& out);

/// True if the bytes are a binary STL file, which has no mark of its own.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

inline constexpr const char* kCoordinates[] = {"an x coordinate", "a y coordinate",
                                               "a z coordinate"};

}  // namespace surpass::io

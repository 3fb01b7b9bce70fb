// Files are written here and not by the library, so that its writers cannot please its readers.
#pragma once

#include <surpass/mesh.hpp>

#include <string>

namespace surpass::bench {

/// Positions and triangles as text, in the fewest digits that name the same doubles.
void write_obj(const Mesh& mesh, const std::string& path);
/// Positions and triangles in binary: little-endian doubles, as this machine holds them.
void write_ply(const Mesh& mesh, const std::string& path);

}  // namespace surpass::bench

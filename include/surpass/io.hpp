// Meshes and points from files and into files: OBJ, PLY, OFF, STL, XYZ. Nothing is lost without a
// word.
#pragma once

#include <surpass/mesh.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace surpass {

/// XYZ has points only: a line a point, with normals or colours behind the position. Files named
/// .pwn (points with normals) and .pts are read as such.
enum class Format { automatic, obj, ply, off, stl, xyz };

/// Layout of a binary or text PLY or STL file.
enum class Encoding { automatic, ascii, little_endian, big_endian };

/// A mesh as read, and what the reader has to say about it.
struct LoadedMesh {
  Mesh mesh;
  Format format = Format::automatic;
  std::vector<std::string> notices;  ///< what was legal but skipped, or read in a particular way
};

/// Reads a mesh. `path` "-" is the standard input. The format is taken from `format`, else from the
/// file's first bytes and its name. Errors carry file, line and column, or the byte.
/// Memory is taken only after sizes claimed by a header were checked against the file's own size.
[[nodiscard]] Result<LoadedMesh> read_mesh(const std::string& path,
                                           Format format = Format::automatic);

/// The same for bytes in memory; `name` stands for the file in errors.
[[nodiscard]] Result<LoadedMesh> parse_mesh(std::string_view bytes, Format format,
                                            const std::string& name);

/// Reads the points of a file in any format, with their channels; faces are left out, and a notice
/// says so. As scanners write them where nothing was seen, numbers may be NaN or infinite here.
[[nodiscard]] Result<LoadedMesh> read_points(const std::string& path,
                                             Format format = Format::automatic);

/// The same for bytes in memory.
[[nodiscard]] Result<LoadedMesh> parse_points(std::string_view bytes, Format format,
                                              const std::string& name);

struct WriteOptions {
  Format format = Format::automatic;        ///< automatic: from the path's ending
  Encoding encoding = Encoding::automatic;  ///< PLY: little-endian; STL: binary; else text
  bool single_precision = false;            ///< PLY: 32-bit positions (STL always has them)
  std::vector<std::string> comments = {};   ///< lines for the head of the file
};

/// Writes a mesh to `path`, "-" for the standard output. A file is written beside its destination,
/// flushed, and renamed: there is the whole new file or the old one.
/// Text holds the shortest digits that read back the same double.
/// Returns sentences on what the format could not hold (an STL file has no creases, say).
[[nodiscard]] Result<std::vector<std::string>> write_mesh(const Mesh& mesh, const std::string& path,
                                                          const WriteOptions& options = {});

/// The bytes that write_mesh would write, appended to `bytes`; `options.format` must be named.
[[nodiscard]] Result<std::vector<std::string>> format_mesh(const Mesh& mesh,
                                                           const WriteOptions& options,
                                                           std::string& bytes);

/// Fails with `unsuitable_for_scheme`, naming the face, where the format has no place for the
/// mesh's faces: STL holds triangles only. O(faces).
[[nodiscard]] Result<void> check_faces(const Mesh& mesh, Format format);

/// Whether such a file holds positions of 32 bits.
[[nodiscard]] bool rounds_positions(Format format, bool single_precision);

/// The positions as such a file will hold them: unchanged, or rounded to 32 bits.
[[nodiscard]] std::vector<Point> stored_positions(std::span<const Point> points, Format format,
                                                  bool single_precision);

/// The format that a path's ending names ("a/b.PLY"), or automatic.
[[nodiscard]] Format format_of_path(std::string_view path);
/// "obj", "ply", ...; and back (automatic where the name is unknown).
[[nodiscard]] const char* name_of(Format format);
[[nodiscard]] Format format_named(std::string_view name);

/// Any file, device or pipe to its end, as read_mesh reads it; "-" is the standard input. Fails
/// with cannot_open or cannot_read, also for folders.
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Writes any bytes as write_mesh writes a mesh: beside, flushed, renamed. "-" is the standard
/// output.
[[nodiscard]] Result<void> write_file(const std::string& path, std::string_view bytes);

}  // namespace surpass

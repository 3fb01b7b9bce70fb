// The writers' common form. Each appends to `bytes`, and leaves sentences on what its format cannot
// hold in `notes`. The mesh is well formed; see format_mesh.
#pragma once

#include <surpass/io.hpp>

#include <string>
#include <vector>

namespace surpass::io {

using Notes = std::vector<std::string>;

[[nodiscard]] Result<void> write_obj(const Mesh& mesh, const WriteOptions& options,
                                     std::string& bytes, Notes& notes);
[[nodiscard]] Result<void> write_ply(const Mesh& mesh, const WriteOptions& options,
                                     std::string& bytes, Notes& notes);
[[nodiscard]] Result<void> write_off(const Mesh& mesh, const WriteOptions& options,
                                     std::string& bytes, Notes& notes);
[[nodiscard]] Result<void> write_stl(const Mesh& mesh, const WriteOptions& options,
                                     std::string& bytes, Notes& notes);
[[nodiscard]] Result<void> write_xyz(const Mesh& mesh, const WriteOptions& options,
                                     std::string& bytes, Notes& notes);

/// The vertex channel of this name if its columns are as wanted, else nullptr.
[[nodiscard]] const Channel* find_channel(const Mesh& mesh, std::string_view name,
                                          std::size_t least_width, std::size_t most_width);

/// What a format holds besides positions and faces.
struct Holds {
  const char* format;
  bool sharpness = false;
  bool holes = false;
  bool tags = false;
  bool face_sets = false;
  bool materials = false;
  bool annotations = true;
};

/// A sentence for each kind of thing that the mesh has and the format does not hold. Channels are
/// the writers' own affair.
void note_losses(const Mesh& mesh, const Holds& holds, Notes& notes);
void note_lost(const char* format, const char* kind, const std::string& name, Notes& notes);

}  // namespace surpass::io

// The mesh that a command writes, and the promises about files: no input is overwritten unasked,
// and what cannot be written is said before the work, not after it.
#pragma once

#include <surpass/io.hpp>
#include <surpass/scheme.hpp>

#include <string>
#include <vector>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

class MeshOutput {
 public:
  /// -o (or the argument `name` in its place), --to, --ascii, --binary, --single, --force.
  void define(Options& options, const std::string& name, const std::string& description);

  /// To be called before the work: checks this output, further ones and the report against the
  /// inputs and each other, and settles the format. Point outputs may be XYZ files, others not.
  [[nodiscard]] Result<void> prepare(const Session& session, const std::vector<std::string>& inputs,
                                     const std::vector<std::string>& further_outputs = {},
                                     const std::vector<std::string>& point_outputs = {});

  /// The format of '-' where --to does not name one.
  void default_format(Format format_of_input);

  /// Fails where the format of an output has no place for the mesh's faces. To be called for all of
  /// several outputs before the first is written.
  [[nodiscard]] Result<void> check(const Mesh& mesh, const std::string& path) const;

  /// The same of the output of `define` for a mesh of the faces that were read, which --triangulate
  /// would cut.
  [[nodiscard]] Result<void> check_as_read(const Mesh& mesh) const;

  /// The same for what refinement will make of the mesh.
  [[nodiscard]] Result<void> check_refined(const Mesh& mesh, Scheme scheme, int levels,
                                           const std::string& path) const;

  /// Writes to the output of `define`, or to another path in the format that its ending names.
  [[nodiscard]] Result<void> write(const Mesh& mesh, Session& session) const;
  [[nodiscard]] Result<void> write(const Mesh& mesh, const std::string& path,
                                   Session& session) const;

  /// The positions as the file will hold them.
  [[nodiscard]] bool rounds() const;
  [[nodiscard]] std::vector<Point> stored(std::span<const Point> points) const;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] Format format() const { return options_.format; }

 private:
  [[nodiscard]] Format format_at(const std::string& path) const;

  std::string path_;
  WriteOptions options_;
  bool ascii_ = false;
  bool binary_ = false;
  bool force_ = false;
};

/// Writes the bytes of another kind of output, unless the run was interrupted.
[[nodiscard]] Result<void> write_bytes(const std::string& path, std::string_view bytes,
                                       Session& session);

/// Fails if two outputs are one file, if an output is an input (unless `force`), if a folder is
/// missing or not writable, or if more than one stream is '-'.
[[nodiscard]] Result<void> check_paths(const std::vector<std::string>& inputs,
                                       const std::vector<std::string>& outputs, bool force);

/// check_paths for commands that write nothing but a report.
[[nodiscard]] Result<void> check_report_path(const Session& session,
                                             const std::vector<std::string>& inputs);

}  // namespace surpass::cli

// The mesh that a command works on: read, and mended where the user asks.
#pragma once

#include "session.hpp"

#include <surpass/io.hpp>

#include <CLI/App.hpp>
#include <string>

namespace surpass::cli {

class MeshInput {
 public:
  /// The argument `name` (such as "GIVEN") with --from, --repair, --weld and --triangulate.
  void define(CLI::App& app, const std::string& name, const std::string& description);

  /// Reads, mends, and says what was done. report["input"] and report["mended"] are filled in.
  [[nodiscard]] Result<LoadedMesh> load(Session& session) const;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[nodiscard]] Result<Mesh> mend(Mesh mesh, Session& session) const;

  std::string path_;
  Format format_ = Format::automatic;
  bool repair_ = false;
  bool triangulate_ = false;
  double weld_ = -1;  ///< relative to the box side; negative: not asked for
};

/// --from, for commands with another kind of input.
void add_from(CLI::App& app, Format& format);

/// Reads a mesh, prints the reader's notices and adds the time to seconds.read.
[[nodiscard]] Result<LoadedMesh> load_mesh(const std::string& path, Format format,
                                           Session& session);

/// Counts of a mesh as in the report's "input": vertices, faces, and, where the topology can be
/// built, components and boundary_loops.
[[nodiscard]] Json mesh_json(const std::string& path, const Mesh& mesh);

}  // namespace surpass::cli

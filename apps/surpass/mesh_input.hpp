// The mesh that a command works on: read, and mended where the user asks.
#pragma once

#include <surpass/io.hpp>

#include <string>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// --repair, --weld and --triangulate. Nothing is mended unasked.
class Mending {
 public:
  void define(Options& options);

  /// Mends the mesh as asked; what was done is noted and added to report["mended"].
  [[nodiscard]] Result<void> apply(Mesh& mesh, Session& session) const;

 private:
  bool repair_ = false;
  bool triangulate_ = false;
  double weld_ = -1;  ///< relative to the box side; negative: not asked for
};

/// A file or stream, and how to mend what it holds.
class MeshInput {
 public:
  /// The argument `name` (such as "GIVEN") with --from and the options of Mending.
  void define(Options& options, const std::string& name, const std::string& description);

  /// Reads and mends. Fills report["input"].
  [[nodiscard]] Result<LoadedMesh> load(Session& session) const;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  Format format_ = Format::automatic;
  Mending mending_;
};

/// --from alone, for commands with two inputs, where it is the format of the one that is '-'.
void add_from(Options& options, Format& format, const std::string& description);

/// The same for points, which XYZ files hold too.
void add_from_points(Options& options, Format& format, const std::string& description);

/// Reads points as load_mesh reads a mesh.
[[nodiscard]] Result<LoadedMesh> load_points(const std::string& path, Format format,
                                             Session& session);

/// Reads a mesh, prints the reader's notices and adds the time to seconds.read.
[[nodiscard]] Result<LoadedMesh> load_mesh(const std::string& path, Format format,
                                           Session& session);

/// For the report: path, vertices, faces, box_side, and, where the topology can be built,
/// components and boundary_loops.
[[nodiscard]] Json mesh_json(const std::string& path, const Mesh& mesh);

/// Of faces that are read and are no triangles.
inline constexpr char kCutPolygons[] = "--triangulate cuts polygons into triangles";

/// What to try on a mesh that was refused with this code ("--repair ..."), or "".
[[nodiscard]] std::string remedy(const Error& error);

}  // namespace surpass::cli

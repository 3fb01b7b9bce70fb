// --surface FILE and --levels N: the limit surface beside a control mesh.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <optional>
#include <string>

#include "mesh_output.hpp"
#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

class SurfaceOutput {
 public:
  /// `and_of` says what else the levels are for.
  void define(Options& options, const std::string& and_of = "");

  /// For commands that have no other use of the levels: fails if they are given without a file.
  [[nodiscard]] Result<void> check_given() const;

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int levels() const { return levels_; }

  /// Before the work: fails where the surface of a control mesh like this one would be too large,
  /// or the file has no place for its faces.
  [[nodiscard]] Result<void> check(const Mesh& control, Scheme scheme,
                                   const MeshOutput& output) const;

  /// The surface, or nothing where none is wanted.
  [[nodiscard]] Result<std::optional<Mesh>> make(const Mesh& control, const Rules& rules,
                                                 Session& session) const;

  /// Writes what `make` made, if it made something.
  [[nodiscard]] Result<void> write(const std::optional<Mesh>& surface, const MeshOutput& output,
                                   Session& session) const;

 private:
  std::string path_;
  int levels_ = 3;
  Option levels_option_;
};

}  // namespace surpass::cli

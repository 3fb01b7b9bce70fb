// Which scheme and which boundary rule: told, recorded in the file, or the default.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <optional>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

class RulesOption {
 public:
  /// --scheme, --boundary and --weights.
  void define(Options& options);

  /// Whether --scheme was given.
  [[nodiscard]] bool names_scheme() const { return scheme_.has_value(); }

  /// The command line wins over what the mesh records (a comment of a control mesh, then
  /// OpenSubdiv's `t interpolateboundary`), and that over the suggested scheme and edge-and-corner.
  /// What is found is noted in report["scheme"] and report["boundary"].
  [[nodiscard]] Rules choose(const Mesh& mesh, Session& session) const;

 private:
  std::optional<Scheme> scheme_;
  std::optional<Boundary> boundary_;
  std::optional<Weights> weights_;
};

/// Makes what the mesh records agree with the rules that it was made by.
void record(const Rules& rules, Mesh& mesh);

}  // namespace surpass::cli

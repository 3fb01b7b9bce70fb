// surpass interpolate --scheme nonstationary-loop: the scheme itself interpolates, so the given
// mesh is the control mesh, and what is written is its surface.
#pragma once

#include <surpass/mesh.hpp>

#include <string>

#include "html_report.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "rules_option.hpp"
#include "session.hpp"

namespace surpass::cli {

/// What the command was asked for.
struct NonstationarySurface {
  const std::string& input;  ///< the given mesh's name
  const RulesOption& rules;
  const Nonstationary& scheme;
  int levels;
  double tolerance;  ///< of the box side
  bool keep_best;
  MeshOutput& output;
  HtmlReport& page;
};

/// Subdivides, certifies before and after rounding, writes. Fails with `not_converged` where the
/// surface misses the given vertices, which without `keep_best` is not written.
[[nodiscard]] Result<void> write_nonstationary_surface(const Mesh& given,
                                                       const NonstationarySurface& wanted,
                                                       Session& session);

}  // namespace surpass::cli

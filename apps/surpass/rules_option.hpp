// Which scheme and which boundary rule: told, recorded in the file, or the default.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/nonstationary.hpp>
#include <surpass/scheme.hpp>

#include <optional>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// The scheme that is no Scheme, for its rules change from level to level.
inline constexpr char kNonstationaryLoop[] = "nonstationary-loop";

class RulesOption {
 public:
  /// --scheme, --boundary and --weights. With `nonstationary`, the scheme may be that, too.
  void define(Options& options, bool nonstationary = false);

  /// Whether it was asked for; then choose() has Loop as the scheme.
  [[nodiscard]] bool nonstationary() const { return nonstationary_; }
  [[nodiscard]] std::optional<LoopWeights> loop_weights() const { return loop_weights_; }
  [[nodiscard]] bool other_weights() const { return weights_.has_value(); }

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
  std::optional<LoopWeights> loop_weights_;
  bool nonstationary_ = false;
};

/// Makes what the mesh records agree with the rules that it was made by.
void record(const Rules& rules, Mesh& mesh);

}  // namespace surpass::cli

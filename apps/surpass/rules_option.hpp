// Which scheme, boundary rule and weights: told, recorded in the file, or the default.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/nonstationary.hpp>
#include <surpass/scheme.hpp>
#include <surpass/similarity.hpp>

#include <optional>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// The scheme that is no Scheme, for its rules change from level to level.
inline constexpr char kNonstationaryLoop[] = "nonstationary-loop";

class RulesOption {
 public:
  /// What the command knows besides surfaces by a Scheme.
  struct Knows {
    bool nonstationary = false;  ///< as a scheme
    bool directions = false;     ///< interpolation by their similarity
  };

  /// --scheme, --boundary and --weights.
  void define(Options& options, Knows knows);

  /// Whether it was asked for; then choose() has Loop as the scheme.
  [[nodiscard]] bool nonstationary() const { return nonstationary_; }
  [[nodiscard]] std::optional<LoopWeights> loop_weights() const { return loop_weights_; }
  [[nodiscard]] std::optional<RowWeights> row_weights() const { return row_weights_; }
  [[nodiscard]] bool other_weights() const { return weights_.has_value(); }

  /// Whether --scheme was given.
  [[nodiscard]] bool names_scheme() const { return scheme_.has_value(); }

  /// The command line wins over what the mesh records (a comment of a control mesh, then
  /// OpenSubdiv's `t interpolateboundary`), and that over the suggested scheme and edge-and-corner.
  /// What is found is noted in report["scheme"], report["boundary"] and, but for the default,
  /// report["weights"].
  [[nodiscard]] Rules choose(const Mesh& mesh, Session& session) const;

 private:
  void define_weights(Options& options, Knows knows);

  std::optional<Scheme> scheme_;
  std::optional<Boundary> boundary_;
  std::optional<Weights> weights_;
  std::optional<LoopWeights> loop_weights_;
  std::optional<RowWeights> row_weights_;
  bool nonstationary_ = false;
};

/// Makes what the mesh records agree with the rules that it was made by.
void record(const Rules& rules, Mesh& mesh);

}  // namespace surpass::cli

// The options of --scheme nonstationary-loop.
#pragma once

#include <surpass/fairness.hpp>
#include <surpass/nonstationary.hpp>

#include <optional>
#include <string>

#include "options.hpp"
#include "rules_option.hpp"
#include "session.hpp"

namespace surpass::cli {

enum class ShapePreset { round, standard, flat };
[[nodiscard]] const char* name_of(ShapePreset preset);

class Nonstationary {
 public:
  /// `measured`: for a command that needs second derivatives, which --rule mean has not.
  void define(Options& options, bool measured = false);

  /// The files that are read besides the mesh.
  [[nodiscard]] std::vector<std::string> inputs() const;

  /// Fails if an option of these was given for another scheme, or two that contradict each other.
  [[nodiscard]] Result<void> check(const RulesOption& rules) const;

  [[nodiscard]] bool has_targets() const { return !targets_path_.empty(); }

  /// What makes the surface the one it is: "shape parameter -1.5".
  [[nodiscard]] std::string summary(const NonstationaryLoop& surface) const;

  /// Prepares the mesh: `steps` 0 solves for the limit. Searches for the shape if it is auto. What
  /// is chosen goes into report["nonstationary"], what the user should know into notes.
  [[nodiscard]] Result<NonstationaryLoop> create(const Mesh& mesh, const RulesOption& rules,
                                                 int steps, Session& session) const;

  /// The same refined `levels` times.
  [[nodiscard]] Result<NonstationaryLoop> refined(const Mesh& mesh, const RulesOption& rules,
                                                  int steps, int levels, Session& session) const;

  /// On from the level where the surface is.
  [[nodiscard]] static Result<void> refine(NonstationaryLoop& surface, int levels,
                                           Session& session);

  /// What create() would take. A shape that is to be found is the best by `measure`.
  [[nodiscard]] Result<NonstationaryOptions> choose(const Mesh& mesh, const RulesOption& rules,
                                                    int steps, Session& session,
                                                    const FairnessOptions& measure = {}) const;

 private:
  [[nodiscard]] Result<double> shape(const Mesh& mesh, const NonstationaryOptions& options,
                                     const FairnessOptions& measure, Session& session) const;
  [[nodiscard]] Result<double> fairest(const Mesh& mesh, const NonstationaryOptions& options,
                                       const FairnessOptions& measure, Session& session) const;

  std::string shape_;
  std::optional<ShapePreset> preset_;
  std::optional<NonstationaryRule> rule_;
  std::optional<ParameterIteration> iteration_;
  double uniform_ = 1;
  Option uniform_option_;
  std::string targets_path_;
  bool keep_folds_ = false;
};

}  // namespace surpass::cli

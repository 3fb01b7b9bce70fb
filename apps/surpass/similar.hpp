// `interpolate --method similarity` and `--method fair`: their options, and the solve.
#pragma once

#include <surpass/requirements.hpp>
#include <surpass/similarity.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh_output.hpp"
#include "options.hpp"
#include "requirements_input.hpp"
#include "rules_option.hpp"
#include "session.hpp"

namespace surpass::cli {

enum class Method { progressive, similarity, fair };
[[nodiscard]] const char* name_of(Method method);

class Similar {
 public:
  void define(Options& options);

  /// The files that are read besides the given mesh.
  [[nodiscard]] std::vector<std::string> inputs() const;

  /// The file for the reference; nothing if it is not asked for.
  [[nodiscard]] std::vector<std::string> outputs() const;

  /// Fails if an option was given that says something of another method only. For
  /// Method::progressive that is any option of these.
  [[nodiscard]] Result<void> check(Method method, const RulesOption& rules) const;

  /// Prepares the given mesh. What is chosen goes into the report. `common` are the options that
  /// all methods have.
  [[nodiscard]] Result<void> prepare(Method method, const InterpolateOptions& common,
                                     const RulesOption& rules, const Mesh& given, Session& session);

  /// The topology of the control mesh.
  [[nodiscard]] const Mesh& control() const { return solver_->refined(); }

  /// Turns the given mesh into the control mesh; its points become `given`, with those in their
  /// place that requirements ask for.
  [[nodiscard]] Result<SolveReport> solve(Mesh& mesh, std::vector<Point>& given, Session& session);

  /// "requirements at most 4.6e-16 of the box side at 3 (...), 9 of them", of what solve() found;
  /// empty if there are none.
  [[nodiscard]] std::string summary_of_requirements() const;

  /// What of them it missed by more than kRequirementTolerance, and why; empty if nothing is.
  [[nodiscard]] std::string missed_requirement() const;

  /// For a control mesh that was written: whether its ring of dummies is lost there as such.
  void note_drawn_ring(const MeshOutput& output, Session& session) const;

  /// Fails where the reference's file has no place for its faces.
  [[nodiscard]] Result<void> check_reference(const MeshOutput& output) const;

  /// Writes the reference, if it is asked for.
  [[nodiscard]] Result<void> write_reference(const MeshOutput& output, Session& session) const;

  [[nodiscard]] Result<std::vector<Point>> limit_positions(std::span<const Point> control,
                                                           const Context& context) const {
    return solver_->limit_positions(control, context);
  }

 private:
  [[nodiscard]] Result<void> load_reference(const Mesh& given, Session& session);
  [[nodiscard]] Result<void> make_reference(const Mesh& given, Session& session);
  void note_ring(Session& session) const;
  [[nodiscard]] Json report_of(const SimilarityReport& report) const;
  /// `side` of the box that the surface was to fill.
  void note_size(double side, std::span<const Point> control, Session& session) const;

  std::optional<Similarity> form_;
  std::optional<Scaling> scaling_;
  std::optional<OpenMeshes> open_;
  SimilarityOptions options_;
  std::string reference_path_;
  std::string reference_output_;
  RequirementsInput requirements_input_;
  std::vector<Requirement> requirements_;
  std::vector<RequirementOutcome> outcomes_;  // of solve()
  std::vector<Point> reference_;              ///< of one's own, as read
  std::optional<Mesh> resembled_;             ///< refined and stretched, where it is to be written
  std::optional<SimilarityInterpolator> solver_;
  Index ring_faces_ = 0;  ///< of the control mesh, its last
  Option thin_plate_;
  Option membrane_;
  Option samples_;
  Option solver_tolerance_;
};

}  // namespace surpass::cli

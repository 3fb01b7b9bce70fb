// --requirements and --normals: what is required of a surface beside the given vertices.
#pragma once

#include <surpass/requirements.hpp>

#include <string>
#include <vector>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

class RequirementsInput {
 public:
  /// `more` ends the description of --requirements.
  void define(Options& options, const std::string& group, const std::string& more);

  [[nodiscard]] bool lists() const { return !list_path_.empty(); }
  [[nodiscard]] bool names_normals() const { return !normals_path_.empty(); }
  [[nodiscard]] bool given() const { return lists() || names_normals(); }

  /// The files that are read.
  [[nodiscard]] std::vector<std::string> inputs() const;

  /// Those of the list, then the normals. `given` as it was mended; `rules` of its surface.
  [[nodiscard]] Result<std::vector<Requirement>> load(const Mesh& given, const Rules& rules,
                                                      Session& session) const;

 private:
  [[nodiscard]] Result<std::vector<Requirement>> load_list(const Mesh& given,
                                                           Session& session) const;
  [[nodiscard]] Result<std::vector<Requirement>> load_normals(const Mesh& given, const Rules& rules,
                                                              Session& session) const;

  std::string list_path_;
  std::string normals_path_;
  bool reverse_normals_ = false;
};

/// For a report: what each is, its error, and of normals and directions the angle and whether it is
/// flipped.
[[nodiscard]] Json outcomes_json(const std::vector<Requirement>& requirements,
                                 const std::vector<RequirementOutcome>& outcomes);

/// The requirement that is missed by most, of at least one.
[[nodiscard]] std::size_t worst_of(const std::vector<RequirementOutcome>& outcomes);

/// What became of that one, or of the first that points the other way, where a surface was looked
/// for, and what helps. Empty if none is missed by more than the tolerance.
[[nodiscard]] std::string why_missed(const std::vector<Requirement>& requirements,
                                     const std::vector<RequirementOutcome>& outcomes,
                                     double tolerance);

}  // namespace surpass::cli

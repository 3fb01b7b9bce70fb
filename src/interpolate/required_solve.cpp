#include "interpolate/required_solve.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "interpolate/requirement_outcomes.hpp"
#include "interpolate/similarity_report.hpp"
#include "interpolate/tangent_lengths.hpp"
#include "interpolate/tangent_wishes.hpp"
#include "mesh/wording.hpp"

namespace surpass {
namespace {

// Redundant are also those that repeat an earlier one at their vertex.
void mark(const RequirementRows& equations, const RowFates& fates,
          std::span<RequirementOutcome> outcomes) {
  const auto is_in = [](const std::vector<unsigned char>& list, std::size_t i) {
    return i < list.size() && list[i] != 0;
  };
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    outcomes[i].redundant = is_in(fates.redundant, i) || equations.repeated[i] != 0;
    outcomes[i].length_chosen = is_in(fates.with_lengths, i);
  }
}

// Nothing is nearer than 4 units in the last place of `points`.
void judge_outcomes(std::span<const Requirement> requirements, std::span<const Point> points,
                    double side, SimilarityReport& report) {
  const double tolerance = floored_tolerance(kRequirementTolerance, flat(points), side);
  auto notes = notes_on(requirements, report.requirements, tolerance);
  if (tolerance > kRequirementTolerance && !all_met(report.requirements, kRequirementTolerance)) {
    notes.push_back(fmt::format(
        "requirements were held to {:.3g} of the box side only: so far from the origin coordinates "
        "do not tell less apart; move the mesh there",
        tolerance));
  }
  std::move(notes.begin(), notes.end(), std::back_inserter(report.solve.notes));
  if (!all_met(report.requirements, tolerance)) report.solve.converged = false;
}

// Again and again with lengths for the tangents that vanished or went the other way, which others
// may for their sake. What cannot be solved with them stays as it was found without.
Result<Found> find_with_tangents(const RequiredTask& task, RequirementRows& equations,
                                 const Context& context) {
  constexpr int kMostRounds = 8;  // two are usual
  Wanted wanted{flat(std::span<const Point>(equations.targets)), flat(task.reference), 3, true,
                task.released};
  if (!equations.rows.empty()) {
    wanted.constraints = [&](const FreeSystem& system, std::span<const double> given,
                             const ConstraintUnits& units) {
      return LinearConstraints::build(equations, task.requirements, system, given, units);
    };
  }
  auto found = find(task.prepared, wanted, context);
  for (int round = 1; found && round < kMostRounds; ++round) {
    const std::size_t before = equations.rows.size();
    if (!add_tangent_lengths(task.requirements, points_of(found->values),
                             points_of(found->reference), equations)) {
      break;
    }
    auto again = find(task.prepared, wanted, context);
    if (!again && again.error().code != ErrorCode::cancelled) {
      equations.rows.resize(before);
      break;
    }
    found = std::move(again);
  }
  return found;
}

void note_lengths(std::span<const Requirement> requirements, SimilarityReport& report) {
  const auto& outcomes = report.requirements;
  const auto has_length = std::mem_fn(&RequirementOutcome::length_chosen);
  const auto count = std::count_if(outcomes.begin(), outcomes.end(), has_length);
  if (count == 0) return;
  const auto first = std::find_if(outcomes.begin(), outcomes.end(), has_length);
  const auto number = static_cast<std::size_t>(first - outcomes.begin());
  report.solve.notes.push_back(fmt::format(
      "the tangents of {} would have vanished or gone the other way and were given lengths, by the "
      "reference; the first: {}, {}",
      counted(static_cast<std::size_t>(count), "requirement", "requirements"), number,
      describe(requirements[number])));
}

}  // namespace

Result<SimilaritySolution> solve_required_task(const RequiredTask& task, RequirementRows equations,
                                               const Context& context) {
  const SimilarityPrepared& prepared = task.prepared;
  auto found = find_with_tangents(task, equations, context);
  if (!found) return tl::make_unexpected(found.error());
  Mesh control = prepared.refined;
  control.points = points_of(found->values);
  std::vector<Point>& targets = equations.targets;
  const double extent = bounding_box(targets).side();
  const double side = extent > 0 ? extent : 1;
  // Nothing is missed at vertices that were let go.
  const auto limits = limits_of(prepared, control.points, context);
  for (std::size_t v = 0; v < equations.released.size(); ++v) {
    if (equations.released[v] != 0) targets[v] = limits[v];
  }
  SimilaritySolution solution;
  solution.points = control.points;
  solution.report = similarity_report(prepared, *found, limits, targets, extent, context);
  if (auto ok = check_planes(task.requirements, equations, control.points,
                             points_of(found->reference), side, found->fates.opposed);
      !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto outcomes = requirement_outcomes(control, prepared.options.rules, limits, equations,
                                       task.requirements, side, context);
  if (!outcomes) return tl::make_unexpected(outcomes.error());
  solution.report.requirements = std::move(*outcomes);
  mark(equations, found->fates, solution.report.requirements);
  note_lengths(task.requirements, solution.report);
  judge_outcomes(task.requirements, targets, side, solution.report);
  solution.targets = std::move(targets);
  return solution;
}

}  // namespace surpass

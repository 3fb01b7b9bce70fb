// Interpolation by similarity. Lai and Cheng, Similarity based interpolation using Catmull-Clark
// subdivision surfaces, 2006: section 2.2 (the explicit requirement), 2.3 and 2.4 (directions).
// Beyond the paper: the vectors form, preconditioned conjugate gradients in the place of Gauss and
// Seidel, nothing assembled; and Halstead, Kass and DeRose's energies on the same machinery.
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "interpolate/linear_system.hpp"
#include "interpolate/requirement_outcomes.hpp"
#include "interpolate/requirement_places.hpp"
#include "interpolate/similarity_report.hpp"
#include "interpolate/tangent_lengths.hpp"
#include "interpolate/tangent_wishes.hpp"
#include "mesh/wording.hpp"

namespace surpass {

struct SimilarityInterpolator::Impl : SimilarityPrepared {};

namespace {

Result<void> require_numbers(std::span<const double> values, std::size_t width, const char* what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return fail(ErrorCode::not_finite, fmt::format("{} is not a finite number", what),
                {.vertex = static_cast<Index>(i / width)});
  }
  return {};
}

Result<void> check_channel(const Channel& channel, std::size_t vertices) {
  if (channel.values.size() != vertices * channel.width()) {
    return fail(ErrorCode::mismatch, fmt::format("channel \"{}\" has {} values for {} vertices",
                                                 channel.name, channel.values.size(), vertices));
  }
  return require_numbers(channel.values, channel.width(), "a channel's value");
}

}  // namespace

SimilarityInterpolator::SimilarityInterpolator(std::unique_ptr<const Impl> impl)
    : impl_(std::move(impl)) {}
SimilarityInterpolator::SimilarityInterpolator(SimilarityInterpolator&&) noexcept = default;
SimilarityInterpolator& SimilarityInterpolator::operator=(SimilarityInterpolator&&) noexcept =
    default;
SimilarityInterpolator::~SimilarityInterpolator() = default;

Result<SimilarityInterpolator> SimilarityInterpolator::create(const Mesh& mesh,
                                                              const SimilarityOptions& options,
                                                              const Context& context) {
  auto prepared = prepare_similarity(mesh, options, context);
  if (!prepared) return tl::make_unexpected(prepared.error());
  return SimilarityInterpolator(std::make_unique<const Impl>(Impl{std::move(*prepared)}));
}

const Mesh& SimilarityInterpolator::refined() const { return impl_->refined; }

Result<SimilaritySolution> SimilarityInterpolator::solve(std::span<const Point> points,
                                                         std::span<const Channel> channels,
                                                         const Context& context) const {
  return solve_like({}, points, channels, context);
}

namespace {

Result<void> check_input(const SimilarityPrepared& prepared, std::span<const Point> reference,
                         std::span<const Point> points) {
  if (points.size() != prepared.given_count()) {
    return fail(ErrorCode::mismatch, fmt::format("{} points were given for a mesh of {} vertices",
                                                 points.size(), prepared.given_count()));
  }
  if (!reference.empty() && reference.size() != prepared.given_count() &&
      reference.size() != prepared.control_count()) {
    return fail(ErrorCode::mismatch,
                fmt::format("the reference has {} vertices; it must have the {} of the given mesh "
                            "or the {} of that mesh refined once",
                            reference.size(), prepared.given_count(), prepared.control_count()));
  }
  for (const auto values : {flat(points), flat(reference)}) {
    if (auto ok = require_numbers(values, 3, "a coordinate"); !ok) return ok;
  }
  return {};
}

// Channels know of no requirements: they keep the values of all given vertices.
Result<void> carry_channels(const SimilarityPrepared& prepared, std::span<const Channel> channels,
                            const Context& context, SimilaritySolution& solution) {
  for (const Channel& channel : channels) {
    if (auto ok = check_channel(channel, prepared.given_count()); !ok) return ok;
    auto carried =
        find(prepared, {channel.values, {}, channel.width(), false, prepared.elimination}, context);
    if (!carried) return tl::make_unexpected(carried.error());
    solution.channels.emplace_back(channel).values = std::move(carried->values);
  }
  return {};
}

// `limits`: of the given vertices, on the surface that was found; `points`: what they are to be.
SimilaritySolution solution_of(const SimilarityPrepared& prepared, Found& found,
                               std::vector<Point> control, std::span<const Point> limits,
                               std::span<const Point> points, double side, const Context& context) {
  SimilaritySolution solution;
  solution.points = std::move(control);
  solution.report = similarity_report(prepared, found, limits, points, side, context);
  return solution;
}

}  // namespace

Result<SimilaritySolution> SimilarityInterpolator::solve_like(std::span<const Point> reference,
                                                              std::span<const Point> points,
                                                              std::span<const Channel> channels,
                                                              const Context& context) const {
  const SimilarityPrepared& prepared = *impl_;
  if (auto ok = check_input(prepared, reference, points); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto found =
      find(prepared, {flat(points), flat(reference), 3, true, prepared.elimination}, context);
  if (!found) return tl::make_unexpected(found.error());
  std::vector<Point> control = points_of(found->values);
  const auto limits = limits_of(prepared, control, context);
  SimilaritySolution solution = solution_of(prepared, *found, std::move(control), limits, points,
                                            bounding_box(points).side(), context);
  if (auto ok = carry_channels(prepared, channels, context, solution); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return solution;
}

namespace {

// Requirements that repeat an earlier one at their vertex, and those whose equations were dropped.
void mark_redundant(const RequirementRows& equations, const Found& found,
                    std::span<RequirementOutcome> outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const bool dropped = i < found.redundant.size() && found.redundant[i] != 0;
    outcomes[i].redundant = dropped || equations.repeated[i] != 0;
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

// Its points are not known yet.
Mesh control_mesh(const SimilarityPrepared& prepared) {
  Mesh control = prepared.refined;
  control.points.resize(prepared.control_count());
  return control;
}

// Again and again with lengths for the tangents that vanished or went the other way, which others
// may for their sake. What cannot be solved with them stays as it was found without.
Result<Found> find_with_tangents(const SimilarityPrepared& prepared, const Wanted& wanted,
                                 RequirementRows& equations, const Context& context) {
  constexpr int kMostRounds = 8;  // two are usual
  auto found = find(prepared, wanted, context);
  for (int round = 1; found && round < kMostRounds; ++round) {
    const std::size_t before = equations.rows.size();
    if (!add_tangent_lengths(wanted.requirements, points_of(found->values),
                             points_of(found->reference), equations)) {
      break;
    }
    auto again = find(prepared, wanted, context);
    if (!again && again.error().code != ErrorCode::cancelled) {
      equations.rows.resize(before);
      break;
    }
    found = std::move(again);
  }
  return found;
}

void note_lengths(const RequirementRows& equations, std::span<const Requirement> requirements,
                  SimilarityReport& report) {
  const auto with = with_lengths(requirements.size(), equations);
  const auto first = std::find(with.begin(), with.end(), 1);
  if (first == with.end()) return;
  const auto number = static_cast<std::size_t>(first - with.begin());
  report.solve.notes.push_back(fmt::format(
      "the tangents of {} would have vanished or gone the other way and were given lengths, by the "
      "reference; the first: "
      "{}, {}",
      counted(static_cast<std::size_t>(std::count(first, with.end(), 1)), "requirement",
              "requirements"),
      number, describe(requirements[number])));
}

Result<RequirementRows> equations_of(const SimilarityPrepared& prepared, const Mesh& control,
                                     std::span<const Requirement> requirements,
                                     std::span<const Point> points, const Context& context) {
  Mesh given = prepared.given;
  given.points.assign(points.begin(), points.end());
  return requirement_rows(control, prepared.options.rules, given, requirements, context);
}

}  // namespace

Result<SimilaritySolution> SimilarityInterpolator::solve_required(
    std::span<const Requirement> requirements, std::span<const Point> points,
    std::span<const Point> reference, std::span<const Channel> channels,
    const Context& context) const {
  const SimilarityPrepared& prepared = *impl_;
  if (requirements.empty()) {
    auto plain = solve_like(reference, points, channels, context);
    if (plain) plain->targets.assign(points.begin(), points.end());
    return plain;
  }
  if (auto ok = check_input(prepared, reference, points); !ok) {
    return tl::make_unexpected(ok.error());
  }
  const Rules& rules = prepared.options.rules;
  const std::vector<Requirement> asked = canonical(requirements);
  Mesh control = control_mesh(prepared);
  auto equations = equations_of(prepared, control, asked, points, context);
  if (!equations) return tl::make_unexpected(equations.error());
  auto released = Elimination::build(prepared.elimination.limits(),
                                     static_cast<Index>(prepared.control_count()), context,
                                     equations->released);
  if (!released) return tl::make_unexpected(released.error());
  std::vector<Point>& targets = equations->targets;
  auto found = find_with_tangents(prepared,
                                  {flat(std::span<const Point>(targets)), flat(reference), 3, true,
                                   *released, &*equations, asked},
                                  *equations, context);
  if (!found) return tl::make_unexpected(found.error());
  control.points = points_of(found->values);
  const double extent = bounding_box(targets).side();
  const double side = extent > 0 ? extent : 1;
  // Nothing is missed at vertices that were let go.
  const auto limits = limits_of(prepared, control.points, context);
  for (std::size_t v = 0; v < equations->released.size(); ++v) {
    if (equations->released[v] != 0) targets[v] = limits[v];
  }
  SimilaritySolution solution =
      solution_of(prepared, *found, control.points, limits, targets, extent, context);
  if (auto ok = check_planes(asked, *equations, control.points, side, found->opposed); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto outcomes = requirement_outcomes(control, rules, limits, *equations, asked, side, context);
  if (!outcomes) return tl::make_unexpected(outcomes.error());
  solution.report.requirements = std::move(*outcomes);
  mark_redundant(*equations, *found, solution.report.requirements);
  note_lengths(*equations, asked, solution.report);
  judge_outcomes(asked, targets, side, solution.report);
  solution.targets = std::move(targets);
  if (auto ok = carry_channels(prepared, channels, context, solution); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return solution;
}

Result<std::vector<Point>> SimilarityInterpolator::reference(
    std::span<const Point> points, std::span<const Point> own,
    std::span<const Requirement> requirements, const Context& context) const {
  const SimilarityPrepared& prepared = *impl_;
  if (auto ok = check_input(prepared, own, points); !ok) return tl::make_unexpected(ok.error());
  std::vector<Point> targets(points.begin(), points.end());
  if (!requirements.empty()) {
    auto equations =
        equations_of(prepared, control_mesh(prepared), canonical(requirements), points, context);
    if (!equations) return tl::make_unexpected(equations.error());
    targets = std::move(equations->targets);
  }
  const auto values = reference_of(
      prepared, {flat(std::span<const Point>(targets)), flat(own), 3, true, prepared.elimination},
      context);
  if (!values) return tl::make_unexpected(values.error());
  return points_of(*values);
}

Result<std::vector<Point>> SimilarityInterpolator::limit_positions(std::span<const Point> control,
                                                                   const Context& context) const {
  if (control.size() != impl_->control_count()) {
    return fail(ErrorCode::mismatch,
                fmt::format("{} points were given for a control mesh of {} vertices",
                            control.size(), impl_->control_count()));
  }
  return limits_of(*impl_, control, context);
}

Result<SimilarityInterpolated> interpolate_similar(const Mesh& mesh,
                                                   const SimilarityOptions& options,
                                                   const Context& context) {
  return interpolate_required(mesh, {}, options, context);
}

Result<SimilarityInterpolated> interpolate_required(const Mesh& mesh,
                                                    std::span<const Requirement> requirements,
                                                    const SimilarityOptions& options,
                                                    const Context& context) {
  const auto solver = SimilarityInterpolator::create(mesh, options, context);
  if (!solver) return tl::make_unexpected(solver.error());
  auto solution = solver->solve_required(requirements, mesh.points, {}, mesh.channels, context);
  if (!solution) return tl::make_unexpected(solution.error());
  SimilarityInterpolated result{solver->refined(), std::move(solution->report)};
  result.control.points = std::move(solution->points);
  result.control.channels = std::move(solution->channels);
  return result;
}

}  // namespace surpass

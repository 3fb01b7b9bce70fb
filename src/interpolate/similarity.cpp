// Interpolation by similarity. Lai and Cheng, Similarity based interpolation using Catmull-Clark
// subdivision surfaces, 2006: section 2.2 (the explicit requirement), 2.3 and 2.4 (directions).
// Beyond the paper: the vectors form, preconditioned conjugate gradients in the place of Gauss and
// Seidel, nothing assembled; and Halstead, Kass and DeRose's energies on the same machinery.
#include <cmath>

#include <fmt/format.h>

#include "interpolate/linear_system.hpp"
#include "interpolate/required_solve.hpp"
#include "interpolate/requirement_places.hpp"
#include "interpolate/similarity_report.hpp"

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
  SimilaritySolution solution;
  solution.points = points_of(found->values);
  solution.report =
      similarity_report(prepared, *found, limits_of(prepared, solution.points, context), points,
                        bounding_box(points).side(), context);
  if (auto ok = carry_channels(prepared, channels, context, solution); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return solution;
}

namespace {

Result<RequirementRows> equations_of(const SimilarityPrepared& prepared,
                                     std::span<const Requirement> requirements,
                                     std::span<const Point> points, const Context& context) {
  Mesh given = prepared.given;
  given.points.assign(points.begin(), points.end());
  Mesh control = prepared.refined;
  control.points.resize(prepared.control_count());  // they are not known yet
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
  const std::vector<Requirement> asked = canonical(requirements);
  auto equations = equations_of(prepared, asked, points, context);
  if (!equations) return tl::make_unexpected(equations.error());
  const auto released = Elimination::build(prepared.elimination.limits(),
                                           static_cast<Index>(prepared.control_count()), context,
                                           equations->released);
  if (!released) return tl::make_unexpected(released.error());
  auto solution =
      solve_required_task({prepared, asked, *released, reference}, std::move(*equations), context);
  if (!solution) return solution;
  if (auto ok = carry_channels(prepared, channels, context, *solution); !ok) {
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
    auto equations = equations_of(prepared, canonical(requirements), points, context);
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

namespace {

SimilarityInterpolated with_mesh(const SimilarityInterpolator& solver,
                                 SimilaritySolution solution) {
  SimilarityInterpolated result{solver.refined(), std::move(solution.report)};
  result.control.points = std::move(solution.points);
  result.control.channels = std::move(solution.channels);
  return result;
}

}  // namespace

// Not interpolate_required() without any: what solves for requirements is a third of a megabyte,
// which programs without them (the studio) need not carry.
Result<SimilarityInterpolated> interpolate_similar(const Mesh& mesh,
                                                   const SimilarityOptions& options,
                                                   const Context& context) {
  const auto solver = SimilarityInterpolator::create(mesh, options, context);
  if (!solver) return tl::make_unexpected(solver.error());
  auto solution = solver->solve(mesh.points, mesh.channels, context);
  if (!solution) return tl::make_unexpected(solution.error());
  return with_mesh(*solver, std::move(*solution));
}

Result<SimilarityInterpolated> interpolate_required(const Mesh& mesh,
                                                    std::span<const Requirement> requirements,
                                                    const SimilarityOptions& options,
                                                    const Context& context) {
  const auto solver = SimilarityInterpolator::create(mesh, options, context);
  if (!solver) return tl::make_unexpected(solver.error());
  auto solution = solver->solve_required(requirements, mesh.points, {}, mesh.channels, context);
  if (!solution) return tl::make_unexpected(solution.error());
  return with_mesh(*solver, std::move(*solution));
}

}  // namespace surpass

// Interpolation by similarity. Lai and Cheng, Similarity based interpolation using Catmull-Clark
// subdivision surfaces, 2006: section 2.2 (the explicit requirement), 2.3 and 2.4 (directions).
// Beyond the paper: the vectors form, preconditioned conjugate gradients in the place of Gauss and
// Seidel, nothing assembled; and Halstead, Kass and DeRose's energies on the same machinery.
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "interpolate/linear_constraints.hpp"
#include "interpolate/linear_system.hpp"
#include "interpolate/requirement_outcomes.hpp"
#include "interpolate/similarity_prepared.hpp"
#include "interpolate/tangent_lengths.hpp"
#include "interpolate/tangent_wishes.hpp"
#include "mesh/wording.hpp"
#include "scheme/limit_points.hpp"

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

// Shifts and scales numbers to the neighbourhood of 0 and 1, so that squares of them neither
// overflow nor lose what matters, and the other way.
struct Units {
  std::vector<double> centre;  // a number per column
  double scale = 1;            // a power of two

  void enter(const Context& context, std::span<double> x) const {
    for_all(context, x, [&](double value, double middle) { return (value - middle) * scale; });
  }
  void leave(const Context& context, std::span<double> x) const {
    for_all(context, x, [&](double value, double middle) { return value / scale + middle; });
  }

 private:
  template <class Change>
  void for_all(const Context& context, std::span<double> x, Change&& change) const {
    if (x.empty()) return;
    const std::size_t width = centre.size();
    parallel::for_ranges(context, x.size() / width, [&](std::size_t begin, std::size_t end) {
      double* at = x.data() + begin * width;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < width; ++c, ++at) *at = change(*at, centre[c]);
      }
    });
  }
};

// Of the vertices that have faces: others may be so far away that nothing were left of these.
Result<Units> units_of(const SimilarityPrepared& prepared, std::span<const double> values,
                       std::size_t width) {
  std::vector<double> low(width, HUGE_VAL);
  std::vector<double> high(width, -HUGE_VAL);
  for (std::size_t i = 0; i < prepared.given_count(); ++i) {
    if (prepared.isolated[i] != 0) continue;
    const double* at = values.data() + i * width;
    for (std::size_t c = 0; c < width; ++c) {
      low[c] = std::min(low[c], at[c]);
      high[c] = std::max(high[c], at[c]);
    }
  }
  Units units{std::vector<double>(width, 0.0)};
  double side = 0;
  for (std::size_t c = 0; c < width && low[c] <= high[c]; ++c) {
    units.centre[c] = low[c] / 2 + high[c] / 2;
    side = std::max(side, high[c] - low[c]);
  }
  if (!std::isfinite(side)) {
    return fail(ErrorCode::not_finite,
                "the coordinates are so large that their differences overflow");
  }
  units.scale = power_of_two_scale(side > 0 ? side : 1);
  return units;
}

struct Wanted {
  std::span<const double> given;      // #given by width
  std::span<const double> reference;  // #given or #control by width; empty: the given points
  std::size_t width;
  bool positions;  // and not a channel
  const Elimination& elimination;
  const RequirementRows* equations = nullptr;  // besides the given vertices; for positions
  std::span<const Requirement> requirements = {};
};

// Control values, #control by width, and how they were found.
struct Found {
  std::vector<double> values;
  std::vector<double> reference;
  std::vector<double> scale;
  FreeOutcome outcome;
  std::vector<unsigned char> redundant;  // #requirements
  std::set<std::size_t> opposed;         // LinearConstraints::opposed()
};

std::vector<double> refined_reference(const SimilarityPrepared& prepared, const Wanted& wanted,
                                      const Context& context) {
  const std::span<const double> source = wanted.reference.empty() ? wanted.given : wanted.reference;
  const std::size_t values = prepared.control_count() * wanted.width;
  if (source.size() == values) return {source.begin(), source.end()};
  return refine_given(prepared, wanted.width, source, context);
}

// They are where they are given, in the reference, too.
void keep_isolated(const SimilarityPrepared& prepared, const Wanted& wanted,
                   std::span<const double> given, std::span<double> x) {
  for (Index i = 0; i < prepared.given_count(); ++i) {
    if (prepared.isolated[i] == 0) continue;
    const std::size_t j = wanted.elimination.limits().row_columns(i).front();
    for (std::size_t c = 0; c < wanted.width; ++c) {
      x[j * wanted.width + c] = given[i * wanted.width + c];
    }
  }
}

// The given numbers and the reference that they are to resemble, in units.
struct Start {
  Units units;
  std::vector<double> given;
  std::vector<double> reference;
  std::vector<double> scale;  // that the reference was stretched by
};

Result<Start> start_of(const SimilarityPrepared& prepared, const Wanted& wanted,
                       const Context& context) {
  auto units = units_of(prepared, wanted.given, wanted.width);
  if (!units) return tl::make_unexpected(units.error());
  Start start{std::move(*units),
              {wanted.given.begin(), wanted.given.end()},
              refined_reference(prepared, wanted, context),
              {}};
  start.units.enter(context, start.given);
  start.units.enter(context, start.reference);
  start.scale = scale_reference(prepared, prepared.options.scaling, wanted.width, start.given,
                                context, start.reference);
  keep_isolated(prepared, wanted, start.given, start.reference);
  return start;
}

void leave_reference(const SimilarityPrepared& prepared, const Wanted& wanted, const Units& units,
                     const Context& context, std::span<double> reference) {
  units.leave(context, reference);
  keep_isolated(prepared, wanted, wanted.given, reference);
}

// The energy's derivative at x by the free points; empty where x is where the energy is least.
std::vector<double> gradient_at(const SimilarityPrepared& prepared, const FreeSystem& system,
                                std::span<const double> reference, std::span<const double> x) {
  std::vector<double> difference(x.begin(), x.end());
  if (prepared.options.similarity != Similarity::fair) {
    // Only the difference to the reference costs, and it may be nothing but rounding.
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      difference[i] -= reference[i];
      largest = std::max(largest, std::abs(difference[i]));
    }
    constexpr double kRounding = 1e-14;  // coordinates are near 1
    if (largest <= kRounding) return {};
  }
  std::vector<double> gradient(x.size());
  system.energy.product(system.context, system.width, Precision::full, difference, gradient);
  system.elimination.restrict_gradient(system.context, system.width, gradient);
  return gradient;
}

// Where a step of progressive interpolation leads: what the reference misses the given points by,
// added to its control mesh before the refinement. Far from a vertex little moves at once, and what
// is left to do is local.
std::vector<double> progressive_step(const SimilarityPrepared& prepared, const FreeSystem& system,
                                     std::span<const double> reference,
                                     std::span<const double> given) {
  const std::size_t width = system.width;
  std::vector<double> missed(given.size());
  system.elimination.limits().apply(system.context, width, reference, missed);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool released = system.elimination.dependent(static_cast<Index>(i / width)) == kNone;
    missed[i] = released ? 0 : given[i] - missed[i];
  }
  return refine_given(prepared, width, missed, system.context);
}

// x = the reference where points are free, moved to where the energy is least; in units.
FreeOutcome minimise(const SimilarityPrepared& prepared, const FreeSystem& system,
                     std::span<const double> reference, std::span<const double> given,
                     std::span<double> x) {
  std::vector<double> gradient = gradient_at(prepared, system, reference, x);
  if (gradient.empty()) return {};
  const StopAt stop{prepared.options.solver_tolerance, prepared.options.max_iterations};
  if (prepared.options.solver != SimilaritySolver::gauss_seidel) {
    return conjugate_gradient(system, stop, progressive_step(prepared, system, reference, given),
                              gradient, x);
  }
  std::vector<double> change(x.size(), 0.0);
  FreeOutcome outcome = gauss_seidel(system, *prepared.layout, stop, gradient, change);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += change[i];
  return outcome;
}

Result<std::optional<LinearConstraints>> constraints_of(const Wanted& wanted,
                                                        const FreeSystem& system,
                                                        std::span<const double> given,
                                                        const Units& units) {
  if (wanted.equations == nullptr || wanted.equations->rows.empty()) return std::nullopt;
  const LinearConstraints::Units own{{units.centre[0], units.centre[1], units.centre[2]},
                                     units.scale};
  auto built = LinearConstraints::build(*wanted.equations, wanted.requirements, system, given, own);
  if (!built) return tl::make_unexpected(built.error());
  return std::move(*built);
}

Result<Found> find(const SimilarityPrepared& prepared, const Wanted& wanted,
                   const Context& context) {
  auto start = start_of(prepared, wanted, context);
  if (!start) return tl::make_unexpected(start.error());
  const Units& units = start->units;
  const std::vector<double>& given = start->given;
  Found found;
  found.reference = std::move(start->reference);
  found.scale = std::move(start->scale);
  found.values = found.reference;
  wanted.elimination.meet(context, wanted.width, given, found.values);

  const SimilarityOptions& options = prepared.options;
  const bool directions = options.similarity == Similarity::directions && wanted.positions;
  std::unique_ptr<PatchEnergy> own;
  if (directions && options.max_iterations > 0) {
    own = cross_products(*prepared.layout, found.reference, options.row_weights, context);
  }
  FreeSystem system{wanted.elimination, own ? *own : *prepared.scalar, wanted.width, context};
  auto constraints = constraints_of(wanted, system, given, units);
  if (!constraints) return tl::make_unexpected(constraints.error());
  if (*constraints) {
    system.constraints = &**constraints;
    system.constraints->meet(context, found.values, true);
    found.redundant = system.constraints->redundant();
    found.opposed = system.constraints->opposed();
  }
  if (options.max_iterations > 0) {
    found.outcome = minimise(prepared, system, found.reference, given, found.values);
  }
  if (found.outcome.cancelled) return fail(ErrorCode::cancelled, "cancelled while solving");
  units.leave(context, found.values);
  leave_reference(prepared, wanted, units, context, found.reference);
  // Once more from the given numbers themselves: exact to the last rounding.
  wanted.elimination.meet(context, wanted.width, wanted.given, found.values);
  if (*constraints) {
    system.constraints->meet(context, found.values, false);
    wanted.elimination.meet(context, wanted.width, wanted.given, found.values);
  }
  return found;
}

Result<std::vector<double>> reference_of(const SimilarityPrepared& prepared, const Wanted& wanted,
                                         const Context& context) {
  auto start = start_of(prepared, wanted, context);
  if (!start) return tl::make_unexpected(start.error());
  leave_reference(prepared, wanted, start->units, context, start->reference);
  return std::move(start->reference);
}

Result<void> check_channel(const Channel& channel, std::size_t vertices) {
  if (channel.values.size() != vertices * channel.width()) {
    return fail(ErrorCode::mismatch, fmt::format("channel \"{}\" has {} values for {} vertices",
                                                 channel.name, channel.values.size(), vertices));
  }
  return require_numbers(channel.values, channel.width(), "a channel's value");
}

std::vector<Point> points_of(std::span<const double> values) {
  std::vector<Point> points(values.size() / 3);
  std::copy(values.begin(), values.end(), flat(std::span(points)).begin());
  return points;
}

// Of the given vertices.
std::vector<Point> limits_of(const SimilarityPrepared& prepared, std::span<const Point> control,
                             const Context& context) {
  return limit_points(prepared.elimination.limits(), control, context);
}

Iteration error_of(std::span<const Point> limit, std::span<const Point> points, double side) {
  Iteration error;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double distance =
        std::hypot((limit[v][0] - points[v][0]) / side, (limit[v][1] - points[v][1]) / side,
                   (limit[v][2] - points[v][2]) / side);
    if (distance > error.max || std::isnan(distance)) error.max = distance;
    error.mean += distance / static_cast<double>(points.size());
  }
  return error;
}

// A row may stand for several samples, also of the neighbour. Thirds of them are of rows that share
// the samples of others.
std::size_t derivative_count(const PatchRows& rows) {
  std::vector<double> of_kind;
  for (const PatchKind& kind : rows.kinds()) {
    of_kind.push_back(std::accumulate(kind.count.begin(), kind.count.end(), 0.0));
  }
  double count = 0;
  for (std::size_t p = 0; p < rows.patch_count(); ++p) count += of_kind[rows.kind_number(p)];
  return static_cast<std::size_t>(std::llround(count));
}

void fill_report(const SimilarityPrepared& prepared, Found& found, std::span<const Point> limits,
                 std::span<const Point> points, const Context& context, SimilarityReport& report) {
  const SimilarityOptions& options = prepared.options;
  const double side = bounding_box(points).side();
  const double unit = side > 0 ? side : 1;
  report.solve.box_side = side;
  report.solve.tolerance = floored_tolerance(options.tolerance, flat(points), unit);
  report.solve.solver = name_of(options.solver);
  report.solve.iterations = found.outcome.iterations;
  report.solve.initial =
      error_of(limits_of(prepared, points_of(found.reference), context), points, unit);
  report.solve.final = error_of(limits, points, unit);
  report.solve.final.iteration = found.outcome.iterations;
  report.solve.converged = report.solve.final.max <= report.solve.tolerance;
  report.residuals = std::move(found.outcome.residuals);
  std::copy_n(found.scale.begin(), 3, report.scale.begin());
  report.free_vertices = prepared.control_count() - prepared.given_count();
  report.derivatives = derivative_count(prepared.layout->rows());
}

// Whether the system was solved, and what to say if not.
void judge_residual(const SimilarityPrepared& prepared, const FreeOutcome& outcome,
                    SimilarityReport& report) {
  const SimilarityOptions& options = prepared.options;
  report.residual = report.residuals.empty() ? 0 : report.residuals.back();
  report.solver_converged = report.residual <= options.solver_tolerance;
  if (options.max_iterations == 0) {
    report.residual = 1;
    report.solver_converged = false;
    report.solve.notes.emplace_back(
        "no iterations were allowed: the free vertices are those of the reference");
  } else if (!report.solver_converged) {
    report.solve.notes.push_back(
        fmt::format("the residual is {:.3g} of that at the start after {}, above the solver's "
                    "tolerance {:.3g}; the surface interpolates all the same",
                    report.residual, counted(outcome.iterations, "iteration", "iterations"),
                    options.solver_tolerance));
  }
}

// Where the points are small differences of large ones.
void judge_reference(const Found& found, double side, SimilarityReport& report) {
  constexpr double kMuchLarger = 1e3;
  if (report.solve.converged) return;
  const double times = bounding_box(points_of(found.reference)).side() / (side > 0 ? side : 1);
  if (!(times > kMuchLarger)) return;
  report.solve.notes.push_back(
      fmt::format("the reference is {:.3g} times as large as the given mesh, and so are rounding "
                  "errors, which is why the surface misses the given vertices; scale the reference",
                  times));
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
                               std::span<const Point> points, const Context& context) {
  SimilaritySolution solution;
  solution.points = std::move(control);
  fill_report(prepared, found, limits, points, context, solution.report);
  judge_reference(found, bounding_box(points).side(), solution.report);
  judge_residual(prepared, found.outcome, solution.report);
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
  SimilaritySolution solution =
      solution_of(prepared, *found, std::move(control), limits, points, context);
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
  const double tolerance = floored_tolerance(1e-10, flat(points), side);
  auto notes = notes_on(requirements, report.requirements, tolerance);
  std::move(notes.begin(), notes.end(), std::back_inserter(report.solve.notes));
  if (!all_met(report.requirements, tolerance)) report.solve.converged = false;
}

// Its points are not known yet.
Mesh control_mesh(const SimilarityPrepared& prepared) {
  Mesh control = prepared.refined;
  control.points.resize(prepared.control_count());
  return control;
}

// Again and again with lengths for the tangents that vanished, which others may for their sake.
// What cannot be solved with them stays as it was found without.
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
    if (!again) fprintf(stderr, "AGAIN %s\n", again.error().message.c_str());
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
      "the tangents of {} would have vanished and were given lengths, by the reference; the first: "
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
  Mesh control = control_mesh(prepared);
  auto equations = equations_of(prepared, control, requirements, points, context);
  if (!equations) return tl::make_unexpected(equations.error());
  auto released = Elimination::build(prepared.elimination.limits(),
                                     static_cast<Index>(prepared.control_count()), context,
                                     equations->released);
  if (!released) return tl::make_unexpected(released.error());
  std::vector<Point>& targets = equations->targets;
  auto found = find_with_tangents(prepared,
                                  {flat(std::span<const Point>(targets)), flat(reference), 3, true,
                                   *released, &*equations, requirements},
                                  *equations, context);
  if (!found) return tl::make_unexpected(found.error());
  control.points = points_of(found->values);
  // Nothing is missed at vertices that were let go.
  const auto limits = limits_of(prepared, control.points, context);
  for (std::size_t v = 0; v < equations->released.size(); ++v) {
    if (equations->released[v] != 0) targets[v] = limits[v];
  }
  SimilaritySolution solution =
      solution_of(prepared, *found, control.points, limits, targets, context);
  const double extent = bounding_box(targets).side();
  const double side = extent > 0 ? extent : 1;
  if (auto ok = check_planes(requirements, *equations, control.points, side, found->opposed); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto outcomes =
      requirement_outcomes(control, rules, limits, *equations, requirements, side, context);
  if (!outcomes) return tl::make_unexpected(outcomes.error());
  solution.report.requirements = std::move(*outcomes);
  mark_redundant(*equations, *found, solution.report.requirements);
  note_lengths(*equations, requirements, solution.report);
  judge_outcomes(requirements, targets, side, solution.report);
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
    auto equations = equations_of(prepared, control_mesh(prepared), requirements, points, context);
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

// Progressive interpolation. Cheng, Fan, Lai, Huang, Wang, Yong: Loop subdivision surface based
// progressive interpolation, J. Comput. Sci. Technol. 24(1), 2009. Beyond the paper: one two-stage
// solve for every curve (its section 4 has it for boundaries), and faster solvers of the same
// equation.
#include <surpass/interpolate.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpolate/a_priori.hpp"
#include "interpolate/block_solver.hpp"

namespace surpass {

const char* name_of(Solver solver) {
  switch (solver) {
    case Solver::chebyshev: return "chebyshev";
    case Solver::richardson: return "richardson";
    case Solver::conjugate_gradient: return "conjugate-gradient";
    case Solver::gauss_seidel: return "gauss-seidel";
  }
  return "unknown";
}

Result<Solver> solver_named(std::string_view name) {
  for (const Solver s :
       {Solver::chebyshev, Solver::richardson, Solver::conjugate_gradient, Solver::gauss_seidel}) {
    if (name == name_of(s)) return s;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no solver \"{}\"; there are chebyshev, richardson, "
                          "conjugate-gradient and gauss-seidel",
                          name));
}

struct Interpolator::Impl {
  InterpolateOptions options;
  LimitOperator op;
  Blocks blocks;
};

namespace {

Iteration combine(const BlockOutcome& curve, const BlockOutcome& surface, const Blocks& blocks) {
  const auto count = static_cast<double>(std::max<std::size_t>(1, blocks.interpolated));
  const double sum = curve.final.mean * static_cast<double>(blocks.curve.vertices.size()) +
                     surface.final.mean * static_cast<double>(blocks.surface.vertices.size());
  return {surface.final.iteration, std::max(curve.final.max, surface.final.max), sum / count};
}

// Errors of the targets themselves, taken as control points.
Iteration initial_error(const LimitOperator& op, const Blocks& blocks, const Task& task,
                        const Context& context) {
  BlockOutcome outcomes[2];
  std::vector<double> r(task.target.size(), 0.0);
  const Block* const both[2] = {&blocks.curve, &blocks.surface};
  for (std::size_t i = 0; i < 2; ++i) {
    const LinearSystem system{
        op, *both[i], task.width, task.target, power_of_two_scale(task.unit), context};
    const ErrorNorms norms = system.residual(task.target, r);
    const auto count = static_cast<double>(std::max<std::size_t>(1, both[i]->vertices.size()));
    const double unit = task.unit * system.scale;
    outcomes[i].final = {0, norms.max / unit, norms.sum / count / unit};
  }
  return combine(outcomes[0], outcomes[1], blocks);
}

Result<void> require_finite(std::span<const double> values, std::size_t width, const char* what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return fail(ErrorCode::not_finite, fmt::format("{} is not a finite number", what),
                {.vertex = static_cast<Index>(i / width)});
  }
  return {};
}

// The unit of errors: the largest side of the box, or a stand-in where all points coincide.
Result<double> unit_of(const Box& box) {
  const double side = box.side();
  if (!std::isfinite(side)) {
    return fail(ErrorCode::not_finite,
                "the coordinates are so large that their differences overflow");
  }
  return side > 0 ? side : 1.0;
}

double range_of(std::span<const double> values) {
  if (values.empty()) return 1;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double range = *high - *low;
  return range > 0 && std::isfinite(range) ? range : 1.0;
}

struct Solved {
  BlockOutcome curve;
  BlockOutcome surface;
};

Result<Solved> solve_task(const Interpolator::Impl& impl, const Task& task, const Context& context,
                          std::vector<std::string>& notes) {
  Solved solved;
  auto curve =
      solve_block(impl.options, impl.op, impl.blocks.curve, task, "curves", context, notes);
  if (!curve) return tl::make_unexpected(curve.error());
  solved.curve = std::move(*curve);
  auto surface =
      solve_block(impl.options, impl.op, impl.blocks.surface, task, "surface", context, notes);
  if (!surface) return tl::make_unexpected(surface.error());
  solved.surface = std::move(*surface);
  return solved;
}

std::string no_bound(const Block& block) {
  return block.symmetric ? "no bound is proven for the boundary rule `interior` on open meshes"
                         : "no bound is proven for darts and semi-sharp creases";
}

Result<void> require_proven(const Blocks& blocks) {
  for (const Block* block : {&blocks.curve, &blocks.surface}) {
    if (block->vertices.empty() || block->proven()) continue;
    return fail(ErrorCode::unsuitable_for_scheme, no_bound(*block), {.vertex = block->obstacle});
  }
  return {};
}

Result<void> check_options(const InterpolateOptions& options, const Blocks& blocks) {
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    return fail(ErrorCode::invalid_argument, "the tolerance must be a number of at least 0");
  }
  if (options.max_iterations == 0) {
    return fail(ErrorCode::invalid_argument, "at least one evaluation must be allowed");
  }
  const bool has_bound =
      options.solver == Solver::richardson || options.solver == Solver::chebyshev;
  if (options.direct && !has_bound) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the number of sweeps cannot be told in advance for {}; use richardson "
                            "or chebyshev",
                            name_of(options.solver)));
  }
  if (options.direct) return require_proven(blocks);
  if (options.solver == Solver::conjugate_gradient) {
    for (const Block* block : {&blocks.curve, &blocks.surface}) {
      if (block->vertices.empty() || block->symmetric) continue;
      return fail(ErrorCode::unsuitable_for_scheme,
                  "conjugate gradients need a symmetric operator, which darts and semi-sharp "
                  "creases spoil; use chebyshev",
                  {.vertex = block->obstacle});
    }
  }
  return {};
}

}  // namespace

Interpolator::Interpolator(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Interpolator::Interpolator(Interpolator&&) noexcept = default;
Interpolator& Interpolator::operator=(Interpolator&&) noexcept = default;
Interpolator::~Interpolator() = default;

Result<Interpolator> Interpolator::create(const Mesh& mesh, const InterpolateOptions& options,
                                          const Context& context) {
  context.report({.stage = "topology"});
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  auto op = limit_operator(mesh, *topology, options.rules, context);
  if (!op) return tl::make_unexpected(op.error());
  auto blocks = find_blocks(*op, options.only);
  if (!blocks) return tl::make_unexpected(blocks.error());
  if (auto ok = check_options(options, *blocks); !ok) return tl::make_unexpected(ok.error());
  return Interpolator(
      std::make_unique<const Impl>(Impl{options, std::move(*op), std::move(*blocks)}));
}

Result<Solution> Interpolator::solve(std::span<const Point> points,
                                     std::span<const Channel> channels,
                                     const Context& context) const {
  const std::size_t n = impl_->op.rows.row_count();
  if (points.size() != n) {
    return fail(ErrorCode::mismatch,
                fmt::format("{} points were given for a mesh of {} vertices", points.size(), n));
  }
  const std::span<const double> target = flat(points);
  if (auto ok = require_finite(target, 3, "a coordinate"); !ok)
    return tl::make_unexpected(ok.error());
  const Box box = bounding_box(points);
  const auto unit = unit_of(box);
  if (!unit) return tl::make_unexpected(unit.error());

  Solution solution{{points.begin(), points.end()}, {}, {}};
  SolveReport& report = solution.report;
  report.box_side = box.side();
  report.tolerance = floored_tolerance(impl_->options.tolerance, target, *unit);
  const Task task{target, 3, *unit, report.tolerance, flat(std::span(solution.points))};
  report.initial = initial_error(impl_->op, impl_->blocks, task, context);
  auto solved = solve_task(*impl_, task, context, report.notes);
  if (!solved) return tl::make_unexpected(solved.error());
  report.converged = solved->curve.converged && solved->surface.converged;
  report.iterations = solved->surface.final.iteration;
  report.boundary_iterations = solved->curve.final.iteration;
  report.final = combine(solved->curve, solved->surface, impl_->blocks);
  report.history = std::move(solved->surface.history);
  report.boundary_history = std::move(solved->curve.history);

  for (const Channel& channel : channels) {
    if (channel.values.size() != n * channel.width()) {
      return fail(ErrorCode::mismatch, fmt::format("channel \"{}\" has {} values for {} vertices",
                                                   channel.name, channel.values.size(), n));
    }
    if (auto ok = require_finite(channel.values, channel.width(), "a channel's value"); !ok) {
      return tl::make_unexpected(ok.error());
    }
    Channel& result = solution.channels.emplace_back(channel);
    const double range = range_of(channel.values);
    const Task carried{channel.values, channel.width(), range,
                       floored_tolerance(impl_->options.tolerance, channel.values, range),
                       result.values};
    const auto done = solve_task(*impl_, carried, context, report.notes);
    if (!done) return tl::make_unexpected(done.error());
    if (done->curve.converged && done->surface.converged) continue;
    report.converged = false;
    report.notes.push_back(fmt::format("channel \"{}\" did not reach the tolerance", channel.name));
  }
  return solution;
}

Result<Prediction> Interpolator::predict(std::span<const Point> points) const {
  if (auto ok = require_proven(impl_->blocks); !ok) return tl::make_unexpected(ok.error());
  InterpolateOptions options = impl_->options;
  if (options.solver != Solver::richardson) options.solver = Solver::chebyshev;
  if (points.size() != impl_->op.rows.row_count()) {
    return fail(ErrorCode::mismatch, "the points do not match the mesh");
  }
  const auto unit = unit_of(bounding_box(points));
  if (!unit) return tl::make_unexpected(unit.error());
  std::vector<Point> x(points.begin(), points.end());
  const double tolerance = floored_tolerance(options.tolerance, flat(points), *unit);
  const Task task{flat(points), 3, *unit, tolerance, flat(std::span(x))};
  const Context silent;
  const auto sweeps = [&](const Block& block) {
    const LinearSystem system{impl_->op, block, 3, task.target, power_of_two_scale(*unit), silent};
    return sweeps_needed(system, options.solver, task.x, tolerance * *unit * system.scale);
  };
  Prediction prediction;
  prediction.lowest_eigenvalue = impl_->blocks.surface.lowest;
  prediction.boundary_lowest_eigenvalue = impl_->blocks.curve.lowest;
  prediction.boundary_sweeps = sweeps(impl_->blocks.curve);
  // The surface starts when the curves are done.
  std::vector<std::string> notes;
  const auto curve =
      solve_block(options, impl_->op, impl_->blocks.curve, task, "curves", silent, notes);
  if (!curve) return tl::make_unexpected(curve.error());
  prediction.sweeps = sweeps(impl_->blocks.surface);
  return prediction;
}

double floored_tolerance(double tolerance, std::span<const double> values, double unit) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  const double ulp = std::nextafter(largest, HUGE_VAL) - largest;
  return std::max(tolerance, 4 * ulp / unit);
}

Result<Interpolated> interpolate(const Mesh& mesh, const InterpolateOptions& options,
                                 const Context& context) {
  const auto solver = Interpolator::create(mesh, options, context);
  if (!solver) return tl::make_unexpected(solver.error());
  auto solution = solver->solve(mesh.points, mesh.channels, context);
  if (!solution) return tl::make_unexpected(solution.error());
  Interpolated result{mesh, std::move(solution->report)};
  result.control.points = std::move(solution->points);
  result.control.channels = std::move(solution->channels);
  result.control.annotate("scheme", name_of(options.rules.scheme));
  result.control.annotate("boundary", name_of(options.rules.boundary));
  return result;
}

}  // namespace surpass

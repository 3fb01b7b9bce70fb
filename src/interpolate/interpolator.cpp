// Progressive interpolation. Cheng, Fan, Lai, Huang, Wang, Yong: Loop subdivision surface based
// progressive interpolation, J. Comput. Sci. Technol. 24(1), 2009. Beyond the paper: one two-stage
// solve for every curve (its section 4 has it for boundaries), and faster solvers of the same
// equation.
#include <surpass/interpolate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "interpolate/a_priori.hpp"
#include "interpolate/choose_solver.hpp"
#include "interpolate/stages.hpp"
#include "mesh/common_part.hpp"
#include "parallel/parallel.hpp"
#include "scheme/limit_points.hpp"

namespace surpass {

const char* name_of(Solver solver) {
  switch (solver) {
    case Solver::automatic: return "auto";
    case Solver::chebyshev: return "chebyshev";
    case Solver::richardson: return "richardson";
    case Solver::conjugate_gradient: return "conjugate-gradient";
    case Solver::gauss_seidel: return "gauss-seidel";
    case Solver::minimal_residual: return "minres";
    case Solver::bicgstab: return "bicgstab";
  }
  return "unknown";
}

Result<Solver> solver_named(std::string_view name) {
  for (const Solver s :
       {Solver::automatic, Solver::chebyshev, Solver::richardson, Solver::conjugate_gradient,
        Solver::gauss_seidel, Solver::minimal_residual, Solver::bicgstab}) {
    if (name == name_of(s)) return s;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no solver \"{}\"; there are auto, chebyshev, richardson, "
                          "conjugate-gradient, gauss-seidel, minres and bicgstab",
                          name));
}

struct Interpolator::Impl : Prepared {};

namespace {

Result<void> require_size(std::size_t points, const LimitOperator& op) {
  if (points == op.rows.row_count()) return {};
  return fail(ErrorCode::mismatch, fmt::format("{} points were given for a mesh of {} vertices",
                                               points, op.rows.row_count()));
}

bool all_finite(std::span<const double> values) {
  std::uint64_t others = 0;  // without a branch, several numbers at a time
  for (const double v : values)
    others |= std::abs(v) <= std::numeric_limits<double>::max() ? 0U : 1U;
  return others == 0;
}

Result<void> require_finite(std::span<const double> values, std::size_t width, const char* what) {
  if (all_finite(values)) return {};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return fail(ErrorCode::not_finite, fmt::format("{} is not a finite number", what),
                {.vertex = static_cast<Index>(i / width)});
  }
  return {};
}

struct Start {
  std::vector<Point> points;
  Box box;
};

// Their box, or nothing if one is not finite. Calls use(piece) for some of them at a time, while
// they are near.
template <class Use>
std::optional<Box> box_of_finite(std::span<const Point> points, Use&& use) {
  constexpr std::size_t kPiece = 1024;
  Box all = bounding_box(points.first(std::min<std::size_t>(1, points.size())));
  for (std::size_t i = 0; i < points.size(); i += kPiece) {
    const auto piece = points.subspan(i, std::min(kPiece, points.size() - i));
    if (!all_finite(flat(piece))) return std::nullopt;
    const Box box = bounding_box(piece);
    for (std::size_t k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], box.low[k]);
      all.high[k] = std::max(all.high[k], box.high[k]);
    }
    use(piece);
  }
  return all;
}

// A copy of the points, checked and measured: piece by piece, so that memory is read once, or where
// there are many and two threads, beside each other.
Result<Start> start_from(std::span<const Point> points, const Context& context) {
  constexpr std::size_t kPointsToShare = 65536;
  Start start;
  start.points.reserve(points.size());
  const auto copy = [&](std::span<const Point> piece) {
    start.points.insert(start.points.end(), piece.begin(), piece.end());
  };
  std::optional<Box> box;
  if (points.size() < kPointsToShare || parallel::thread_count(context) == 1) {
    box = box_of_finite(points, copy);
  } else {
    parallel::run_beside(
        context, [&] { copy(points); }, [&] { box = box_of_finite(points, [](const auto&) {}); });
  }
  if (!box) return tl::make_unexpected(require_finite(flat(points), 3, "a coordinate").error());
  start.box = *box;
  return start;
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

std::vector<const Block*> all_blocks(const Blocks& blocks) {
  std::vector<const Block*> all = {&blocks.curve};
  for (const Block& block : blocks.surface) all.push_back(&block);
  return all;
}

Result<void> require_proven(const Blocks& blocks) {
  for (const Block* block : all_blocks(blocks)) {
    if (block->vertices.empty() || block->proven()) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                block->symmetric
                    ? "no bound of the spectrum is proven around this vertex: its valence, or the "
                      "boundary rule, lets eigenvalues come arbitrarily close to zero"
                    : "no bound of the spectrum is proven for darts and semi-sharp creases",
                {.vertex = block->obstacle});
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
  const bool has_bound = options.solver == Solver::richardson ||
                         options.solver == Solver::chebyshev || options.solver == Solver::automatic;
  if (options.direct && !has_bound) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the number of sweeps cannot be told in advance for {}; use richardson "
                            "or chebyshev",
                            name_of(options.solver)));
  }
  if (options.direct) return require_proven(blocks);
  const bool needs_symmetry =
      options.solver == Solver::conjugate_gradient || options.solver == Solver::minimal_residual;
  for (const Block* block : all_blocks(blocks)) {
    if (block->vertices.empty()) continue;
    if (needs_symmetry && !block->symmetric) {
      return fail(
          ErrorCode::unsuitable_for_scheme,
          fmt::format("the solver {} needs a symmetric operator, which darts and semi-sharp "
                      "creases spoil; use chebyshev or bicgstab",
                      name_of(options.solver)),
          {.vertex = block->obstacle});
    }
    if (options.solver == Solver::conjugate_gradient && block->lowest < 0) {
      return fail(ErrorCode::unsuitable_for_scheme,
                  "conjugate gradients need an operator without negative eigenvalues, and this "
                  "vertex may bring one in; use minres",
                  {.vertex = block->obstacle});
    }
  }
  return {};
}

// Marks what is to be interpolated: #V.
Result<std::vector<unsigned char>> listed_vertices(const InterpolateOptions& options, Index count,
                                                   const Components& components) {
  std::vector<unsigned char> listed(count, options.only.empty() ? 1 : 0);
  for (const Index v : options.only) {
    if (v >= count) {
      return fail(
          ErrorCode::invalid_argument,
          fmt::format("the list of vertices to interpolate names {}, but there are {}", v, count),
          {.vertex = v});
    }
    listed[v] = 1;
  }
  for (const Index skipped : options.skip_components) {
    if (skipped < components.count) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("component {} is to be skipped, but there are {}, numbered from 0",
                            skipped, components.count));
  }
  for (Index v = 0; v < components.of_vertex.size(); ++v) {
    const auto& skip = options.skip_components;
    if (std::find(skip.begin(), skip.end(), components.of_vertex[v]) != skip.end()) listed[v] = 0;
  }
  return listed;
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
  Components components;
  if (!options.skip_components.empty()) components = find_components(*topology);
  auto listed = listed_vertices(options, topology->vertex_count(), components);
  if (!listed) return tl::make_unexpected(listed.error());
  Blocks blocks = find_blocks(*op, *listed);
  if (auto ok = check_options(options, blocks); !ok) return tl::make_unexpected(ok.error());
  std::vector<SingularPart> singular = find_singular_parts(*op, blocks, context);
  order_rows_for(options, *op, blocks.curve);
  for (Block& block : blocks.surface) order_rows_for(options, *op, block);
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  if (!singular.empty() && components.of_vertex.empty()) components = find_components(*topology);
  Prepared prepared{options,           std::move(*op),      std::move(*listed),
                    std::move(blocks), std::move(singular), std::move(components)};
  return Interpolator(std::make_unique<const Impl>(Impl{std::move(prepared)}));
}

std::vector<Index> Interpolator::interpolated() const {
  std::vector<Index> vertices;
  for (Index v = 0; v < impl_->listed.size(); ++v) {
    if (impl_->listed[v] != 0) vertices.push_back(v);
  }
  return vertices;
}

Result<std::vector<Point>> Interpolator::limit_positions(std::span<const Point> points,
                                                         const Context& context) const {
  if (auto ok = require_size(points.size(), impl_->op); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return limit_points(impl_->op.rows, points, context);
}

Result<Solution> Interpolator::solve(std::span<const Point> points,
                                     std::span<const Channel> channels,
                                     const Context& context) const {
  if (auto ok = require_size(points.size(), impl_->op); !ok) {
    return tl::make_unexpected(ok.error());
  }
  const std::size_t n = points.size();
  auto start = start_from(points, context);
  if (!start) return tl::make_unexpected(start.error());
  const Box box = start->box;
  const auto unit = unit_of(box);
  if (!unit) return tl::make_unexpected(unit.error());

  Solution solution{std::move(start->points), {}, {}};
  SolveReport& report = solution.report;
  report.box_side = box.side();
  std::array<Point, 2> corners = {box.low, box.high};  // no coordinate is farther from 0
  report.tolerance =
      floored_tolerance(impl_->options.tolerance, flat(std::span<const Point>(corners)), *unit);
  // What the coordinates have in common stays out of the sums, and so does its rounding.
  const Point common = common_part(box);
  std::vector<Point> near;
  if (is_far(common)) {
    add_common(solution.points, common, -1);
    add_common(corners, common, -1);
    near = solution.points;
  }
  const Task task{
      flat(near.empty() ? points : std::span<const Point>(near)), 3, *unit,
      floored_tolerance(impl_->options.tolerance, flat(std::span<const Point>(corners)), *unit),
      flat(std::span(solution.points))};
  auto solved = solve_in_stages(*impl_, task, context, report.notes);
  if (!solved) return tl::make_unexpected(solved.error());
  report.converged = solved->converged();
  report.solver = solvers_used(*solved);
  report.boundary_iterations = solved->curve.final.iteration;
  report.initial = initial_error(*impl_, *solved, task, context);
  report.final = final_error(*solved, impl_->blocks);
  report.iterations = report.final.iteration;
  if (const BlockOutcome* longest = solved->longest()) report.history = longest->history;
  report.boundary_history = std::move(solved->curve.history);
  if (is_far(common)) add_common(solution.points, common, 1);

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
    const auto done = solve_in_stages(*impl_, carried, context, report.notes);
    if (!done) return tl::make_unexpected(done.error());
    if (done->converged()) continue;
    report.converged = false;
    report.notes.push_back(fmt::format("channel \"{}\" did not reach the tolerance", channel.name));
  }
  return solution;
}

Result<Prediction> Interpolator::predict(std::span<const Point> points) const {
  if (auto ok = require_proven(impl_->blocks); !ok) return tl::make_unexpected(ok.error());
  InterpolateOptions options = impl_->options;
  if (options.solver != Solver::richardson) options.solver = Solver::chebyshev;
  if (auto ok = require_size(points.size(), impl_->op); !ok) {
    return tl::make_unexpected(ok.error());
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
  const Block nothing;  // where all vertices are their own limits
  const Block& surface = impl_->blocks.surface.empty() ? nothing : impl_->blocks.surface.front();
  prediction.lowest_eigenvalue = surface.lowest;
  prediction.boundary_lowest_eigenvalue = impl_->blocks.curve.lowest;
  prediction.boundary_sweeps = sweeps(impl_->blocks.curve);
  // The surface starts when the curves are done.
  std::vector<std::string> notes;
  const auto curve =
      solve_block(options, impl_->op, impl_->blocks.curve, task, "curves", silent, notes);
  if (!curve) return tl::make_unexpected(curve.error());
  prediction.sweeps = sweeps(surface);
  return prediction;
}

double floored_tolerance(double tolerance, std::span<const double> values, double unit) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  const double ulp = std::nextafter(largest, HUGE_VAL) - largest;
  return std::max(tolerance, 4 * ulp / unit);
}

namespace {

// All but what the solution brings. All members are named, so that no new one is forgotten.
Mesh without_solution(const Mesh& mesh) {
  const auto& [points, face_offsets, face_vertices, creases, corners, hole_faces, channels,
               corner_channels, face_channels, face_sets, material_libraries, tags, annotations] =
      mesh;
  return {{},
          face_offsets,
          face_vertices,
          creases,
          corners,
          hole_faces,
          {},
          corner_channels,
          face_channels,
          face_sets,
          material_libraries,
          tags,
          annotations};
}

}  // namespace

Result<Interpolated> interpolate(const Mesh& mesh, const InterpolateOptions& options,
                                 const Context& context) {
  const auto solver = Interpolator::create(mesh, options, context);
  if (!solver) return tl::make_unexpected(solver.error());
  auto solution = solver->solve(mesh.points, mesh.channels, context);
  if (!solution) return tl::make_unexpected(solution.error());
  Interpolated result{without_solution(mesh), std::move(solution->report)};
  result.control.points = std::move(solution->points);
  result.control.channels = std::move(solution->channels);
  result.control.forget("refined");
  annotate(result.control, options.rules);
  return result;
}

}  // namespace surpass

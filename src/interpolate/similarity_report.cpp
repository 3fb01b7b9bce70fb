#include "interpolate/similarity_report.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "interpolate/linear_system.hpp"
#include "mesh/wording.hpp"
#include "scheme/limit_points.hpp"

namespace surpass {

std::vector<Point> points_of(std::span<const double> values) {
  std::vector<Point> points(values.size() / 3);
  std::copy(values.begin(), values.end(), flat(std::span(points)).begin());
  return points;
}

std::vector<Point> limits_of(const SimilarityPrepared& prepared, std::span<const Point> control,
                             const Context& context) {
  return limit_points(prepared.elimination.limits(), control, context);
}

namespace {

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
                 std::span<const Point> points, double side, const Context& context,
                 SimilarityReport& report) {
  const SimilarityOptions& options = prepared.options;
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
void judge_residual(const SimilarityPrepared& prepared, const Found& found,
                    SimilarityReport& report) {
  const FreeOutcome& outcome = found.outcome;
  const bool moved = !found.fates.redundant.empty();  // by requirements
  const SimilarityOptions& options = prepared.options;
  report.residual = !report.residuals.empty() ? report.residuals.back() : outcome.at_rest ? 0 : 1;
  report.solver_converged = report.residual <= options.solver_tolerance;
  if (options.max_iterations == 0) {
    report.residual = 1;
    report.solver_converged = false;
    report.solve.notes.emplace_back(
        moved
            ? "no iterations were allowed: the free vertices are those of the reference, moved by "
              "the least that does what is required"
            : "no iterations were allowed: the free vertices are those of the reference");
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

SimilarityReport similarity_report(const SimilarityPrepared& prepared, Found& found,
                                   std::span<const Point> limits, std::span<const Point> points,
                                   double side, const Context& context) {
  SimilarityReport report;
  fill_report(prepared, found, limits, points, side, context, report);
  judge_reference(found, side, report);
  judge_residual(prepared, found, report);
  return report;
}
}  // namespace surpass

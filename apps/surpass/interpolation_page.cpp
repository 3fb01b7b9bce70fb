#include "interpolation_page.hpp"

#include <cmath>
#include <utility>

namespace surpass::cli {

namespace {

constexpr Index kMostForRivals = 100000;  // vertices; more would take longer than the work itself

Json history_of(const std::vector<Iteration>& iterations) {
  Json history = Json::array();
  for (const Iteration& i : iterations)
    history.push_back({{"iteration", i.iteration}, {"max", i.max}});
  return history;
}

void plot_rivals(HtmlReport& page, const Mesh& given, InterpolateOptions options,
                 const Session& session) {
  options.full_history = true;
  options.direct = false;
  const std::pair<Solver, const char*> solvers[] = {{Solver::richardson, "Richardson"},
                                                    {Solver::chebyshev, "Chebyshev"}};
  for (const auto& [solver, name] : solvers) {
    options.solver = solver;
    const auto solved = interpolate(given, options, session.context);
    if (!solved) continue;  // not for this mesh: the plot goes without
    page.plot(name, history_of(solved->report.history));
    page.plot(std::string(name) + ", on curves", history_of(solved->report.boundary_history));
  }
}

Result<std::vector<double>> plain_errors(const Mesh& given, const Rules& rules,
                                         const Context& context) {
  const auto limit = limit_positions(given, rules, context);
  if (!limit) return tl::make_unexpected(limit.error());
  const double side = std::max(bounding_box(given.points).side(), 1e-300);
  std::vector<double> errors;
  errors.reserve(limit->size());
  for (std::size_t v = 0; v < limit->size(); ++v) {
    const auto off = [&](std::size_t c) { return ((*limit)[v][c] - given.points[v][c]) / side; };
    errors.push_back(std::hypot(off(0), off(1), off(2)));
  }
  return errors;
}

}  // namespace

Result<void> add_interpolation(HtmlReport& page, const Mesh& given, const Mesh& control,
                               const Rules& rules, const InterpolateOptions* rivals,
                               const Session& session) {
  Mesh plain = given;
  plain.channels.clear();
  plain.corner_channels.clear();
  page.add("given", "Given mesh", LayerKind::mesh, plain);
  page.add("control", "Control mesh", LayerKind::cage, control);
  auto errors = plain_errors(plain, rules, session.context);
  if (!errors) return tl::make_unexpected(errors.error());
  page.mark(given.points, *errors);
  plain.channels.push_back({"error", {"error"}, std::move(*errors)});
  if (auto added = page.add_limit("plain", "Plain limit surface", plain, rules, session.context);
      !added) {
    return added;
  }
  Mesh fitted = control;
  fitted.channels.clear();
  fitted.corner_channels.clear();
  if (auto added =
          page.add_limit("surface", "Interpolating surface", fitted, rules, session.context);
      !added) {
    return added;
  }
  if (rivals != nullptr && given.vertex_count() <= kMostForRivals) {
    plot_rivals(page, given, *rivals, session);
  } else {
    page.plot("This solver", session.report.value("history", Json::array()));
  }
  return {};
}

}  // namespace surpass::cli

// surpass interpolate GIVEN -o CONTROL
//
// Read, mend, solve, certify before and after rounding, write. Everything is computed before
// anything is written.
#include <surpass/topology.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "command.hpp"
#include "evaluator.hpp"
#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "rules_option.hpp"
#include "solve_report.hpp"
#include "solver_options.hpp"
#include "vertex_list.hpp"

namespace surpass::cli {

namespace {

class Interpolate : public Command {
 public:
  void define(Options& options) override;
  Result<void> run(Session& session) override;

 private:
  Result<void> choose_options(const Mesh& given, Session& session);
  Result<SolveReport> solve(const Interpolator& solver, Mesh& mesh, std::vector<Point>& given,
                            Session& session) const;
  Result<Verdict> verify(const Interpolator& solver, const Mesh& control,
                         std::span<const Point> given, Session& session) const;
  Result<Certificate> certify_listed(const std::vector<Point>& limit,
                                     std::span<const Point> given) const;
  [[nodiscard]] Result<void> not_reached(const SolveReport& solved, double error) const;
  Result<void> write(const Mesh& control, Session& session) const;

  MeshInput input_;
  MeshOutput output_;
  RulesOption rules_;
  InterpolateOptions options_;
  std::string only_path_;
  std::optional<std::vector<Index>> certified_;  ///< all vertices, if there is no list
  std::string surface_path_;
  int levels_ = 3;
  bool keep_best_ = false;
  bool oracle_ = false;
};

void Interpolate::define(Options& options) {
  input_.define(options, "GIVEN", "The mesh whose vertices the surface shall pass through");
  output_.define(options, "-o,--output", "The control mesh");
  rules_.define(options);
  options
      .add("--surface", surface_path_,
           "Also write the limit surface: the control mesh refined and moved to the limit")
      .type_name("FILE")
      .group("Surface");
  add_levels(options, levels_, "Refinement steps of --surface").group("Surface");
  add_solver_options(options, options_);
  options
      .add("--max-iterations", options_.max_iterations,
           "Most evaluations of the limit, for curves and surface each")
      .in_range(1, 1000000000)
      .type_name("N")
      .default_text(std::to_string(options_.max_iterations))
      .group("Solver");
  options
      .flag("--direct", options_.direct,
            "Do exactly the sweeps of the a-priori bound, without testing in between (see "
            "surpass predict); richardson and chebyshev")
      .group("Solver");
  options
      .flag(
          "--history", options_.full_history,
          "Keep every iteration in the report; richardson always does, chebyshev then tests after "
          "every sweep")
      .group("Solver");
  options
      .add("--only", only_path_,
           "Interpolate only the vertices that this file lists (numbers from 0, white space "
           "between, # comments); the others stay as given")
      .type_name("FILE")
      .group("Solver");
  options
      .add("--skip-component", options_.skip_components,
           "Leave these connected components of the control mesh as given (numbers from 0, as "
           "an error names them, with commas between)")
      .comma_separated()
      .type_name("N,...")
      .group("Solver");
  options
      .flag("--keep-best", keep_best_,
            "Write the mesh even if the tolerance was not reached; the exit code stays 4")
      .group("Output");
  add_oracle(options, oracle_);
  options.examples(
      "If the tolerance is not reached, no mesh is written and the exit code is 4; the report is\n"
      "written either way.\n\n"
      "Examples:\n"
      "  surpass interpolate given.obj -o control.obj\n"
      "  surpass interpolate scan.ply -o control.ply --surface smooth.ply --levels 3\n"
      "  surpass interpolate quads.obj -o control.obj --triangulate --tolerance 1e-12\n"
      "  surpass interpolate open.off -o control.off --boundary hoppe --solver richardson \\\n"
      "      --report run.json\n"
      "  cat given.off | surpass interpolate - -o - > control.off\n");
}

Result<void> Interpolate::run(Session& session) {
  std::vector<std::string> inputs = {input_.path()};
  if (!only_path_.empty()) inputs.push_back(only_path_);
  std::vector<std::string> surfaces;
  if (!surface_path_.empty()) surfaces.push_back(surface_path_);
  const auto prepared = output_.prepare(session, inputs, surfaces);
  if (!prepared) return prepared;

  Result<LoadedMesh> loaded = input_.load(session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  Mesh& mesh = loaded->mesh;
  output_.default_format(loaded->format);
  if (const auto chosen = choose_options(mesh, session); !chosen) return chosen;

  const Result<Interpolator> solver = session.timed(
      "topology", [&] { return Interpolator::create(mesh, options_, session.context); });
  if (!solver) return tl::make_unexpected(solver.error());
  const bool all = options_.only.empty() && options_.skip_components.empty();
  if (!all) certified_ = solver->interpolated();
  std::vector<Point> given;
  const Result<SolveReport> solved = solve(*solver, mesh, given, session);
  if (!solved) return tl::make_unexpected(solved.error());
  const Result<Verdict> verdict = verify(*solver, mesh, given, session);
  if (!verdict) return tl::make_unexpected(verdict.error());
  if (!solved->solver.empty()) session.report["solver"] = solved->solver;
  add_solve_report(*solved, *verdict, session.report);
  session.console.notes(solved->notes);
  session.console.say(fmt::format("{}: {} vertices, {}, {}", input_.path(), mesh.vertex_count(),
                                  name_of(options_.rules.scheme),
                                  name_of(options_.rules.boundary)));
  session.console.say(fmt::format("{}, {:.3g} s", summary(*solved, *verdict), session.seconds()));

  const bool reached = solved->converged && verdict->judged() <= solved->tolerance;
  if (reached || keep_best_) {
    if (const auto written = write(mesh, session); !written) return written;
  }
  return reached ? Result<void>() : not_reached(*solved, verdict->judged());
}

Result<void> Interpolate::not_reached(const SolveReport& solved, double error) const {
  const std::string advice = keep_best_ ? "" : ", or have the best mesh written with --keep-best";
  if (error <= solved.tolerance) {
    return fail(ErrorCode::not_converged,
                fmt::format("the positions reached the tolerance {:.3g}, but a channel did not; "
                            "allow more with --max-iterations{}",
                            solved.tolerance, advice));
  }
  return fail(ErrorCode::not_converged,
              fmt::format("the error is {:.3g} of the box side, above the tolerance {:.3g}, after "
                          "{} iterations; allow more with --max-iterations, accept more with "
                          "--tolerance{}",
                          error, solved.tolerance, solved.iterations, advice));
}

Result<void> Interpolate::choose_options(const Mesh& given, Session& session) {
  options_.rules = rules_.choose(given, session);
  session.report["method"] = "progressive";
  session.report["solver"] = name_of(options_.solver);
  session.report["tolerance"] = options_.tolerance;
  if (const auto checked = check_oracle(oracle_, options_.rules); !checked) return checked;
  if (!surface_path_.empty()) {
    if (const auto checked = check_levels(given, levels_); !checked) return checked;
  }
  if (!only_path_.empty()) {
    Result<std::vector<Index>> only = read_vertex_list(only_path_, given.vertex_count());
    if (!only) return tl::make_unexpected(only.error());
    options_.only = std::move(*only);
    session.report["only"] = options_.only.size();
  }
  return {};
}

/// Turns the given mesh into the control mesh; its points become `given`.
Result<SolveReport> Interpolate::solve(const Interpolator& solver, Mesh& mesh,
                                       std::vector<Point>& given, Session& session) const {
  Result<Solution> solution = session.timed(
      "solve", [&] { return solver.solve(mesh.points, mesh.channels, session.context); });
  if (!solution) return tl::make_unexpected(solution.error());
  given = std::exchange(mesh.points, std::move(solution->points));
  mesh.channels = std::move(solution->channels);
  record(options_.rules, mesh);
  return std::move(solution->report);
}

Result<Verdict> Interpolate::verify(const Interpolator& solver, const Mesh& control,
                                    std::span<const Point> given, Session& session) const {
  return session.timed("verify", [&]() -> Result<Verdict> {
    const auto certify = [&](std::span<const Point> points) -> Result<Certificate> {
      const auto limit = solver.limit_positions(points, session.context);
      if (!limit) return tl::make_unexpected(limit.error());
      return certify_listed(*limit, given);
    };
    Verdict verdict;
    const Result<Certificate> exact = certify(control.points);
    if (!exact) return tl::make_unexpected(exact.error());
    verdict.exact = *exact;

    const std::vector<Point> rounded =
        output_.rounds() ? output_.stored(control.points) : std::vector<Point>();
    if (output_.rounds() && rounded != control.points) {
      const Result<Certificate> stored = certify(rounded);
      if (!stored) return tl::make_unexpected(stored.error());
      verdict.stored = *stored;
    }
    if (oracle_) {
      const Result<Certificate> oracle = certify_by_oracle(control, given, options_.rules);
      if (!oracle) return tl::make_unexpected(oracle.error());
      session.console.notes(oracle->notes);
      verdict.oracle = *oracle;
    }
    return verdict;
  });
}

/// For the vertices that are to be met.
Result<Certificate> Interpolate::certify_listed(const std::vector<Point>& limit,
                                                std::span<const Point> given) const {
  if (!certified_) return compare_points(limit, given, "surpass");
  std::vector<Point> listed_limit;
  std::vector<Point> listed_given;
  for (const Index v : *certified_) {
    listed_limit.push_back(limit[v]);
    listed_given.push_back(given[v]);
  }
  Result<Certificate> found = compare_points(listed_limit, listed_given, "surpass");
  if (!found) return found;
  // Relative to the whole mesh, as all errors are.
  const double side = bounding_box(given).side();
  const double scale = found->box_side / (side > 0 ? side : 1);
  found->max *= scale;
  found->mean *= scale;
  found->box_side /= scale;
  if (!certified_->empty()) found->worst_vertex = (*certified_)[found->worst_vertex];
  return found;
}

Result<void> Interpolate::write(const Mesh& control, Session& session) const {
  std::optional<Mesh> surface;
  if (!surface_path_.empty()) {
    Result<Mesh> refined = session.timed(
        "refine", [&] { return limit_mesh(control, options_.rules, levels_, session.context); });
    if (!refined) return tl::make_unexpected(refined.error());
    surface = std::move(*refined);
  }
  if (const auto written = output_.write(control, session); !written) return written;
  return surface ? output_.write(*surface, surface_path_, session) : Result<void>();
}

}  // namespace

std::unique_ptr<Command> make_interpolate() { return std::make_unique<Interpolate>(); }

}  // namespace surpass::cli

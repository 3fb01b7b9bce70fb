// surpass interpolate GIVEN -o CONTROL
//
// Read, mend, solve, certify before and after rounding, write. Everything is computed before
// anything is written.
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "command.hpp"
#include "evaluator.hpp"
#include "html_report.hpp"
#include "interpolation_page.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "nonstationary_surface.hpp"
#include "rules_option.hpp"
#include "similar.hpp"
#include "solve_report.hpp"
#include "solver_options.hpp"
#include "surface_output.hpp"
#include "vertex_list.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

class Interpolate : public Command {
 public:
  void define(Options& options) override;
  Result<void> run(Session& session) override;

 private:
  [[nodiscard]] Result<void> check_method();
  Result<void> choose_options(const Mesh& given, Session& session);
  Result<void> prepare(const Mesh& given, Session& session);
  Result<SolveReport> solve(Mesh& mesh, std::vector<Point>& given, Session& session);
  [[nodiscard]] Result<std::vector<Point>> limit_positions(std::span<const Point> control,
                                                           const Session& session) const;
  Result<Verdict> verify(const Mesh& control, std::span<const Point> given, double side,
                         Session& session) const;
  Result<Certificate> certify_listed(const std::vector<Point>& limit,
                                     std::span<const Point> given) const;
  [[nodiscard]] Result<void> not_reached(const SolveReport& solved, double error) const;
  Result<void> write(const Mesh& control, Session& session) const;
  [[nodiscard]] Result<void> check_nonstationary() const;

  Result<void> write_page(Mesh given, std::vector<Point> points, const Mesh& control,
                          Session& session);

  MeshInput input_;
  MeshOutput output_;
  HtmlReport page_;
  RulesOption rules_;
  Method method_ = Method::progressive;
  InterpolateOptions options_;
  Similar similar_;
  Nonstationary nonstationary_;
  std::optional<Interpolator> solver_;  ///< of the progressive method
  std::string only_path_;
  std::optional<std::vector<Index>> certified_;  ///< all vertices, if there is no list
  SurfaceOutput surface_;
  Option max_iterations_;
  bool keep_best_ = false;
  bool oracle_ = false;
};

void Interpolate::define(Options& options) {
  input_.define(options, "GIVEN", "The mesh whose vertices the surface shall pass through");
  output_.define(options, "-o,--output", "The control mesh");
  page_.define(options);
  rules_.define(options, {.nonstationary = true, .directions = true});
  surface_.define(options, ", and of nonstationary-loop");
  options
      .choice("--method", method_, {Method::progressive, Method::similarity, Method::fair},
              "progressive: the only control mesh of the given topology, where there is one; "
              "similarity and fair: of the given mesh refined once, and of all these the one whose "
              "surface resembles a reference, by default that of the given mesh itself, or is "
              "fair (thin plate, membrane); they never fail to interpolate")
      .default_text(name_of(method_))
      .group("Surface");
  add_solver_options(options, options_);
  max_iterations_ =
      options
          .add(
              "--max-iterations", options_.max_iterations,
              "Most evaluations of the limit, for curves and surface each; for similarity and fair "
              "most iterations, and 0 will do")
          .in_range(0, 1000000000)
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
  similar_.define(options);
  nonstationary_.define(options);
  options.examples(
      "Under --scheme nonstationary-loop there is no control mesh but the given one, so -o is the\n"
      "surface: the given mesh refined --levels times and moved to the limit.\n"
      "If the tolerance is not reached, no mesh is written and the exit code is 4; the report is\n"
      "written either way.\n\n"
      "Examples:\n"
      "  surpass interpolate given.obj -o control.obj\n"
      "  surpass interpolate scan.ply -o control.ply --surface smooth.ply --levels 3\n"
      "  surpass interpolate quads.obj -o control.obj --triangulate --tolerance 1e-12\n"
      "  surpass interpolate open.off -o control.off --boundary hoppe --solver richardson \\\n"
      "      --report run.json\n"
      "  surpass interpolate cube.obj -o control.obj --method similarity\n"
      "  surpass interpolate scan.ply -o control.ply --method fair --membrane 0.1\n"
      "  surpass interpolate given.obj -o surface.ply --scheme nonstationary-loop --levels 4\n"
      "  cat given.off | surpass interpolate - -o - > control.off\n");
}

Result<void> Interpolate::run(Session& session) {
  if (const auto checked = check_method(); !checked) return checked;
  std::vector<std::string> inputs = similar_.inputs();
  inputs.insert(inputs.begin(), input_.path());
  for (const std::string& path : nonstationary_.inputs()) inputs.push_back(path);
  if (!only_path_.empty()) inputs.push_back(only_path_);
  std::vector<std::string> outputs = similar_.outputs();
  if (surface_.wanted()) outputs.push_back(surface_.path());
  const auto prepared = output_.prepare(session, inputs, outputs);
  if (!prepared) return prepared;
  outputs.push_back(output_.path());
  if (const auto ready = page_.prepare(session, inputs, outputs); !ready) return ready;

  Result<LoadedMesh> loaded = input_.load(session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  Mesh& mesh = loaded->mesh;
  output_.default_format(loaded->format);
  if (rules_.nonstationary()) {
    return write_nonstationary_surface(mesh,
                                       {input_.path(), rules_, nonstationary_, surface_.levels(),
                                        options_.tolerance, keep_best_, output_, page_},
                                       session);
  }
  if (const auto chosen = choose_options(mesh, session); !chosen) return chosen;

  const Index vertices = mesh.vertex_count();
  Mesh shown = page_.wanted() ? mesh : Mesh();
  if (const auto prepared_solver = prepare(mesh, session); !prepared_solver) return prepared_solver;
  std::vector<Point> given;
  const Result<SolveReport> solved = solve(mesh, given, session);
  if (!solved) return tl::make_unexpected(solved.error());
  const Result<Verdict> verdict = verify(mesh, given, solved->box_side, session);
  if (!verdict) return tl::make_unexpected(verdict.error());
  if (!solved->solver.empty()) session.report["solver"] = solved->solver;
  add_solve_report(*solved, *verdict, session.report);
  session.console.notes(solved->notes);
  session.console.say(fmt::format("{}: {} vertices, {}, {}", input_.path(), vertices,
                                  name_of(options_.rules.scheme),
                                  name_of(options_.rules.boundary)));
  session.console.say(fmt::format("{}, {:.3g} s", summary(*solved, *verdict), session.seconds()));
  const std::string required = similar_.summary_of_requirements();
  if (!required.empty()) session.console.say(required);

  const bool reached = solved->converged && verdict->judged() <= solved->tolerance;
  if (reached || keep_best_) {
    if (const auto written = write(mesh, session); !written) return written;
    if (const auto written = write_page(std::move(shown), std::move(given), mesh, session);
        !written) {
      return written;
    }
  }
  return reached ? Result<void>() : not_reached(*solved, verdict->judged());
}

Result<void> Interpolate::not_reached(const SolveReport& solved, double error) const {
  const std::string advice = keep_best_ ? "" : ", or have the best mesh written with --keep-best";
  if (error <= solved.tolerance && method_ == Method::progressive) {
    return fail(ErrorCode::not_converged,
                fmt::format("the positions reached the tolerance {:.3g}, but a channel did not; "
                            "allow more with --max-iterations{}",
                            solved.tolerance, advice));
  }
  // The other methods meet everything from the start: only rounding is at work.
  const std::string missed = similar_.missed_requirement();
  if (error <= solved.tolerance || !missed.empty()) {
    return fail(
        ErrorCode::not_converged,
        fmt::format("the positions {} the tolerance {:.3g}, {} {}{}",
                    error <= solved.tolerance ? "reached" : "did not reach", solved.tolerance,
                    error <= solved.tolerance ? "but" : "and",
                    missed.empty()
                        ? "a channel did not, by rounding, which more iterations would not mend"
                        : missed,
                    advice));
  }
  if (method_ != Method::progressive) {
    return fail(ErrorCode::not_converged,
                fmt::format("the error is {:.3g} of the box side, above the tolerance {:.3g}; "
                            "accept more with --tolerance{}",
                            error, solved.tolerance, advice));
  }
  return fail(ErrorCode::not_converged,
              fmt::format("the error is {:.3g} of the box side, above the tolerance {:.3g}, after "
                          "{}; allow more with --max-iterations, accept more with --tolerance{}",
                          error, solved.tolerance,
                          counted(solved.iterations, "iteration", "iterations"), advice));
}

/// Options that say nothing of the method are refused, not ignored.
Result<void> Interpolate::check_method() {
  if (const auto checked = nonstationary_.check(rules_); !checked) return checked;
  if (rules_.nonstationary()) return check_nonstationary();
  if (const auto checked = similar_.check(method_, rules_); !checked) return checked;
  if (method_ == Method::progressive) {
    if (options_.max_iterations > 0) return {};
    return fail(ErrorCode::invalid_argument,
                "--max-iterations 0 is for --method similarity and fair; progressive interpolation "
                "needs at least one");
  }
  const Solver solver = options_.solver;
  const char* wrong = options_.direct                     ? "--direct"
                      : options_.full_history             ? "--history"
                      : !only_path_.empty()               ? "--only"
                      : !options_.skip_components.empty() ? "--skip-component"
                      : solver != Solver::automatic && solver != Solver::conjugate_gradient &&
                              solver != Solver::gauss_seidel
                          ? "a --solver other than conjugate-gradient and gauss-seidel"
                          : nullptr;
  if (wrong == nullptr) return {};
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} is for --method progressive, not for {}", wrong, name_of(method_)));
}

Result<void> Interpolate::check_nonstationary() const {
  const char* wrong = method_ != Method::progressive         ? "--method"
                      : surface_.wanted()                    ? "--surface"
                      : oracle_                              ? "--oracle"
                      : options_.direct                      ? "--direct"
                      : options_.full_history                ? "--history"
                      : !only_path_.empty()                  ? "--only"
                      : !options_.skip_components.empty()    ? "--skip-component"
                      : options_.solver != Solver::automatic ? "--solver"
                      : max_iterations_.given()              ? "--max-iterations"
                                                             : nullptr;
  if (wrong != nullptr) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("{} is for schemes that need another control mesh; under {} the surface "
                    "of the given mesh interpolates by itself, and -o is that surface",
                    wrong, kNonstationaryLoop));
  }
  return similar_.check(method_, rules_);
}

Result<void> Interpolate::choose_options(const Mesh& given, Session& session) {
  options_.rules = rules_.choose(given, session);
  session.report["method"] = name_of(method_);
  session.report["solver"] = name_of(options_.solver);
  session.report["tolerance"] = options_.tolerance;
  if (const auto checked = check_oracle(oracle_, options_.rules); !checked) return checked;
  if (!only_path_.empty()) {
    Result<std::vector<Index>> only = read_vertex_list(only_path_, given.vertex_count());
    if (!only) return tl::make_unexpected(only.error());
    options_.only = std::move(*only);
    session.report["only"] = options_.only.size();
  }
  return {};
}

Result<void> Interpolate::prepare(const Mesh& given, Session& session) {
  if (method_ != Method::progressive) {
    const auto prepared = similar_.prepare(method_, options_, rules_, given, session);
    if (!prepared) return prepared;
    if (const auto fits = output_.check(similar_.control(), output_.path()); !fits) return fits;
    if (const auto fits = similar_.check_reference(output_); !fits) return fits;
    return surface_.check(similar_.control(), options_.rules.scheme, output_);
  }
  if (const auto fits = output_.check_as_read(given); !fits) return fits;
  const auto fits = surface_.check(given, options_.rules.scheme, output_);
  if (!fits) return fits;
  Result<Interpolator> solver = session.timed(
      "topology", [&] { return Interpolator::create(given, options_, session.context); });
  if (!solver) return tl::make_unexpected(solver.error());
  solver_ = std::move(*solver);
  const bool all = options_.only.empty() && options_.skip_components.empty();
  if (!all) certified_ = solver_->interpolated();
  return {};
}

/// Turns the given mesh into the control mesh; its points become `given`.
Result<SolveReport> Interpolate::solve(Mesh& mesh, std::vector<Point>& given, Session& session) {
  if (method_ != Method::progressive) {
    Result<SolveReport> solved = similar_.solve(mesh, given, session);
    if (solved) record(options_.rules, mesh);
    return solved;
  }
  Result<Solution> solution = session.timed(
      "solve", [&] { return solver_->solve(mesh.points, mesh.channels, session.context); });
  if (!solution) return tl::make_unexpected(solution.error());
  given = std::exchange(mesh.points, std::move(solution->points));
  mesh.channels = std::move(solution->channels);
  mesh.forget("refined");
  record(options_.rules, mesh);
  return std::move(solution->report);
}

/// Of the given vertices.
Result<std::vector<Point>> Interpolate::limit_positions(std::span<const Point> control,
                                                        const Session& session) const {
  return solver_ ? solver_->limit_positions(control, session.context)
                 : similar_.limit_positions(control, session.context);
}

/// Errors are relative to `side`, of the box of all that was given.
Result<Verdict> Interpolate::verify(const Mesh& control, std::span<const Point> given, double side,
                                    Session& session) const {
  return session.timed("verify", [&]() -> Result<Verdict> {
    const auto certify = [&](std::span<const Point> points) -> Result<Certificate> {
      const auto limit = limit_positions(points, session);
      if (!limit) return tl::make_unexpected(limit.error());
      const auto found = certify_listed(*limit, given);
      if (!found) return found;
      return relative_to(side, *found);
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
      verdict.oracle = relative_to(side, *oracle);
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
  if (!certified_->empty()) found->worst_vertex = (*certified_)[found->worst_vertex];
  return found;
}

Result<void> Interpolate::write(const Mesh& control, Session& session) const {
  const auto surface = surface_.make(control, options_.rules, session);
  if (!surface) return tl::make_unexpected(surface.error());
  if (const auto written = output_.write(control, session); !written) return written;
  similar_.note_drawn_ring(output_, session);
  if (output_.format() == Format::stl) {
    session.console.note(
        "STL does not keep the order of the vertices, without which the file cannot be compared "
        "with the given mesh");
  }
  if (const auto written = surface_.write(*surface, output_, session); !written) return written;
  return similar_.write_reference(output_, session);
}

Result<void> Interpolate::write_page(Mesh given, std::vector<Point> points, const Mesh& control,
                                     Session& session) {
  if (!page_.wanted()) return {};
  given.points = std::move(points);
  const InterpolateOptions* rivals = method_ == Method::progressive ? &options_ : nullptr;
  const auto added = session.timed("page", [&] {
    return add_interpolation(page_, given, control, options_.rules, rivals, session);
  });
  return added ? page_.write(session) : added;
}

}  // namespace

std::unique_ptr<Command> make_interpolate() { return std::make_unique<Interpolate>(); }

}  // namespace surpass::cli

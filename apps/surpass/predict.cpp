// surpass predict GIVEN
#include <fmt/format.h>

#include "command.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "rules_option.hpp"
#include "solver_options.hpp"

namespace surpass::cli {

namespace {

class Predict : public Command {
 public:
  void define(Options& options) override {
    input_.define(options, "GIVEN", "The mesh to interpolate");
    rules_.define(options, {});
    add_solver_options(options, options_);
    options.examples(
        "The bound holds before any iteration: `surpass interpolate --direct` does exactly that\n"
        "many sweeps, without testing in between. Bounds are proven for richardson and "
        "chebyshev.\n\n"
        "Examples:\n"
        "  surpass predict given.obj --tolerance 1e-6\n"
        "  surpass predict given.obj --solver richardson --boundary hoppe\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = check_report_path(session, {input_.path()}); !checked) return checked;
    const Result<LoadedMesh> loaded = input_.load(session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    const Mesh& given = loaded->mesh;
    options_.rules = rules_.choose(given, session);
    if (options_.solver == Solver::automatic) options_.solver = Solver::chebyshev;
    session.report["solver"] = name_of(options_.solver);
    session.report["tolerance"] = options_.tolerance;

    const Result<Interpolator> solver = session.timed(
        "topology", [&] { return Interpolator::create(given, options_, session.context); });
    if (!solver) return tl::make_unexpected(solver.error());
    const Result<Prediction> prediction = solver->predict(given.points);
    if (!prediction) return tl::make_unexpected(prediction.error());
    session.report["prediction"] = {
        {"sweeps", prediction->sweeps},
        {"boundary_sweeps", prediction->boundary_sweeps},
        {"lowest_eigenvalue", prediction->lowest_eigenvalue},
        {"boundary_lowest_eigenvalue", prediction->boundary_lowest_eigenvalue}};
    return session.print_result(sentences(*prediction));
  }

 private:
  [[nodiscard]] std::string sentences(const Prediction& p) const {
    std::string text =
        fmt::format("surface  {} sweeps of {} reach {} (spectrum in [{:.6g}, 1])\n", p.sweeps,
                    name_of(options_.solver), options_.tolerance, p.lowest_eigenvalue);
    if (p.boundary_sweeps > 0) {
      text += fmt::format("curves   {} sweeps (spectrum in [{:.6g}, 1])\n", p.boundary_sweeps,
                          p.boundary_lowest_eigenvalue);
    }
    return text;
  }

  MeshInput input_;
  RulesOption rules_;
  InterpolateOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_predict() { return std::make_unique<Predict>(); }

}  // namespace surpass::cli

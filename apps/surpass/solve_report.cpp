#include "solve_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "evaluator.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

Json history_json(const std::vector<Iteration>& history) {
  Json json = Json::array();
  for (const Iteration& i : history) {
    json.push_back({{"iteration", i.iteration}, {"max", i.max}, {"mean", i.mean}});
  }
  return json;
}

}  // namespace

double Verdict::judged() const { return oracle ? std::max(exact.max, oracle->max) : exact.max; }

void add_solve_report(const SolveReport& solved, const Verdict& verdict, Json& report) {
  report["tolerance"] = solved.tolerance;
  report["converged"] = solved.converged && verdict.judged() <= solved.tolerance;
  report["iterations"] = solved.iterations;
  report["boundary_iterations"] = solved.boundary_iterations;
  report["error"] = {{"initial_max", solved.initial.max},
                     {"initial_mean", solved.initial.mean},
                     {"max", verdict.exact.max},
                     {"mean", verdict.exact.mean}};
  if (verdict.stored) report["error_stored"] = certificate_json(*verdict.stored);
  if (verdict.oracle) report["oracle"] = certificate_json(*verdict.oracle);
  report["history"] = history_json(solved.history);
  if (!solved.boundary_history.empty()) {
    report["boundary_history"] = history_json(solved.boundary_history);
  }
}

std::string summary(const SolveReport& solved, const Verdict& verdict) {
  std::string text = fmt::format("error {:.3g} -> {:.3g} of the box side (mean {:.3g}), {}",
                                 solved.initial.max, verdict.exact.max, verdict.exact.mean,
                                 counted(solved.iterations, "iteration", "iterations"));
  if (solved.boundary_iterations > 0) {
    text += fmt::format(" + {} on curves", solved.boundary_iterations);
  }
  if (verdict.stored) text += fmt::format("; {:.3g} as stored", verdict.stored->max);
  if (verdict.oracle) {
    text += fmt::format("; {:.3g} by {}", verdict.oracle->max, verdict.oracle->evaluator);
  }
  return text;
}

}  // namespace surpass::cli

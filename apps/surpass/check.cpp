// surpass check CONTROL --against GIVEN
#include <fmt/format.h>

#include "command.hpp"
#include "evaluator.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "requirements_input.hpp"
#include "rules_option.hpp"
#include "solver_options.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

/// What the surface does of all that it shall do.
struct Findings {
  std::string table;    ///< a line for each thing that was compared
  double vertices = 0;  ///< the largest error of them by any evaluator
  double side = 1;      ///< of the box that errors are relative to
  std::vector<Requirement> requirements = {};
  std::vector<RequirementOutcome> outcomes = {};  ///< #requirements
};

class Check : public Command {
 public:
  void define(Options& options) override {
    options.add("CONTROL", control_path_, "The control mesh; '-' is the standard input").required();
    options
        .add("--against", given_path_,
             "The mesh whose vertices its limit surface shall pass through, vertex i at "
             "vertex i; '-' is the standard input")
        .required()
        .type_name("GIVEN")
        .group("Input");
    add_from(options, from_, "Format of the input that is '-'");
    given_mending_.define(options);
    rules_.define(options, {.nonstationary = true});
    nonstationary_.define(options);
    requirements_.define(
        options, "Certificate",
        "; the file that interpolate had. Vertices that it moves are compared with "
        "their new place, those that it lets go are not");
    add_tolerance(options, tolerance_);
    add_oracle(options, oracle_);
    options.examples(
        "Mending options apply to GIVEN, under nonstationary-loop to CONTROL, too; repeat those "
        "that\n"
        "`interpolate` was given.\n"
        "Control meshes of --method similarity and fair have the given vertices first; a comment\n"
        "in the file (refined=1) tells so. Under doo-sabin they have a face for each, which is\n"
        "found by the faces of GIVEN.\n"
        "Scheme and boundary rule are taken from the control mesh if surpass wrote it.\n"
        "With --requirements or --normals each of them is evaluated on the surface of CONTROL.\n"
        "--oracle judges the vertices alone, at the places that they shall have.\n"
        "Under nonstationary-loop CONTROL is the given mesh itself, and the surface that it makes\n"
        "is evaluated; or it is a surface that subdivide or interpolate wrote, whose first "
        "vertices\n"
        "are compared.\n"
        "Exit code 0 if every error is within the tolerance, else 4.\n\n"
        "Examples:\n"
        "  surpass check control.obj --against given.obj\n"
        "  surpass check control.ply --against given.ply --tolerance 1e-12 --oracle\n"
        "  surpass check control.obj --against given.obj --requirements wishes.json\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = nonstationary_.check(rules_); !checked) return checked;
    if (const auto meant = check_options(); !meant) return meant;
    std::vector<std::string> inputs = requirements_.inputs();
    for (const std::string& path : nonstationary_.inputs()) inputs.push_back(path);
    inputs.insert(inputs.end(), {control_path_, given_path_});
    const auto paths = check_report_path(session, inputs);
    if (!paths) return paths;
    Result<LoadedMesh> control = load(control_path_, session);
    if (!control) return tl::make_unexpected(control.error());
    Result<LoadedMesh> given = load(given_path_, session);
    if (!given) return tl::make_unexpected(given.error());
    const auto mended = given_mending_.apply(given->mesh, session);
    if (!mended) return mended;
    if (rules_.nonstationary()) {
      // There it may be the given mesh itself.
      const auto alike = given_mending_.apply(control->mesh, session);
      if (!alike) return alike;
    }
    if (session.reporting()) {
      session.report["input"] = mesh_json(given_path_, given->mesh);
      session.report["control"] = mesh_json(control_path_, control->mesh);
    }
    const Rules rules = rules_.choose(control->mesh, session);
    if (const auto possible = check_oracle(oracle_, rules); !possible) return possible;
    if (rules_.nonstationary())
      return judge_nonstationary(control->mesh, given->mesh, rules, session);
    if (const auto same = check_counts(control->mesh, given->mesh); !same) return same;
    return judge(control->mesh, given->mesh, rules, session);
  }

 private:
  Result<void> check_options() const {
    if (!rules_.nonstationary() || !requirements_.given()) return {};
    return fail(ErrorCode::invalid_argument,
                fmt::format("under {} there are no requirements; leave out --requirements and "
                            "--normals",
                            kNonstationaryLoop));
  }

  Result<LoadedMesh> load(const std::string& path, Session& session) const {
    return load_mesh(path, path == "-" ? from_ : Format::automatic, session);
  }

  Result<void> check_counts(const Mesh& control, const Mesh& given) const {
    if (check_vertex_counts(control, given.points.size())) return {};
    return fail(
        ErrorCode::mismatch,
        fmt::format("{} has {} vertices and {} has {}; a control mesh has those of the mesh "
                    "it was made from. Is it a refined surface, or was the given mesh "
                    "mended (repeat --weld, --repair)? A surface that passes through the points "
                    "by itself is checked with --scheme nonstationary-loop",
                    control_path_, control.vertex_count(), given_path_, given.vertex_count()));
  }

  Result<void> judge(const Mesh& control, const Mesh& given, const Rules& rules,
                     Session& session) const {
    if (requirements_.given()) return judge_required(control, given, rules, session);
    const Result<Certificate> own =
        session.timed("verify", [&] { return certify(control, given, rules, session.context); });
    if (!own) return tl::make_unexpected(own.error());
    Findings findings = findings_of(*own, session);
    if (const auto asked = ask_oracle(control, given.points, rules, findings, session); !asked) {
      return asked;
    }
    return conclude(findings, given.points, rules, session);
  }

  Result<void> judge_required(const Mesh& control, const Mesh& given, const Rules& rules,
                              Session& session) const {
    auto requirements = requirements_.load(given, rules, session);
    if (!requirements) return tl::make_unexpected(requirements.error());
    auto own = session.timed("verify", [&] {
      return certify_required(control, given, rules, *requirements, session.context);
    });
    if (!own) return tl::make_unexpected(own.error());
    session.report["replaced"] = own->replaced;
    session.report["removed"] = own->removed;
    if (own->replaced + own->removed > 0) {
      session.console.note(fmt::format(
          "of {} given vertices {}, and {}", given.points.size(),
          own->replaced == 0
              ? "none is moved by requirements"
              : counted(own->replaced, "is moved by requirements, compared with the new place",
                        "are moved by requirements, compared with the new place"),
          own->removed == 0
              ? "none removed"
              : counted(own->removed, "is removed, not compared", "are removed, not compared")));
    }
    Findings findings = findings_of(own->vertices, session);
    findings.requirements = std::move(*requirements);
    findings.outcomes = std::move(own->outcomes);
    if (const auto asked = ask_oracle(control, own->targets, rules, findings, session); !asked) {
      return asked;
    }
    session.report["requirements"] = outcomes_json(findings.requirements, findings.outcomes);
    findings.table += line(findings);
    return conclude(findings, own->targets, rules, session);
  }

  static Findings findings_of(const Certificate& own, Session& session) {
    session.report["error"] = certificate_json(own);
    return {line(own), own.max, own.box_side};
  }

  Result<void> ask_oracle(const Mesh& control, std::span<const Point> aims, const Rules& rules,
                          Findings& findings, Session& session) const {
    if (!oracle_) return {};
    const Result<Certificate> found =
        session.timed("verify", [&] { return certify_by_oracle(control, aims, rules); });
    if (!found) return tl::make_unexpected(found.error());
    const Certificate oracle = relative_to(findings.side, *found);
    session.console.notes(oracle.notes);
    session.report["oracle"] = certificate_json(oracle);
    findings.table += line(oracle);
    findings.vertices = std::max(findings.vertices, oracle.max);
    return {};
  }

  /// A surface that was written has the given vertices first; else the given mesh is what makes it,
  /// and its limit is taken from its first refinement.
  Result<void> judge_nonstationary(const Mesh& control, const Mesh& given, const Rules& rules,
                                   Session& session) const {
    if (oracle_) {
      return fail(ErrorCode::invalid_argument,
                  "OpenSubdiv has no nonstationary-loop; leave out --oracle");
    }
    const std::size_t n = given.points.size();
    if (control.points.size() < n) return check_counts(control, given);
    const auto surface = nonstationary_.create(given, rules_, 0, session);
    if (!surface) return tl::make_unexpected(surface.error());
    const auto found = session.timed("verify", [&]() -> Result<std::vector<Point>> {
      if (control.points.size() > n) return control.points;
      auto refined = nonstationary_.refined(control, rules_, 0, 1, session);
      if (!refined) return tl::make_unexpected(refined.error());
      return refined->limit_positions(session.context);
    });
    if (!found) return tl::make_unexpected(found.error());
    const auto own = compare_points(std::span(*found).first(n), surface->aims(), "surpass");
    if (!own) return tl::make_unexpected(own.error());
    return conclude(findings_of(*own, session), given.points, rules, session);
  }

  Result<void> conclude(const Findings& findings, std::span<const Point> given, const Rules& rules,
                        Session& session) const {
    const double tolerance = floored_tolerance(tolerance_, flat(given), findings.side);
    session.console.notes(notes_on(findings.requirements, findings.outcomes, tolerance));
    const auto [missed, worst] = missed_by_more(findings, tolerance);
    const bool within = missed.empty();
    session.report["tolerance"] = tolerance;
    session.report["converged"] = within;
    if (const auto printed = session.print_result(findings.table); !printed) return printed;
    if (within) return {};
    constexpr double kSinglePrecision = 1e-6;
    const char* advice =
        worst > kSinglePrecision ? "" : "; if a file holds 32-bit numbers, try --tolerance 1e-6";
    return fail(ErrorCode::not_converged,
                fmt::format("the surface misses {} of the box side, more than the tolerance {:.3g} "
                            "(rules: {}, {}){}",
                            missed, tolerance, session.report["scheme"].get<std::string>(),
                            name_of(rules.boundary), advice));
  }

  struct Missed {
    std::string what = {};  ///< with amounts; empty if nothing is
    double worst = 0;
  };

  static Missed missed_by_more(const Findings& findings, double tolerance) {
    Missed missed;
    const auto add = [&](const std::string& what, double error) {
      missed.what += fmt::format("{}{} by {:.3g}", missed.what.empty() ? "" : " and ", what, error);
      missed.worst = std::max(missed.worst, error);
    };
    if (!(findings.vertices <= tolerance)) add("the given vertices", findings.vertices);
    if (!all_met(findings.outcomes, tolerance)) {
      const std::size_t i = worst_of(findings.outcomes);
      add(fmt::format("requirement {} ({}{})", i, describe(findings.requirements[i]),
                      findings.outcomes[i].flipped ? ", the other way round" : ""),
          findings.outcomes[i].error);
    }
    return missed;
  }

  static std::string line(const Certificate& c) {
    return fmt::format("{:16}  max {:.6g} at vertex {}, mean {:.6g} of the box side {:.6g}\n",
                       c.evaluator, c.max, c.worst_vertex, c.mean, c.box_side);
  }

  static std::string line(const Findings& findings) {
    const std::size_t count = findings.outcomes.size();
    if (count == 0) return "requirements      none\n";
    const std::size_t i = worst_of(findings.outcomes);
    return fmt::format("requirements      max {:.6g} at {} ({}), {} of them\n",
                       findings.outcomes[i].error, i, describe(findings.requirements[i]), count);
  }

  std::string control_path_;
  std::string given_path_;
  Format from_ = Format::automatic;
  Mending given_mending_;
  RulesOption rules_;
  Nonstationary nonstationary_;
  RequirementsInput requirements_;
  double tolerance_ = InterpolateOptions{}.tolerance;
  bool oracle_ = false;
};

}  // namespace

std::unique_ptr<Command> make_check() { return std::make_unique<Check>(); }

}  // namespace surpass::cli

// surpass subdivide MESH -o OUT --levels N [--limit]
#include <fmt/format.h>

#include "command.hpp"
#include "html_report.hpp"
#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "rules_option.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

class Subdivide : public Command {
 public:
  void define(Options& options) override {
    input_.define(options, "MESH", "The control mesh to refine");
    output_.define(options, "-o,--output", "The refined mesh");
    page_.define(options);
    rules_.define(options, {.nonstationary = true});
    add_levels(options, levels_, "Refinement steps").required().group("Surface");
    options
        .flag("--limit", limit_,
              "Move the result onto the limit surface, with its normals where the format has "
              "a place for them")
        .group("Surface");
    nonstationary_.define(options);
    options.examples(
        "Scheme and boundary rule are taken from the control mesh if surpass wrote it.\n"
        "Under nonstationary-loop the parameters are solved so that the mesh after the last level\n"
        "contains the vertices of MESH, or with --limit the limit surface does.\n\n"
        "Examples:\n"
        "  surpass subdivide control.obj -o fine.ply --levels 3 --limit\n"
        "  surpass subdivide cage.off -o step.off --levels 1 --boundary hoppe\n"
        "  surpass subdivide given.obj -o smooth.ply --levels 5 --scheme nonstationary-loop\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = nonstationary_.check(rules_); !checked) return checked;
    if (nonstationary_.has_targets() && levels_ == 0 && !limit_) {
      return fail(ErrorCode::invalid_argument,
                  "--levels 0 without --limit writes MESH as it is, which passes through no "
                  "--targets; take one level or more, or --limit");
    }
    std::vector<std::string> inputs = nonstationary_.inputs();
    inputs.push_back(input_.path());
    const auto prepared = output_.prepare(session, inputs);
    if (!prepared) return prepared;
    const auto ready = page_.prepare(session, {input_.path()}, {output_.path()});
    if (!ready) return ready;
    const Result<LoadedMesh> loaded = input_.load(session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    output_.default_format(loaded->format);
    const Rules rules = rules_.choose(loaded->mesh, session);
    session.report["levels"] = levels_;
    session.report["limit"] = limit_;
    if (const auto checked = check_levels(loaded->mesh, levels_); !checked) return checked;
    const Scheme faces = rules_.nonstationary() ? Scheme::loop : rules.scheme;
    const auto fits = output_.check_refined(loaded->mesh, faces, levels_, output_.path());
    if (!fits) return fits;

    Result<Mesh> refined = rules_.nonstationary() ? refine_nonstationary(loaded->mesh, session)
                                                  : refine_stationary(loaded->mesh, rules, session);
    if (!refined) return tl::make_unexpected(refined.error());
    session.console.say(
        fmt::format("{} vertices, {} faces after {} of {}, {}{}", refined->vertex_count(),
                    refined->face_count(), counted(levels_, "level", "levels"),
                    session.report["scheme"].get<std::string>(), name_of(rules.boundary),
                    limit_ ? ", on the limit surface" : ""));
    if (const auto written = output_.write(*refined, session); !written) return written;
    return write_page(loaded->mesh, *refined, session);
  }

 private:
  Result<Mesh> refine_stationary(const Mesh& mesh, const Rules& rules, Session& session) const {
    Result<Mesh> refined = session.timed("refine", [&] {
      return limit_ ? limit_mesh(mesh, rules, levels_, session.context)
                    : refine(mesh, rules, levels_, session.context);
    });
    if (refined && !limit_) record(rules, *refined);
    return refined;
  }

  Result<Mesh> refine_nonstationary(const Mesh& mesh, Session& session) const {
    const auto surface =
        nonstationary_.refined(mesh, rules_, limit_ ? 0 : levels_, levels_, session);
    if (!surface) return tl::make_unexpected(surface.error());
    Result<Mesh> refined =
        limit_ ? session.timed("refine", [&] { return surface->limit_mesh(session.context); })
               : surface->mesh();
    // It is no control mesh: going on with another scheme would leave the vertices.
    if (refined) forget_rules(*refined);
    return refined;
  }

  Result<void> write_page(const Mesh& control, const Mesh& refined, Session& session) {
    if (!page_.wanted()) return {};
    page_.add("control", "Control mesh", LayerKind::cage, control);
    if (limit_) {
      const auto added = page_.add_surface("surface", "Limit surface", refined, session.context);
      if (!added) return added;
    } else {
      page_.add("surface", "Refined mesh", LayerKind::mesh, refined);
    }
    return page_.write(session);
  }

  MeshInput input_;
  MeshOutput output_;
  HtmlReport page_;
  RulesOption rules_;
  Nonstationary nonstationary_;
  int levels_ = 0;
  bool limit_ = false;
};

}  // namespace

std::unique_ptr<Command> make_subdivide() { return std::make_unique<Subdivide>(); }

}  // namespace surpass::cli

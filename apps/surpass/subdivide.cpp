// surpass subdivide MESH -o OUT --levels N [--limit]
#include <fmt/format.h>

#include "command.hpp"
#include "html_report.hpp"
#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "rules_option.hpp"

namespace surpass::cli {

namespace {

class Subdivide : public Command {
 public:
  void define(Options& options) override {
    input_.define(options, "MESH", "The control mesh to refine");
    output_.define(options, "-o,--output", "The refined mesh");
    page_.define(options);
    rules_.define(options);
    add_levels(options, levels_, "Refinement steps").required().group("Surface");
    options
        .flag("--limit", limit_,
              "Move the result onto the limit surface, with its normals where the format has "
              "a place for them")
        .group("Surface");
    options.examples(
        "Scheme and boundary rule are taken from the control mesh if surpass wrote it.\n\n"
        "Examples:\n"
        "  surpass subdivide control.obj -o fine.ply --levels 3 --limit\n"
        "  surpass subdivide cage.off -o step.off --levels 1 --boundary hoppe\n");
  }

  Result<void> run(Session& session) override {
    const auto prepared = output_.prepare(session, {input_.path()});
    if (!prepared) return prepared;
    const auto ready = page_.prepare({input_.path()}, {output_.path(), session.report_path});
    if (!ready) return ready;
    const Result<LoadedMesh> loaded = input_.load(session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    output_.default_format(loaded->format);
    const Rules rules = rules_.choose(loaded->mesh, session);
    session.report["levels"] = levels_;
    session.report["limit"] = limit_;
    if (const auto checked = check_levels(loaded->mesh, levels_); !checked) return checked;

    Result<Mesh> refined = session.timed("refine", [&] {
      return limit_ ? limit_mesh(loaded->mesh, rules, levels_, session.context)
                    : refine(loaded->mesh, rules, levels_, session.context);
    });
    if (!refined) return tl::make_unexpected(refined.error());
    if (!limit_) record(rules, *refined);
    session.console.say(fmt::format(
        "{} vertices, {} faces after {} {} of {}, {}{}", refined->vertex_count(),
        refined->face_count(), levels_, levels_ == 1 ? "level" : "levels", name_of(rules.scheme),
        name_of(rules.boundary), limit_ ? ", on the limit surface" : ""));
    if (const auto written = output_.write(*refined, session); !written) return written;
    return write_page(loaded->mesh, *refined, session);
  }

 private:
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
  int levels_ = 0;
  bool limit_ = false;
};

}  // namespace

std::unique_ptr<Command> make_subdivide() { return std::make_unique<Subdivide>(); }

}  // namespace surpass::cli

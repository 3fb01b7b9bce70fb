// surpass inspect MESH
#include <optional>

#include <fmt/format.h>

#include "anatomy.hpp"
#include "command.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"

namespace surpass::cli {

namespace {

class Inspect : public Command {
 public:
  void define(Options& options) override {
    input_.define(options, "MESH", "The mesh to look at");
    options
        .choice("--scheme", scheme_, all_schemes(),
                "The scheme that shall accept the mesh; by default loop for triangles and "
                "catmull-clark for other faces")
        .group("Surface");
    options.examples(
        "Exit code 0 if the mesh would be accepted, 3 if it would be refused; all is printed\n"
        "before. Mending options show what they would do.\n\n"
        "Examples:\n"
        "  surpass inspect scan.ply\n"
        "  surpass inspect broken.obj --repair --triangulate\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = check_report_path(session, {input_.path()}); !checked) return checked;
    const Result<LoadedMesh> loaded = input_.load(session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    const Mesh& mesh = loaded->mesh;

    const Scheme scheme = scheme_.value_or(suggested_scheme(mesh));
    const Anatomy anatomy = session.timed("inspect", [&] { return examine(mesh, scheme); });
    session.report["scheme"] = name_of(scheme);
    session.report["anatomy"] = anatomy_json(mesh, anatomy);
    const std::string table =
        fmt::format("{:20}{} ({})\n", "file", input_.path(), name_of(loaded->format)) +
        anatomy_table(mesh, anatomy);
    if (const auto printed = session.print_result(table); !printed) return printed;
    if (anatomy.diagnosis.refusals.empty()) return {};
    return tl::make_unexpected(anatomy.diagnosis.refusals.front());
  }

 private:
  MeshInput input_;
  std::optional<Scheme> scheme_;
};

}  // namespace

std::unique_ptr<Command> make_inspect() { return std::make_unique<Inspect>(); }

}  // namespace surpass::cli

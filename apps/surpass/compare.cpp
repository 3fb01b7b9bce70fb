// surpass compare A B
#include <surpass/quality.hpp>

#include <fmt/format.h>

#include "command.hpp"
#include "distance_field.hpp"
#include "html_report.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"

namespace surpass::cli {

namespace {

Json one_sided_json(const OneSided& d) {
  return {
      {"max", d.max}, {"max_bound", d.max_bound}, {"mean", d.mean}, {"rms", d.rms}, {"at", d.at}};
}

std::string table(const Deviation& d) {
  const auto row = [](const char* name, const OneSided& side) {
    return fmt::format("{:8}{:<14.6g}{:<14.6g}{:<14.6g}{:<14.6g}({:.6g}, {:.6g}, {:.6g})\n", name,
                       side.max, side.max_bound, side.mean, side.rms, side.at[0], side.at[1],
                       side.at[2]);
  };
  const double side = d.box_side > 0 ? d.box_side : 1;
  return fmt::format("{:8}{:14}{:14}{:14}{:14}{}\n", "", "max", "at most", "mean", "rms",
                     "where the maximum is") +
         row("A to B", d.a_to_b) + row("B to A", d.b_to_a) +
         fmt::format("Hausdorff distance {:.6g} (at most {:.6g}), {:.6g} of A's box side {:.6g}\n",
                     d.hausdorff, d.hausdorff_bound, d.hausdorff / side, d.box_side);
}

class Compare : public Command {
 public:
  void define(Options& options) override {
    options.add("A", a_, "The first surface; '-' is the standard input").required();
    options.add("B", b_, "The second surface; '-' is the standard input").required();
    add_from(options, from_, "Format of the input that is '-'");
    options
        .add("--accuracy", accuracy_,
             "How near the found maximum is to its proven bound, relative to the largest "
             "side of A's bounding box (1e-9 to 1)")
        .in_range(1e-9, 1.0)
        .type_name("X")
        .default_text(fmt::format("{}", accuracy_))
        .group("Distance");
    page_.define(options);
    options.examples(
        "Distances are from triangle to triangle, in the units of the files; polygons are cut\n"
        "into triangles. 'at most' is a proven bound of the maximum.\n\n"
        "Examples:\n"
        "  surpass compare given.obj surface.ply\n"
        "  surpass compare a.off b.off --accuracy 1e-7 --report distances.json\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = check_report_path(session, {a_, b_}); !checked) return checked;
    if (const auto ready = page_.prepare(session, {a_, b_}, {}); !ready) return ready;
    const Result<LoadedMesh> a = load(a_, "a", session);
    if (!a) return tl::make_unexpected(a.error());
    const Result<LoadedMesh> b = load(b_, "b", session);
    if (!b) return tl::make_unexpected(b.error());

    const Result<Deviation> found = session.timed(
        "compare", [&] { return deviation(a->mesh, b->mesh, accuracy_, session.context); });
    if (!found) return tl::make_unexpected(found.error());
    session.report["distance"] = {{"a_to_b", one_sided_json(found->a_to_b)},
                                  {"b_to_a", one_sided_json(found->b_to_a)},
                                  {"hausdorff", found->hausdorff},
                                  {"hausdorff_bound", found->hausdorff_bound},
                                  {"box_side", found->box_side},
                                  {"accuracy", accuracy_}};
    if (const auto written = write_page(a->mesh, b->mesh, session); !written) return written;
    return session.print_result(table(*found));
  }

 private:
  // The meshes as they are, and coloured by how far the other one is.
  Result<void> write_page(const Mesh& a, const Mesh& b, Session& session) {
    if (!page_.wanted()) return {};
    const auto from_a = distance_field(a, b, session.context);
    if (!from_a) return tl::make_unexpected(from_a.error());
    const auto from_b = distance_field(b, a, session.context);
    if (!from_b) return tl::make_unexpected(from_b.error());
    page_.add("a", "A", LayerKind::mesh, a);
    page_.add("b", "B", LayerKind::mesh, b);
    page_.add("a-to-b", "A, distance to B", LayerKind::surface, *from_a);
    page_.add("b-to-a", "B, distance to A", LayerKind::surface, *from_b);
    return page_.write(session);
  }

  Result<LoadedMesh> load(const std::string& path, const char* key, Session& session) const {
    Result<LoadedMesh> loaded = load_mesh(path, path == "-" ? from_ : Format::automatic, session);
    if (loaded && session.is_read()) session.report[key] = mesh_json(path, loaded->mesh);
    return loaded;
  }

  HtmlReport page_;
  std::string a_;
  std::string b_;
  Format from_ = Format::automatic;
  double accuracy_ = 1e-5;
};

}  // namespace

std::unique_ptr<Command> make_compare() { return std::make_unique<Compare>(); }

}  // namespace surpass::cli

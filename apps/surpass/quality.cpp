// surpass quality MESH... [--reference MESH]
#include <surpass/fairness.hpp>

#include <algorithm>

#include <fmt/format.h>

#include "command.hpp"
#include "fairness_table.hpp"
#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "rules_option.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

class Quality : public Command {
 public:
  void define(Options& options) override {
    options
        .add("MESH", paths_,
             "Control meshes whose limit surfaces are measured, side by side; '-' is the standard "
             "input")
        .required()
        .type_name("...");
    add_from(options, from_, "Format of the input that is '-'");
    options
        .add(
            "--reference", reference_path_,
            "A control mesh with the same faces, or with those of a refined one; hole faces do not "
            "count. The angles between its normals and those of each MESH are measured, too")
        .type_name("MESH2")
        .group("Input");
    rules_.define(options, {.nonstationary = true});
    nonstationary_.define(options, true);
    levels_option_ =
        options
            .add("--levels", options_.levels,
                 "Refinements before the surface is sampled (1 to 10), of the coarsest MESH; one "
                 "less for each level that another is finer. By default enough for 200000 "
                 "patches, and at least 3")
            .in_range(1, 10)
            .type_name("N")
            .default_text("");
    levels_option_.group("Surface");
    options
        .add("--rings", options_.rings,
             "Rings of samples left out around an extraordinary one, where curvature need not be "
             "bounded (0 to 1000)")
        .in_range(0, 1000)
        .type_name("N")
        .default_text(std::to_string(options_.rings))
        .group("Surface");
    options.examples(
        "bending: integral of k1^2 + k2^2, the principal curvatures. thin plate: integral of\n"
        "|Suu|^2 + 2 |Suv|^2 + |Svv|^2 over the control mesh's own parameters. curvature\n"
        "variation: integral of |grad H|^2, H the mean curvature; total variation: of |grad H|.\n"
        "99 % curvature: the largest apart from the sharpest hundredth (1 %) of the area. "
        "'relative'\n"
        "does not change with the size of the mesh: lengths are divided by the root of the area\n"
        "measured. Compare at one number of levels, and surfaces of the same faces.\n"
        "Scheme and boundary rule are taken from the control mesh if surpass wrote it.\n\n"
        "Examples:\n"
        "  surpass quality control.obj\n"
        "  surpass quality plain.obj fair.obj --reference given.obj --report quality.json\n"
        "  surpass quality cage.off --scheme doo-sabin --levels 5 --rings 4\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = nonstationary_.check(rules_); !checked) return checked;
    if (rules_.nonstationary() && !reference_path_.empty()) {
      return fail(ErrorCode::invalid_argument,
                  "--reference is not for nonstationary-loop; leave it out");
    }
    std::vector<std::string> inputs = paths_;
    for (const std::string& path : nonstationary_.inputs()) inputs.push_back(path);
    if (!reference_path_.empty()) inputs.push_back(reference_path_);
    if (const auto checked = check_report_path(session, inputs); !checked) return checked;
    std::vector<Mesh> meshes;
    for (const std::string& path : paths_) {
      auto mesh = load(path, session);
      if (!mesh) return tl::make_unexpected(mesh.error());
      session.report["surfaces"].push_back({{"mesh", mesh_json(path, *mesh)}});
      meshes.push_back(std::move(*mesh));
    }
    std::optional<Mesh> reference;
    if (!reference_path_.empty()) {
      auto mesh = load(reference_path_, session);
      if (!mesh) return tl::make_unexpected(mesh.error());
      session.report["reference"] = mesh_json(reference_path_, *mesh);
      reference = std::move(*mesh);
    }
    const auto rules = common_rules(meshes, session);
    if (!rules) return tl::make_unexpected(rules.error());
    session.report["rings"] = options_.rings;
    const auto levels = levels_of(meshes, reference);
    if (!levels) return tl::make_unexpected(levels.error());

    std::vector<MeasuredSurface> surfaces;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      FairnessOptions options = options_;
      options.levels = (*levels)[i];
      auto measured =
          rules_.nonstationary()
              ? measure_nonstationary(paths_[i], meshes[i], options, session)
              : session.timed("measure", [&] {
                  return measure(paths_[i], meshes[i], reference, *rules, options, session.context);
                });
      if (!measured) {
        // Which of several meshes it was is not in the sentence.
        measured.error().place.file = paths_[i];
        return tl::make_unexpected(measured.error());
      }
      session.report["surfaces"][i].update(fairness_json(*measured));
      surfaces.push_back(std::move(*measured));
    }
    note_other_patches(surfaces, session);
    return session.print_result(fairness_table(surfaces, options_.rings));
  }

 private:
  Result<Mesh> load(const std::string& path, Session& session) const {
    auto loaded = load_mesh(path, path == "-" ? from_ : Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    return std::move(loaded->mesh);
  }

  Result<Rules> common_rules(const std::vector<Mesh>& meshes, Session& session) const {
    const Rules first = rules_.choose(meshes.front(), session);
    for (std::size_t i = 1; i < meshes.size(); ++i) {
      const Rules other = rules_.choose(meshes[i], session);
      if (other == first) continue;
      return fail(ErrorCode::mismatch,
                  fmt::format("{} is a {} surface ({}) and {} a {} surface ({}); name one for all "
                              "with --scheme and --boundary, or measure them one by one",
                              paths_.front(), name_of(first.scheme), name_of(first.boundary),
                              paths_[i], name_of(other.scheme), name_of(other.boundary)));
    }
    return first;
  }

  // As many for each as give the same patches: methods differ in how fine their control meshes are.
  Result<std::vector<int>> levels_of(const std::vector<Mesh>& meshes,
                                     const std::optional<Mesh>& reference) const {
    const Mesh& coarsest =
        *std::min_element(meshes.begin(), meshes.end(),
                          [](const Mesh& a, const Mesh& b) { return level_difference(a, b) < 0; });
    int finest = 0;
    for (const Mesh& mesh : meshes) finest = std::max(finest, level_difference(mesh, coarsest));
    if (reference) finest = std::max(finest, level_difference(*reference, coarsest));
    int levels = options_.levels;
    if (!levels_option_.given()) levels = std::max(fairness_levels(coarsest), finest + 1);
    if (levels <= finest) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("--levels {} is too few: one of the meshes is {} finer than the "
                              "coarsest; take {} or more",
                              levels, counted(finest, "level", "levels"), finest + 1));
    }
    std::vector<int> found;
    for (const Mesh& mesh : meshes) {
      found.push_back(levels - level_difference(mesh, coarsest));
      if (auto ok = check_levels(mesh, found.back()); !ok) return tl::make_unexpected(ok.error());
    }
    return found;
  }

  static Result<MeasuredSurface> measure(const std::string& path, const Mesh& mesh,
                                         const std::optional<Mesh>& reference, const Rules& rules,
                                         const FairnessOptions& options, const Context& context) {
    const auto found = fairness(mesh, rules, options, context);
    if (!found) return tl::make_unexpected(found.error());
    MeasuredSurface surface{path, *found};
    if (!reference) return surface;
    const auto angles = normal_deviation(mesh, *reference, rules, options, context);
    if (!angles) return tl::make_unexpected(angles.error());
    surface.deviation = *angles;
    return surface;
  }

  Result<MeasuredSurface> measure_nonstationary(const std::string& path, const Mesh& mesh,
                                                const FairnessOptions& options,
                                                Session& session) const {
    const auto scheme = nonstationary_.choose(mesh, rules_, 0, session, options);
    if (!scheme) return tl::make_unexpected(scheme.error());
    const auto found =
        session.timed("measure", [&] { return fairness(mesh, *scheme, options, session.context); });
    if (!found) return tl::make_unexpected(found.error());
    return MeasuredSurface{path, *found};
  }

  static void note_other_patches(const std::vector<MeasuredSurface>& surfaces, Session& session) {
    const auto patches = [](const MeasuredSurface& s) { return s.fairness.coverage.patches; };
    for (const MeasuredSurface& s : surfaces) {
      if (patches(s) == patches(surfaces.front())) continue;
      session.console.note(
          "the surfaces have different numbers of patches, so other parts of them are left out; "
          "their measures cannot be compared to the last digit");
      return;
    }
  }

  std::vector<std::string> paths_;
  std::string reference_path_;
  Format from_ = Format::automatic;
  RulesOption rules_;
  Nonstationary nonstationary_;
  Option levels_option_;
  FairnessOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_quality() { return std::make_unique<Quality>(); }

}  // namespace surpass::cli

// surpass render MESH... -o PNG
//
// Meshes, or with --levels their limit surfaces, in one or several styles, side by side in one
// view.
#include "command.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "nonstationary.hpp"
#include "picture.hpp"
#include "rules_option.hpp"

namespace surpass::cli {

namespace {

// A mesh, or points where the format has nothing else.
Result<LoadedMesh> load_shape(const std::string& path, Format format, Session& session) {
  const bool is_named = format == Format::automatic && path != "-";
  const bool points_only = (is_named ? format_of_path(path) : format) == Format::xyz;
  return points_only ? load_points(path, format, session) : load_mesh(path, format, session);
}

// To the mesh whose rules they are.
void move_rules(Json& report, Json& input) {
  for (const char* key : {"scheme", "boundary", "weights", "nonstationary"}) {
    if (report.contains(key)) input[key] = report[key];
    report.erase(key);
  }
}

class Render : public Command {
 public:
  void define(Options& options) override;
  Result<void> run(Session& session) override;

 private:
  void define_picture(Options& options);
  Result<void> check() const;
  Result<PictureContent> load(Session& session) const;
  Result<DrawnSurface> load_surface(const std::string& path, bool rules_wanted,
                                    Session& session) const;
  Result<Mesh> limit_surface(const DrawnSurface& surface, Session& session) const;
  Result<std::vector<Point>> marks(const PictureContent& scene, Session& session) const;

  std::vector<std::string> paths_;
  Format from_ = Format::automatic;
  Mending mending_;
  RulesOption rules_;
  Nonstationary nonstationary_;
  PictureWishes wishes_;
  std::vector<std::string> styles_;
  std::string output_path_;
  std::vector<std::string> beside_paths_;
  std::string against_path_;
  std::vector<std::string> frame_paths_;
  std::string points_path_;
  Option points_;
  int levels_ = 0;
  Option levels_option_;
};

void Render::define(Options& options) {
  options
      .add("MESH", paths_,
           "The meshes to draw, side by side; points where there are no faces; '-' is the standard "
           "input")
      .required()
      .type_name("...");
  add_from_points(options, from_, "Format of the input that is '-'");
  mending_.define(options);
  options.add("-o,--output", output_path_, "The PNG file; '-' is the standard output")
      .required()
      .type_name("FILE")
      .group("Output");
  rules_.define(options, {.nonstationary = true});
  levels_option_ =
      add_levels(options, levels_,
                 "Draw the limit surface after refinement steps; by default the mesh itself");
  levels_option_.default_text("").group("Surface");
  nonstationary_.define(options);
  define_picture(options);
  options.examples(
      "matte: fronts of faces are warm, backs cool. reflection: a mirror in a hall of parallel\n"
      "lamps, whose lines wiggle where the surface is not fair. wireframe: edges, hidden ones "
      "left\n"
      "out. curvature, gaussian: mean and Gaussian curvature, positive on a ball. error: distance "
      "to\n"
      "--against; without it, how far the limit surface of MESH misses what it should pass "
      "through.\n"
      "At azimuth 0 the camera looks from the front: +z with --up y, -y with --up z, +y with --up "
      "x.\n\n"
      "Examples:\n"
      "  surpass render mesh.obj -o mesh.png --edges --flat\n"
      "  surpass render control.obj -o surface.png --levels 4 --points given.obj\n"
      "  surpass render control.obj -o figure.png --levels 4 --beside given.obj --points\n"
      "  surpass render plain.obj fair.obj -o both.png --levels 4 --style reflection,curvature \\\n"
      "      --columns 2\n"
      "  surpass render given.obj -o missed.png --levels 4 --style error\n"
      "  surpass render scan.xyz -o scan.png\n"
      "  surpass render part.stl -o - --up z --camera 40,25 --size 1920x1080 > part.png\n");
}

void Render::define_picture(Options& options) {
  const auto view = [](Option option) { option.group("Picture"); };
  view(options
           .add("--style", styles_,
                "matte, reflection, wireframe, curvature, gaussian or error; several, with commas "
                "between, make several pictures of each MESH")
           .comma_separated()
           .type_name("STYLE,...")
           .default_text("matte"));
  view(options
           .add("--against", against_path_,
                "With --style error: show the distance to this mesh, relative to the box side of "
                "MESH")
           .type_name("FILE"));
  view(
      options
          .add(
              "--range", wishes_.range,
              "Ends of the colour scale; by default round numbers that hold nearly all values, the "
              "same for all MESHes")
          .type_name("LOW,HIGH"));
  view(options.add("--size", wishes_.size, "Width and height in pixels, of each picture")
           .type_name("WxH")
           .default_text(wishes_.size));
  view(options.add("--columns", wishes_.columns, "Pictures in a row; by default all are in one")
           .in_range(1, 1000)
           .type_name("N")
           .default_text(""));
  view(options
           .add("--camera", wishes_.camera,
                "Degrees around the up axis and above the horizon, and how many times closer than "
                "where all is seen")
           .type_name("AZIMUTH,ELEVATION[,ZOOM]")
           .default_text(wishes_.camera));
  view(options
           .choice_of_words(
               "--up", {"x", "y", "z"}, [this](std::size_t i) { wishes_.up = "xyz"[i]; },
               "The axis that points up")
           .default_text("y"));
  view(options.flag("--edges", wishes_.edges, "Draw the edges of the mesh"));
  view(options.flag("--flat", wishes_.flat, "Flat facets instead of smooth shading"));
  points_ = options
                .add("--points", points_path_,
                     "Draw this mesh's vertices as red balls; without a file those of "
                     "--beside, else MESH's own")
                .value_optional()
                .type_name("[FILE]");
  view(points_);
  view(
      options
          .add("--point-radius", wishes_.point_radius,
               "Of the balls, relative to the largest side of the box; by default by their number, "
               "or for a cloud by its spacing")
          .in_range(0, 1)
          .type_name("R")
          .default_text(""));
  view(options
           .add("--beside", beside_paths_,
                "Draw these meshes, as facets with edges, or points, to the left in the same view")
           .comma_separated()
           .type_name("FILE,..."));
  view(options
           .add("--frame", frame_paths_,
                "Fit these into the view, in the place of what is drawn: pictures with the same "
                "--frame, --size, --camera and --up show it from the same place")
           .comma_separated()
           .type_name("FILE,..."));
}

Result<void> Render::check() const {
  const auto refuse = [](const char* what) {
    return fail(ErrorCode::invalid_argument, std::string(what));
  };
  std::vector<RenderStyle> styles;
  for (const std::string& name : styles_) {
    const auto style = render_style_named(name);
    if (!style) return tl::make_unexpected(style.error());
    styles.push_back(*style);
  }
  const auto scaled = std::count_if(styles.begin(), styles.end(), has_scale);
  if (!against_path_.empty() && std::count(styles.begin(), styles.end(), RenderStyle::error) == 0) {
    return refuse("--against is for --style error");
  }
  if (rules_.nonstationary() && !levels_option_.given()) {
    return refuse("--scheme nonstationary-loop draws a limit surface; name its --levels");
  }
  if (rules_.nonstationary() && against_path_.empty() &&
      std::count(styles.begin(), styles.end(), RenderStyle::error) > 0) {
    return refuse(
        "--style error shows how far a surface is from the one of an interpolating control mesh; "
        "under nonstationary-loop there is none, so name a mesh with --against");
  }
  if (!wishes_.range.empty() && scaled != 1) {
    return refuse("--range is for one of the styles curvature, gaussian and error");
  }
  return {};
}

Result<void> Render::run(Session& session) {
  if (const auto checked = check(); !checked) return checked;
  if (const auto checked = nonstationary_.check(rules_); !checked) return checked;
  std::vector<std::string> inputs = paths_;
  for (const std::string& path : nonstationary_.inputs()) inputs.push_back(path);
  inputs.insert(inputs.end(), beside_paths_.begin(), beside_paths_.end());
  inputs.insert(inputs.end(), frame_paths_.begin(), frame_paths_.end());
  for (const std::string& path : {points_path_, against_path_}) {
    if (!path.empty()) inputs.push_back(path);
  }
  std::vector<std::string> outputs = {output_path_};
  if (session.reporting()) outputs.push_back(session.report_path);
  if (auto checked = check_paths(inputs, outputs, false); !checked) return checked;

  const Result<PictureContent> scene = load(session);
  if (!scene) return tl::make_unexpected(scene.error());
  const Result<std::string> png = draw_picture(*scene, wishes_, session);
  if (!png) return tl::make_unexpected(png.error());
  return write_bytes(output_path_, *png, session);
}

Result<PictureContent> Render::load(Session& session) const {
  PictureContent scene;
  for (const std::string& name : styles_) scene.styles.push_back(*render_style_named(name));
  if (scene.styles.empty()) scene.styles.push_back(RenderStyle::matte);
  const bool misses = against_path_.empty() &&
                      std::count(scene.styles.begin(), scene.styles.end(), RenderStyle::error) > 0;
  for (const std::string& path : paths_) {
    auto surface = load_surface(path, misses, session);
    if (!surface) return tl::make_unexpected(surface.error());
    scene.surfaces.push_back(std::move(*surface));
  }
  for (const std::string& path : beside_paths_) {
    auto loaded = load_shape(path, Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    scene.left.push_back(std::move(loaded->mesh));
  }
  if (!against_path_.empty()) {
    auto loaded = load_mesh(against_path_, Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    scene.against = std::move(loaded->mesh);
  }
  for (const std::string& path : frame_paths_) {
    const auto loaded = load_points(path, Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    const std::vector<Point>& points = loaded->mesh.points;
    scene.frame.insert(scene.frame.end(), points.begin(), points.end());
  }
  auto found = marks(scene, session);
  if (!found) return tl::make_unexpected(found.error());
  scene.marks = std::move(*found);
  return scene;
}

Result<DrawnSurface> Render::load_surface(const std::string& path, bool rules_wanted,
                                          Session& session) const {
  const Format format = path == "-" ? from_ : Format::automatic;
  auto loaded = load_shape(path, format, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  DrawnSurface surface{path, std::move(loaded->mesh), {}, 0, {}};
  if (auto mended = mending_.apply(surface.given, session); !mended) {
    return tl::make_unexpected(mended.error());
  }
  Json input = session.reporting() ? mesh_json(path, surface.given) : Json::object();
  surface.drawn = surface.given;
  if (levels_option_.given() || rules_wanted) {
    surface.rules = rules_.choose(surface.given, session);
    move_rules(session.report, input);
  }
  if (levels_option_.given()) {
    surface.levels = levels_;
    if (auto checked = check_levels(surface.given, levels_); !checked) {
      return tl::make_unexpected(checked.error());
    }
    auto limit = limit_surface(surface, session);
    move_rules(session.report, input);
    if (!limit) return tl::make_unexpected(limit.error());
    surface.drawn = std::move(*limit);
  }
  if (session.reporting()) session.report["inputs"].push_back(std::move(input));
  return surface;
}

Result<Mesh> Render::limit_surface(const DrawnSurface& surface, Session& session) const {
  if (!rules_.nonstationary()) {
    return session.timed("refine", [&] {
      return limit_mesh(surface.given, *surface.rules, levels_, session.context);
    });
  }
  const auto made = nonstationary_.refined(surface.given, rules_, 0, levels_, session);
  if (!made) return tl::make_unexpected(made.error());
  return session.timed("refine", [&] { return made->limit_mesh(session.context); });
}

Result<std::vector<Point>> Render::marks(const PictureContent& scene, Session& session) const {
  if (!points_.given()) return std::vector<Point>{};
  if (points_path_.empty()) {
    return scene.left.empty() ? scene.surfaces.front().given.points : scene.left.back().points;
  }
  const Result<LoadedMesh> loaded = load_points(points_path_, Format::automatic, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  return loaded->mesh.points;
}

}  // namespace

std::unique_ptr<Command> make_render() { return std::make_unique<Render>(); }

}  // namespace surpass::cli

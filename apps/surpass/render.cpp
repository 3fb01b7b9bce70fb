// surpass render MESH -o PNG
//
// The mesh, or with --levels its limit surface; with --beside a given mesh to its left, seen from
// the same place.
#ifdef SURPASS_RENDER
#include <surpass/render.hpp>
#endif

#include <charconv>
#include <tuple>

#include <fmt/format.h>

#include "command.hpp"
#include "levels.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "rules_option.hpp"

namespace surpass::cli {

namespace {

// What the options say, as text where they are two numbers.
struct Wishes {
  std::string size = "1024x768";
  std::string camera = "30,20";
  char up = 'y';
  bool edges = false;
  bool flat = false;
  bool reflection_lines = false;
};

#ifdef SURPASS_RENDER

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [stop, error] = std::from_chars(text.begin(), text.end(), number);
  return error == std::errc() && stop == text.end();
}

// Two numbers with a separator, and nothing else.
template <class Number>
Result<std::pair<Number, Number>> read_pair(const char* option, std::string_view text,
                                            char separator, const char* example) {
  const std::size_t middle = text.find(separator);
  std::pair<Number, Number> pair;
  if (middle == std::string_view::npos || !read_number(text.substr(0, middle), pair.first) ||
      !read_number(text.substr(middle + 1), pair.second)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} takes two numbers like {}, not '{}'", option, example, text));
  }
  return pair;
}

Result<RenderOptions> to_options(const Wishes& wishes) {
  const auto size = read_pair<int>("--size", wishes.size, 'x', "1024x768");
  if (!size) return tl::make_unexpected(size.error());
  const auto camera = read_pair<double>("--camera", wishes.camera, ',', "30,20");
  if (!camera) return tl::make_unexpected(camera.error());
  RenderOptions options;
  std::tie(options.width, options.height) = *size;
  std::tie(options.azimuth, options.elevation) = *camera;
  options.up = wishes.up;
  options.edges = wishes.edges;
  options.smooth = !wishes.flat;
  options.reflection_lines = wishes.reflection_lines;
  return options;
}

// `left`, if there is one, as facets with their edges; `mesh` to its right.
Result<Image> draw(const Mesh& mesh, const Mesh* left, RenderOptions options,
                   const Context& context) {
  if (left == nullptr) return render(mesh, options, context);
  for (const Mesh* shown : {left, &mesh}) {
    options.frame.insert(options.frame.end(), shown->points.begin(), shown->points.end());
  }
  RenderOptions given = options;
  given.smooth = false;
  given.edges = true;
  given.points.clear();
  Result<Image> first = render(*left, given, context);
  if (!first) return first;
  Result<Image> second = render(mesh, options, context);
  if (!second) return second;
  return beside({*first, *second});
}

Result<std::string> picture(const Mesh& mesh, const Mesh* left, const std::vector<Point>& points,
                            const Wishes& wishes, Session& session) {
  Result<RenderOptions> options = to_options(wishes);
  if (!options) return tl::make_unexpected(options.error());
  options->points = points;
  const Result<Image> image =
      session.timed("render", [&] { return draw(mesh, left, *options, session.context); });
  if (!image) return tl::make_unexpected(image.error());
  session.report["picture"] = {{"width", image->width}, {"height", image->height}};
  return encode_png(*image);
}

#else

Result<std::string> picture(const Mesh&, const Mesh*, const std::vector<Point>&, const Wishes&,
                            Session&) {
  return fail(ErrorCode::not_built_in,
              "this build makes no pictures; configure with -DSURPASS_RENDER=ON");
}

#endif

class Render : public Command {
 public:
  void define(Options& options) override;
  Result<void> run(Session& session) override;

 private:
  Result<Mesh> surface(const Mesh& mesh, Session& session) const;
  Result<std::vector<Point>> marked(const Mesh& mesh, const Mesh* left, Session& session) const;

  MeshInput input_;
  RulesOption rules_;
  Wishes wishes_;
  std::string output_path_;
  std::string beside_path_;
  std::string points_path_;
  Option points_;
  int levels_ = 0;
  Option levels_option_;
};

void Render::define(Options& options) {
  input_.define(options, "MESH", "The mesh to draw");
  options.add("-o,--output", output_path_, "The PNG file; '-' is the standard output")
      .required()
      .type_name("FILE")
      .group("Output");
  rules_.define(options);
  levels_option_ =
      add_levels(options, levels_,
                 "Draw the limit surface after refinement steps; by default the mesh itself");
  levels_option_.default_text("").group("Surface");
  const auto view = [](Option option) { option.group("Picture"); };
  view(options.add("--size", wishes_.size, "Width and height in pixels")
           .type_name("WxH")
           .default_text(wishes_.size));
  view(options.add("--camera", wishes_.camera, "Degrees around the up axis and above the horizon")
           .type_name("AZIMUTH,ELEVATION")
           .default_text(wishes_.camera));
  view(options
           .choice_of_words(
               "--up", {"x", "y", "z"}, [this](std::size_t i) { wishes_.up = "xyz"[i]; },
               "The axis that points up")
           .default_text("y"));
  view(options.flag("--edges", wishes_.edges, "Draw the edges of the mesh"));
  view(options.flag("--flat", wishes_.flat, "Flat facets instead of smooth shading"));
  view(options.flag("--reflection-lines", wishes_.reflection_lines,
                    "Shade as a mirror in a hall of parallel lamps: lines wiggle where the "
                    "surface is not fair"));
  points_ = options
                .add("--points", points_path_,
                     "Draw this mesh's vertices as red balls; without a file those of "
                     "--beside, else MESH's own")
                .value_optional()
                .type_name("[FILE]");
  view(points_);
  view(options
           .add("--beside", beside_path_,
                "Draw this mesh, as facets with edges, to the left in the same view")
           .type_name("FILE"));
  options.examples(
      "Fronts of faces are warm, backs cool. At azimuth 0 the camera looks from the front: +z "
      "with\n"
      "--up y, -y with --up z, +y with --up x.\n\n"
      "Examples:\n"
      "  surpass render mesh.obj -o mesh.png --edges --flat\n"
      "  surpass render control.obj -o surface.png --levels 4 --points given.obj\n"
      "  surpass render control.obj -o figure.png --levels 4 --beside given.obj --points\n"
      "  surpass render part.stl -o - --up z --camera 40,25 --size 1920x1080 > part.png\n");
}

Result<void> Render::run(Session& session) {
  std::vector<std::string> inputs = {input_.path()};
  for (const std::string& path : {beside_path_, points_path_}) {
    if (!path.empty()) inputs.push_back(path);
  }
  std::vector<std::string> outputs = {output_path_};
  if (session.reporting()) outputs.push_back(session.report_path);
  if (auto checked = check_paths(inputs, outputs, false); !checked) return checked;

  const Result<LoadedMesh> loaded = input_.load(session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  Result<LoadedMesh> left;
  if (!beside_path_.empty()) {
    left = load_mesh(beside_path_, Format::automatic, session);
    if (!left) return tl::make_unexpected(left.error());
  }
  const Mesh* given = beside_path_.empty() ? nullptr : &left->mesh;
  const auto points = marked(loaded->mesh, given, session);
  if (!points) return tl::make_unexpected(points.error());
  const Result<Mesh> drawn = surface(loaded->mesh, session);
  if (!drawn) return tl::make_unexpected(drawn.error());
  const Result<std::string> png = picture(*drawn, given, *points, wishes_, session);
  if (!png) return tl::make_unexpected(png.error());
  return write_bytes(output_path_, *png, session);
}

Result<Mesh> Render::surface(const Mesh& mesh, Session& session) const {
  if (!levels_option_.given()) return mesh;
  const Rules rules = rules_.choose(mesh, session);
  if (auto checked = check_levels(mesh, levels_); !checked) {
    return tl::make_unexpected(checked.error());
  }
  return session.timed("refine", [&] { return limit_mesh(mesh, rules, levels_, session.context); });
}

Result<std::vector<Point>> Render::marked(const Mesh& mesh, const Mesh* left,
                                          Session& session) const {
  if (!points_.given()) return std::vector<Point>{};
  if (points_path_.empty()) return left != nullptr ? left->points : mesh.points;
  const Result<LoadedMesh> loaded = load_mesh(points_path_, Format::automatic, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  return loaded->mesh.points;
}

}  // namespace

std::unique_ptr<Command> make_render() { return std::make_unique<Render>(); }

}  // namespace surpass::cli

#include "picture.hpp"

#include <surpass/render.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

// Numbers with separators, and nothing else.
Result<std::vector<double>> read_numbers(const char* option, std::string_view text, char separator,
                                         std::size_t least, std::size_t most, const char* example) {
  std::vector<double> numbers;
  bool fine = true;
  for (std::string_view rest = text; fine;) {
    const std::size_t length = std::min(rest.find(separator), rest.size());
    double number = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + length, number);
    fine = error == std::errc() && stop == rest.data() + length;
    numbers.push_back(number);
    if (length == rest.size()) break;
    rest.remove_prefix(length + 1);
  }
  if (fine && numbers.size() >= least && numbers.size() <= most) return numbers;
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} takes {}{} numbers like {}, not '{}'", option, least,
                          most > least ? fmt::format(" or {}", most) : "", example, text));
}

Result<RenderOptions> to_options(const PictureWishes& wishes) {
  const auto size = read_numbers("--size", wishes.size, 'x', 2, 2, "1024x768");
  if (!size) return tl::make_unexpected(size.error());
  const auto camera = read_numbers("--camera", wishes.camera, ',', 2, 3, "30,20");
  if (!camera) return tl::make_unexpected(camera.error());
  RenderOptions options;
  for (const double pixels : *size) {
    if (std::isfinite(pixels) && pixels == std::floor(pixels)) continue;
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("--size takes whole numbers of pixels like 1024x768, not '{}'", wishes.size));
  }
  const auto pixels = [](double x) { return static_cast<int>(std::clamp(x, -1e6, 1e6)); };
  options.width = pixels((*size)[0]);
  options.height = pixels((*size)[1]);
  options.azimuth = (*camera)[0];
  options.elevation = (*camera)[1];
  if (camera->size() == 3) options.zoom = (*camera)[2];
  options.up = wishes.up;
  options.edges = wishes.edges;
  options.smooth = !wishes.flat;
  options.point_radius = wishes.point_radius;
  return options;
}

Shading shading_of(RenderStyle style) {
  switch (style) {
    case RenderStyle::matte: return Shading::matte;
    case RenderStyle::reflection: return Shading::reflection;
    case RenderStyle::wireframe: return Shading::wireframe;
    default: return Shading::field;
  }
}

const char* title_of(RenderStyle style) {
  return style == RenderStyle::curvature  ? "mean curvature"
         : style == RenderStyle::gaussian ? "gaussian curvature"
                                          : "distance / box side";
}

class Drawing {
 public:
  Drawing(const PictureContent& scene, const PictureWishes& wishes, RenderOptions options,
          Session& session)
      : scene_(scene), wishes_(wishes), options_(std::move(options)), session_(session) {
    options_.points = scene.marks;
    options_.frame = scene.frame;
    if (!scene.frame.empty()) return;
    const bool several = !scene.left.empty() || scene.surfaces.size() > 1;
    for (const Mesh& mesh : scene.left) add_to_frame(mesh.points);
    for (const DrawnSurface& s : scene.surfaces) {
      if (several) add_to_frame(s.drawn.points);
    }
  }

  Result<Image> run() {
    if (const auto measured = measure(); !measured) return tl::make_unexpected(measured.error());
    reserve_strip();
    std::vector<Image> panels;
    for (const Mesh& mesh : scene_.left) {
      RenderOptions given = options_;
      given.smooth = false;
      given.edges = true;
      given.points.clear();
      auto image = session_.timed("render", [&] { return render(mesh, given, session_.context); });
      if (!image) return image;
      panels.push_back(std::move(*image));
    }
    for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
      for (std::size_t k = 0; k < scene_.styles.size(); ++k) {
        auto image = draw(i, k);
        if (!image) {
          if (scene_.surfaces.size() > 1) image.error().place.file = scene_.surfaces[i].path;
          return image;
        }
        panels.push_back(std::move(*image));
      }
    }
    const std::size_t columns =
        wishes_.columns > 0 ? static_cast<std::size_t>(wishes_.columns) : panels.size();
    return in_rows(panels, columns);
  }

 private:
  void add_to_frame(const std::vector<Point>& points) {
    options_.frame.insert(options_.frame.end(), points.begin(), points.end());
  }

  // The numbers of every panel that shows some, then a scale for each style.
  Result<void> measure() {
    for (const RenderStyle style : scene_.styles) {
      std::vector<std::vector<double>> numbers;
      for (const DrawnSurface& surface : scene_.surfaces) {
        if (!has_scale(style)) break;
        auto found =
            numbers_of(style, surface, scene_.against ? &*scene_.against : nullptr, session_);
        if (!found) return tl::make_unexpected(found.error());
        numbers.push_back(std::move(*found));
      }
      const auto scale = choose_scale(style, numbers);
      if (!scale) return tl::make_unexpected(scale.error());
      scales_.push_back(*scale);
      numbers_.push_back(std::move(numbers));
    }
    return {};
  }

  Result<Range> choose_scale(RenderStyle style,
                             const std::vector<std::vector<double>>& numbers) const {
    if (!has_scale(style) || wishes_.range.empty()) return scale_for(style, numbers);
    const auto range = read_numbers("--range", wishes_.range, ',', 2, 2, "-5,5");
    if (!range) return tl::make_unexpected(range.error());
    return Range{(*range)[0], (*range)[1]};
  }

  // All panels leave the room that the widest scale takes, so that all show the same equally large.
  void reserve_strip() {
    for (std::size_t k = 0; k < scene_.styles.size(); ++k) {
      options_.strip = std::max(options_.strip, scale_width(styled(k)));
    }
  }

  // Without the numbers of a field.
  [[nodiscard]] RenderOptions styled(std::size_t k) const {
    const RenderStyle style = scene_.styles[k];
    RenderOptions options = options_;
    options.shading = shading_of(style);
    if (has_scale(style)) {
      options.field = {.values = {},
                       .low = scales_[k].low,
                       .high = scales_[k].high,
                       .diverging = style != RenderStyle::error,
                       .title = title_of(style)};
    }
    return options;
  }

  Result<Image> draw(std::size_t surface, std::size_t k) {
    RenderOptions options = styled(k);
    Json panel = {{"mesh", scene_.surfaces[surface].path}, {"style", name_of(scene_.styles[k])}};
    if (options.field) {
      options.field->values = numbers_[k][surface];
      panel["scale"] = {scales_[k].low, scales_[k].high};
    }
    session_.report["picture"]["panels"].push_back(std::move(panel));
    return session_.timed("render", [&] {
      return render(scene_.surfaces[surface].drawn, options, session_.context);
    });
  }

  const PictureContent& scene_;
  const PictureWishes& wishes_;
  RenderOptions options_;
  Session& session_;
  std::vector<std::vector<std::vector<double>>> numbers_;  // by style, then by surface
  std::vector<Range> scales_;
};

}  // namespace

Result<std::string> draw_picture(const PictureContent& scene, const PictureWishes& wishes,
                                 Session& session) {
  Result<RenderOptions> options = to_options(wishes);
  if (!options) return tl::make_unexpected(options.error());
  const Result<Image> image = Drawing(scene, wishes, std::move(*options), session).run();
  if (!image) return tl::make_unexpected(image.error());
  session.report["picture"]["width"] = image->width;
  session.report["picture"]["height"] = image->height;
  return encode_png(*image);
}

}  // namespace surpass::cli

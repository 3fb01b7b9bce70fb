// Checks what is asked for, sets up camera and scene, and paints.
#include <surpass/render.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "parallel/parallel.hpp"
#include "render/backdrop.hpp"
#include "render/cloud.hpp"
#include "render/legend.hpp"
#include "render/painter.hpp"

namespace surpass {
namespace {

using picture::Ball;
using picture::Camera;
using picture::Cloud;
using picture::DisplayMesh;
using picture::Painter;
using picture::Scene;
using picture::to_vector;
using picture::Vec3;

constexpr int kLargestSize = 16384;
constexpr int kMostSamples = 1024;

Result<void> check_options(const RenderOptions& options) {
  const auto refuse = [](std::string message) {
    return fail(ErrorCode::invalid_argument, std::move(message));
  };
  if (std::min(options.width, options.height) < 1 ||
      std::max(options.width, options.height) > kLargestSize) {
    return refuse(fmt::format("a picture can be 1 to {} pixels wide and high, not {} x {}",
                              kLargestSize, options.width, options.height));
  }
  if (options.samples < 1 || options.samples > kMostSamples) {
    return refuse(
        fmt::format("a pixel can have 1 to {} samples, not {}", kMostSamples, options.samples));
  }
  if (!std::isfinite(options.azimuth) || !std::isfinite(options.elevation)) {
    return refuse("the camera's azimuth and elevation must be finite angles in degrees");
  }
  if (!(options.zoom >= 0.01 && options.zoom <= 1000)) {
    return refuse(fmt::format("the camera's zoom can be 0.01 to 1000, not {}", options.zoom));
  }
  if (options.up != 'x' && options.up != 'y' && options.up != 'z') {
    return refuse(fmt::format("the up axis is x, y or z, not '{}'", options.up));
  }
  if (options.strip < 0 || options.strip >= options.width) {
    return refuse(
        fmt::format("a strip of {} pixels leaves no picture of {}", options.strip, options.width));
  }
  if (!std::isfinite(options.crease_angle)) return refuse("the crease angle must be finite");
  if (!(options.point_radius >= 0) || !std::isfinite(options.point_radius)) {
    return refuse("the radius of points must be a finite number, at least 0");
  }
  const auto finite = [](const Point& p) { return to_vector(p).allFinite(); };
  if (!std::all_of(options.points.begin(), options.points.end(), finite) ||
      !std::all_of(options.frame.begin(), options.frame.end(), finite)) {
    return refuse("points to draw or to fit into the picture must have finite coordinates");
  }
  return {};
}

// So that balls of many points stay apart and those of a few do not cover the surface.
double ball_radius(const RenderOptions& options) {
  if (options.point_radius > 0 || options.points.empty()) return options.point_radius;
  return std::clamp(0.18 / std::sqrt(static_cast<double>(options.points.size())), 0.003, 0.014);
}

Result<void> check_field(const Mesh& mesh, const RenderOptions& options) {
  if (options.shading != Shading::field) return {};
  if (!options.field || options.field->values.size() != mesh.points.size()) {
    return fail(ErrorCode::mismatch,
                fmt::format("a picture of a field needs a number for each of the {} vertices, but "
                            "there are {}",
                            mesh.points.size(), options.field ? options.field->values.size() : 0));
  }
  const double width = options.field->high - options.field->low;
  if (width > 0 && std::isfinite(width)) return {};
  return fail(ErrorCode::invalid_argument, "a field's scale must go from a number to a larger one");
}

// A frame that is given shall not depend on how many points there are: balls of a radius that is
// chosen here fit into the free border.
Camera aim(const Mesh& mesh, const DisplayMesh& display, const RenderOptions& options) {
  if (!options.frame.empty()) return Camera(options.frame, options.point_radius, options);
  std::vector<Point> fitted = picture::drawn_points(mesh, display);
  fitted.insert(fitted.end(), options.points.begin(), options.points.end());
  return Camera(fitted, ball_radius(options), options);
}

std::vector<Vec3> to_unit(const std::vector<Point>& points, const Camera& camera) {
  std::vector<Vec3> unit;
  unit.reserve(points.size());
  for (const Point& p : points) unit.push_back(camera.to_unit(p));
  return unit;
}

// Points of a mesh without faces, then the marks.
std::vector<Ball> balls_of(std::span<const Vec3> points, const Cloud& cloud,
                           const RenderOptions& options, const Camera& camera) {
  constexpr float kFilled = 0.42F;  // of the spacing: points that nearly touch hide what is behind
  constexpr float kLeastPixels = 0.75F;  // no ball falls between the centres of pixels
  constexpr float kLargest = 0.02F;      // of the box side, where points are few
  std::vector<Ball> balls;
  if (!cloud.normals.empty()) {
    const float given = static_cast<float>(options.point_radius) * camera.unit_side();
    const float least = kLeastPixels * camera.pixel_size(Vec3::Zero());
    const float apart = cloud.spacing > 0 ? kFilled * cloud.spacing : camera.unit_side();
    const float chosen = std::min(apart, kLargest * camera.unit_side());
    const float radius = given > 0 ? given : std::max(chosen, least);
    for (const Vec3& p : points) balls.push_back({p, radius});
  }
  const float radius = static_cast<float>(ball_radius(options)) * camera.unit_side();
  for (const Point& p : options.points) balls.push_back({camera.to_unit(p), radius});
  return balls;
}

// The strip of the scale is not part of what the camera fits the mesh into.
RenderOptions without_strip(RenderOptions options, int strip) {
  options.width -= strip;
  return options;
}

bool has_scale(const RenderOptions& options) {
  return options.shading == Shading::field && picture::legend_width(options) > 0;
}

}  // namespace

int scale_width(const RenderOptions& options) {
  return has_scale(options) ? picture::legend_width(options) : 0;
}

Result<Image> render(const Mesh& mesh, const RenderOptions& options, const Context& context) {
  if (auto checked = check_options(options); !checked) return tl::make_unexpected(checked.error());
  if (auto checked = check_field(mesh, options); !checked) {
    return tl::make_unexpected(checked.error());
  }
  const int strip = std::max(options.strip, scale_width(options));
  const RenderOptions fitted = without_strip(options, strip);
  const auto display = picture::make_display_mesh(mesh, fitted, context);
  if (!display) return tl::make_unexpected(display.error());
  const Camera camera = aim(mesh, *display, fitted);
  const std::vector<Vec3> points = to_unit(mesh.points, camera);
  Cloud cloud;
  if (display->triangles.empty()) cloud = picture::look_at_cloud(points, context);
  const std::vector<Ball> balls = balls_of(points, cloud, fitted, camera);
  // While it runs, Embree limits TBB to the processor's threads; to ask for more would make TBB
  // complain on stderr.
  Context limited = context;
  limited.threads = std::min(parallel::thread_count(context), parallel::thread_count({}));
  const auto scene = Scene::build(points, display->triangles, balls, limited.threads);
  if (!scene) return tl::make_unexpected(scene.error());

  const Painter painter(*display, points, *scene, cloud.normals, camera, fitted);
  Image image{fitted.width, fitted.height, {}};
  image.pixels.resize(std::size_t{3} * static_cast<std::size_t>(fitted.width) *
                      static_cast<std::size_t>(fitted.height));
  if (!painter.paint(image, limited)) {
    return fail(ErrorCode::cancelled, "the picture was cancelled");
  }
  if (strip == 0) return image;
  return beside({image, has_scale(options)
                            ? picture::draw_legend(*options.field, strip, options.height)
                            : picture::blank(strip, options.height)});
}

}  // namespace surpass

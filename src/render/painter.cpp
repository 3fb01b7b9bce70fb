#include "render/painter.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.hpp"
#include "render/backdrop.hpp"
#include "render/colour_map.hpp"

namespace surpass::picture {
namespace {

constexpr int kBandRows = 128;  // bounds the memory
constexpr std::size_t kRowsAChunk = 4;
constexpr float kReach = 0.6F;       // of occlusion, in box sides
constexpr float kThickness = 0.02F;  // of a piece of the surface, in box sides

// Neighbouring pixels see the same piece of the surface if normals, planes and paint agree.
constexpr float kAlikeCosine = 0.995F;
constexpr float kAlikePixels = 2;
constexpr float kAlikePaint = 0.03F;

const Colour kLine = {0.035F, 0.037F, 0.042F};
constexpr float kLineStrength = 0.75F;
constexpr float kInkStrength = 0.95F;  // on paper

template <class Body>
void for_each_row(const Context& context, int first, int last, const Body& body) {
  parallel::for_ranges(
      context, static_cast<std::size_t>(last - first),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end && !context.cancelled(); ++row) {
          body(first + static_cast<int>(row));
        }
      },
      kRowsAChunk);
}

template <class Body>
void for_each_pixel(const Context& context, int width, int first, int last, const Body& body) {
  for_each_row(context, first, last, [&](int y) {
    for (int x = 0; x < width; ++x) body(x, y);
  });
}

Style style_of(const RenderOptions& options) {
  switch (options.shading) {
    case Shading::matte: return matte;
    case Shading::reflection: return reflection;
    case Shading::wireframe: return paper;
    case Shading::field: return painted;
  }
  return matte;
}

Vec2 centre(int x, int y) { return {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}; }

}  // namespace

Painter::Painter(const DisplayMesh& display, std::span<const Vec3> points, const Scene& scene,
                 std::span<const Vec3> cloud_normals, const Camera& camera,
                 const RenderOptions& options)
    : display_(display),
      scene_(scene),
      cloud_normals_(cloud_normals),
      camera_(camera),
      width_(options.width),
      height_(options.height),
      side_(static_cast<int>(std::ceil(std::sqrt(options.samples)))),
      fine_(options.shading == Shading::reflection),
      field_(options.shading == Shading::field ? &*options.field : nullptr),
      line_strength_(options.shading == Shading::wireframe ? kInkStrength : kLineStrength),
      style_(style_of(options)),
      sky_(scene, side_ * side_, kReach * camera.unit_side()) {
  if (options.edges || options.shading == Shading::wireframe) lines_.emplace(points, camera);
}

bool Painter::paint(Image& image, const Context& context) const {
  Band band(width_);
  for (int y = 0; y < height_; y += kBandRows) {
    const int end = std::min(height_, y + kBandRows);
    paint_rows(y, end, band, image, context);
    if (context.cancelled()) return false;
    context.report({.stage = "render", .fraction = static_cast<double>(end) / height_});
  }
  return true;
}

void Painter::paint_rows(int begin, int end, Band& band, Image& image,
                         const Context& context) const {
  const auto rows = [&](int around) {
    return std::pair(std::max(0, begin - around), std::min(height_, end + around));
  };
  const auto [seen_first, seen_last] = rows(kOpennessRadius + 1);
  auto& seen = band.seen;
  seen.cover(seen_first, seen_last);
  for_each_row(context, seen_first, seen_last, [&](int y) {
    std::vector<Vec2> places;
    places.reserve(static_cast<std::size_t>(width_));
    for (int x = 0; x < width_; ++x) places.push_back(centre(x, y));
    look(places, seen.row(y));
  });

  const auto [lit_first, lit_last] = rows(kOpennessRadius);
  auto& lit = band.lit;
  lit.cover(lit_first, lit_last);
  for_each_pixel(context, width_, lit_first, lit_last, [&](int x, int y) {
    lit.at(x, y) = side_ == 1 || (!fine_ && is_plain(seen, x, y)) ? plain_pixel(seen.at(x, y), x, y)
                                                                  : sample_pixel(x, y);
  });

  for_each_pixel(context, width_, begin, end, [&](int x, int y) {
    const Colour colour = develop(lit, x, y);
    std::uint8_t* bytes =
        &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x))];
    for (int k = 0; k < 3; ++k) bytes[k] = to_srgb_(colour[k]);
  });
}

void Painter::look(std::span<const Vec2> places, Sights sights) const {
  std::vector<Vec3> rays;
  rays.reserve(places.size());
  for (const Vec2& place : places) rays.push_back(camera_.ray(place.x(), place.y()));
  std::vector<std::optional<Hit>> hits(places.size());
  scene_.first_hits(camera_.eye(), rays, hits);
  for (std::size_t i = 0; i < places.size(); ++i) {
    sights[i] = hits[i] ? std::optional(describe(*hits[i], rays[i])) : std::nullopt;
  }
}

Painter::Sight Painter::describe(const Hit& hit, const Vec3& ray) const {
  Sight sight{{}, hit.triangle};
  SurfacePlace& seen = sight.place;
  seen.position = hit.position;
  seen.to_eye = -ray.normalized();
  const bool cloud = hit.triangle == kNone && hit.ball < cloud_normals_.size();
  seen.ball = hit.triangle == kNone && !cloud;
  const float side = hit.normal.dot(ray) > 0 ? -1.0F : 1.0F;
  seen.back = hit.triangle != kNone && side < 0;
  seen.facet = side * hit.normal;
  Vec3 normal = side * shading_normal(hit);
  if (cloud && normal.dot(ray) > 0) normal = -normal;  // points do not tell their side
  // Near the outline an averaged normal can point away although its facet is seen.
  const float away = std::min(0.0F, normal.dot(seen.to_eye));
  seen.normal = (normal - away * seen.to_eye).normalized();
  if (field_ != nullptr && hit.triangle != kNone) seen.paint = colour_of(value_at(hit), *field_);
  return sight;
}

double Painter::value_at(const Hit& hit) const {
  const auto& vertices = display_.triangles[hit.triangle].vertices;
  double value = 0;
  for (int k = 0; k < 3; ++k) {
    value +=
        static_cast<double>(hit.weights[k]) * field_->values[vertices[static_cast<std::size_t>(k)]];
  }
  return value;
}

Vec3 Painter::shading_normal(const Hit& hit) const {
  if (hit.triangle == kNone) {
    const bool tilted = hit.ball < cloud_normals_.size() && !cloud_normals_[hit.ball].isZero();
    return tilted ? cloud_normals_[hit.ball] : hit.normal;
  }
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto& corners = display_.triangles[hit.triangle].corners;
    sum += hit.weights[k] * display_.corner_normals[corners[static_cast<std::size_t>(k)]];
  }
  return sum.squaredNorm() > 1e-6F ? sum.normalized() : hit.normal;
}

// Whether the pixel and its neighbours see the same piece of the surface, or nothing.
bool Painter::is_plain(const Raster<std::optional<Sight>>& first, int x, int y) const {
  const std::optional<Sight>& here = first.at(x, y);
  bool plain = true;
  first.for_each_near(x, y, 1, [&](const std::optional<Sight>& other, int, int) {
    if (here.has_value() != other.has_value()) {
      plain = false;
    } else if (here) {
      const SurfacePlace& a = here->place;
      const SurfacePlace& b = other->place;
      const float lift = std::abs(a.facet.dot(b.position - a.position));
      plain = plain && a.ball == b.ball && a.back == b.back &&
              a.normal.dot(b.normal) > kAlikeCosine &&
              (a.paint - b.paint).abs().maxCoeff() < kAlikePaint &&
              lift < kAlikePixels * camera_.pixel_size(a.position);
    }
  });
  return plain;
}

Pixel Painter::plain_pixel(const std::optional<Sight>& sight, int x, int y) const {
  Pixel pixel;
  if (!sight) return pixel;
  pixel.light = shade(*sight, centre(x, y), 1);
  pixel.position = sight->place.position;
  pixel.normal = sight->place.normal;
  pixel.covered = 1;
  if (SkyProbe::measures(x, y)) pixel.openness = sky_.openness({&sight->place, 1}, x, y);
  return pixel;
}

Pixel Painter::sample_pixel(int x, int y) const {
  const std::vector<Vec2> places = sample_places(x, y);
  std::vector<std::optional<Sight>> sights(places.size());
  look(places, sights);
  Pixel pixel;
  std::vector<SurfacePlace> met;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!sights[i]) continue;
    const Light light = shade(*sights[i], places[i], 1 / static_cast<float>(side_));
    pixel.light.direct += light.direct;
    pixel.light.sky += light.sky;
    pixel.position += sights[i]->place.position;
    pixel.normal += sights[i]->place.normal;
    met.push_back(sights[i]->place);
  }
  if (met.empty()) return pixel;
  const auto count = static_cast<float>(met.size());
  pixel.light.direct /= count;
  pixel.light.sky /= count;
  pixel.position /= count;
  pixel.normal /= count;
  pixel.covered = count / static_cast<float>(places.size());
  pixel.openness = sky_.openness(met, x, y);
  return pixel;
}

// The samples' places are even in x, in y and in the plane (Kensler, Correlated multi-jittered
// sampling, 2013), so that nearly level edges get as many shades as others.
std::vector<Vec2> Painter::sample_places(int x, int y) const {
  std::vector<Vec2> places;
  const auto n = static_cast<float>(side_);
  for (int j = 0; j < side_; ++j) {
    for (int i = 0; i < side_; ++i) {
      const Vec2 cell(static_cast<float>(i), static_cast<float>(j));
      const Vec2 within((cell.y() + 0.5F) / n, (cell.x() + 0.5F) / n);
      places.emplace_back(Vec2(static_cast<float>(x), static_cast<float>(y)) + (cell + within) / n);
    }
  }
  return places;
}

Light Painter::shade(const Sight& sight, const Vec2& place, float spacing) const {
  Light light = style_(sight.place, camera_);
  if (lines_ && sight.triangle != kNone) {
    const Triangle& triangle = display_.triangles[sight.triangle];
    const float line = line_strength_ * lines_->coverage(triangle, place, spacing);
    light.direct += line * (kLine - light.direct);
    light.sky *= 1 - line;
  }
  return light;
}

// The colour of a pixel from the light that it saw, over the background.
Colour Painter::develop(const Raster<Pixel>& band, int x, int y) const {
  const Colour background = backdrop(y, height_);
  const Pixel& pixel = band.at(x, y);
  if (pixel.covered == 0) return background;
  const float open = smoothed_openness(band, x, y, kThickness * camera_.unit_side());
  const Colour surface = pixel.light.direct + pixel.light.sky * open;
  return surface * pixel.covered + background * (1 - pixel.covered);
}

}  // namespace surpass::picture

#include "render/painter.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.hpp"

namespace surpass::picture {
namespace {

constexpr std::size_t kRowsAChunk = 4;
constexpr float kReach = 0.6F;       // of occlusion, in box sides
constexpr float kThickness = 0.02F;  // of a piece of the surface, in box sides

// Neighbouring pixels see the same piece of the surface if normals and planes agree.
constexpr float kAlikeCosine = 0.995F;
constexpr float kAlikePixels = 2;

const Colour kTop = {0.955F, 0.955F, 0.945F};
const Colour kBottom = {0.700F, 0.712F, 0.722F};
const Colour kLine = {0.035F, 0.037F, 0.042F};
constexpr float kLineStrength = 0.75F;

template <class Body>
void for_each_pixel(const Context& context, int width, int first, int last, const Body& body) {
  parallel::for_ranges(
      context, static_cast<std::size_t>(last - first),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end && !context.cancelled(); ++row) {
          for (int x = 0; x < width; ++x) body(x, first + static_cast<int>(row));
        }
      },
      kRowsAChunk);
}

Vec2 centre(int x, int y) { return {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}; }

}  // namespace

Painter::Painter(const DisplayMesh& display, std::span<const Vec3> points, const Scene& scene,
                 const Camera& camera, const RenderOptions& options)
    : display_(display),
      scene_(scene),
      camera_(camera),
      width_(options.width),
      height_(options.height),
      side_(static_cast<int>(std::ceil(std::sqrt(options.samples)))),
      style_(matte),
      sky_(scene, side_ * side_, kReach * camera.unit_side()) {
  if (options.edges) lines_.emplace(points, camera);
}

void Painter::paint(int begin, int end, Image& image, const Context& context) const {
  const auto rows = [&](int around) {
    return std::pair(std::max(0, begin - around), std::min(height_, end + around));
  };
  const auto [seen_first, seen_last] = rows(kOpennessRadius + 1);
  Raster<std::optional<Sight>> seen(width_, seen_first, seen_last);
  for_each_pixel(context, width_, seen_first, seen_last,
                 [&](int x, int y) { seen.at(x, y) = look(centre(x, y)); });

  const auto [lit_first, lit_last] = rows(kOpennessRadius);
  Raster<Pixel> lit(width_, lit_first, lit_last);
  for_each_pixel(context, width_, lit_first, lit_last, [&](int x, int y) {
    lit.at(x, y) =
        side_ == 1 || is_plain(seen, x, y) ? plain_pixel(seen.at(x, y), x, y) : sample_pixel(x, y);
  });

  for_each_pixel(context, width_, begin, end, [&](int x, int y) {
    const Colour colour = develop(lit, x, y);
    std::uint8_t* bytes =
        &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x))];
    for (int k = 0; k < 3; ++k) bytes[k] = to_srgb_(colour[k]);
  });
}

std::optional<Painter::Sight> Painter::look(const Vec2& place) const {
  const Vec3 ray = camera_.ray(place.x(), place.y());
  const std::optional<Hit> hit = scene_.first_hit(camera_.eye(), ray);
  if (!hit) return std::nullopt;
  Sight sight{{}, hit->triangle};
  SurfacePlace& seen = sight.place;
  seen.position = hit->position;
  seen.to_eye = -ray.normalized();
  seen.ball = hit->triangle == kNone;
  const float side = hit->normal.dot(ray) > 0 ? -1.0F : 1.0F;
  seen.back = !seen.ball && side < 0;
  seen.facet = side * hit->normal;
  const Vec3 normal = side * shading_normal(*hit);
  // Near the outline an averaged normal can point away although its facet is seen.
  const float away = std::min(0.0F, normal.dot(seen.to_eye));
  seen.normal = (normal - away * seen.to_eye).normalized();
  return sight;
}

Vec3 Painter::shading_normal(const Hit& hit) const {
  if (hit.triangle == kNone) return hit.normal;
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
              lift < kAlikePixels * camera_.pixel_size(a.position);
    }
  });
  return plain;
}

Pixel Painter::plain_pixel(const std::optional<Sight>& sight, int x, int y) const {
  Pixel pixel;
  pixel.samples = 1;
  if (sight) add(pixel, *sight, centre(x, y), 1, sky_.openness(sight->place, x, y));
  return pixel;
}

// The samples' places are even in x, in y and in the plane (Kensler, Correlated multi-jittered
// sampling, 2013), so that nearly level edges get as many shades as others.
Pixel Painter::sample_pixel(int x, int y) const {
  Pixel pixel;
  const auto n = static_cast<float>(side_);
  pixel.samples = n * n;
  for (int j = 0; j < side_; ++j) {
    for (int i = 0; i < side_; ++i) {
      const Vec2 cell(static_cast<float>(i), static_cast<float>(j));
      const Vec2 within((cell.y() + 0.5F) / n, (cell.x() + 0.5F) / n);
      const Vec2 place = Vec2(static_cast<float>(x), static_cast<float>(y)) + (cell + within) / n;
      const std::optional<Sight> sight = look(place);
      if (!sight) continue;
      add(pixel, *sight, place, 1 / n, sky_.openness(sight->place, x, y, i + side_ * j));
    }
  }
  return pixel;
}

void Painter::add(Pixel& pixel, const Sight& sight, const Vec2& place, float spacing,
                  float open) const {
  Light light = style_(sight.place, camera_);
  if (lines_ && sight.triangle != kNone) {
    const Triangle& triangle = display_.triangles[sight.triangle];
    const float line = kLineStrength * lines_->coverage(triangle, place, spacing);
    light.direct += line * (kLine - light.direct);
    light.sky *= 1 - line;
  }
  pixel.light.direct += light.direct;
  pixel.light.sky += light.sky;
  pixel.position += sight.place.position;
  pixel.normal += sight.place.normal;
  pixel.openness += open;
  pixel.covered += 1;
}

// The colour of a pixel from the light that it saw, over the background.
Colour Painter::develop(const Raster<Pixel>& band, int x, int y) const {
  const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(height_);
  Colour background = kTop + (kBottom - kTop) * down;
  const Pixel& pixel = band.at(x, y);
  if (pixel.covered == 0) return background;
  const float open = smoothed_openness(band, x, y, kThickness * camera_.unit_side());
  return (pixel.light.direct + pixel.light.sky * open +
          background * (pixel.samples - pixel.covered)) /
         pixel.samples;
}

}  // namespace surpass::picture

// Interleaved patterns: Keller and Heidrich, Interleaved sampling, 2001. The sequence: Roberts,
// The unreasonable effectiveness of quasirandom sequences, 2018.
#include "render/ambient.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surpass::picture {
namespace {

constexpr int kPattern = 4;            // pixels
constexpr std::size_t kLeastRays = 8;  // a pixel
constexpr float kOffset = 1e-4F;       // off the surface, in the unit frame

// Steps of the three-dimensional sequence: powers of the inverse of the root of x^4 = x + 1.
constexpr std::array<double, 3> kSteps = {0.8191725133961645, 0.6710436067037893,
                                          0.5497004779019703};

double sequence(std::size_t i, std::size_t k) {
  const double x = 0.5 + static_cast<double>(i) * kSteps[k];
  return x - std::floor(x);
}

// Two unit vectors that are perpendicular to n and to each other.
std::pair<Vec3, Vec3> tangents(const Vec3& n) {
  const Vec3 helper = std::abs(n.y()) < 0.8F ? Vec3::UnitY() : Vec3::UnitX();
  const Vec3 u = helper.cross(n).normalized();
  return {u, n.cross(u)};
}

}  // namespace

SkyProbe::SkyProbe(const Scene& scene, int samples, float reach)
    : scene_(scene), rays_a_pixel_(std::max(kLeastRays, static_cast<std::size_t>(samples))) {
  const std::size_t count = std::size_t{kPattern} * kPattern * rays_a_pixel_;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = std::sqrt(sequence(i, 0));  // cosine-weighted
    const double angle = 2 * std::numbers::pi * sequence(i, 1);
    const Eigen::Vector3d direction(radius * std::cos(angle), radius * std::sin(angle),
                                    std::sqrt(1 - radius * radius));
    // Rays of all lengths: what is farther away darkens less.
    rays_.push_back({direction.cast<float>(), reach * static_cast<float>(sequence(i, 2))});
  }
}

float SkyProbe::openness(std::span<const SurfacePlace> places, int x, int y) const {
  const std::size_t rays_a_place = std::max(std::size_t{1}, kLeastRays / places.size());
  std::span<const Ray> rays = std::span(rays_).subspan(first_ray(x, y), rays_a_pixel_);
  std::vector<Probe> probes;
  probes.reserve(rays_a_pixel_);
  for (const SurfacePlace& place : places) {
    aim(rays.first(rays_a_place), place, probes);
    rays = rays.subspan(rays_a_place);
  }
  return 1 - static_cast<float>(scene_.count_blocked(probes)) /
                 static_cast<float>(rays_a_place * places.size());
}

// Pixels that measure whatever their neighbours are share the first half of the sequence, which is
// even by itself.
std::size_t SkyProbe::first_ray(int x, int y) const {
  const int half = kPattern / 2;
  const int column = (x % kPattern) / 2 + half * (y % kPattern);
  const int phase = column + (measures(x, y) ? 0 : half * kPattern);
  return static_cast<std::size_t>(phase) * rays_a_pixel_;
}

void SkyProbe::aim(std::span<const Ray> rays, const SurfacePlace& place,
                   std::vector<Probe>& probes) {
  const auto [u, v] = tangents(place.normal);
  const Vec3 origin = place.position + kOffset * place.facet;
  for (const Ray& ray : rays) {
    const Vec3& d = ray.direction;
    const Vec3 direction = d.x() * u + d.y() * v + d.z() * place.normal;
    // Below the facet is the surface that the smooth normal stands for: it does not block.
    if (direction.dot(place.facet) > 0) probes.push_back({origin, direction, ray.length});
  }
}

float smoothed_openness(const Raster<Pixel>& band, int x, int y, float thickness) {
  const Pixel& here = band.at(x, y);
  const Vec3 normal = here.normal.normalized();
  const Vec3 lifting = normal / thickness;
  float sum = 0;
  float total = 0;
  band.for_each_near(x, y, kOpennessRadius, [&](const Pixel& other, int dx, int dy) {
    if (!other.openness) return;
    // With half weights at its ends, a row of five pixels holds each column of the pattern once.
    const float share = (std::abs(dx) == 2 ? 0.5F : 1.0F) * (std::abs(dy) == 2 ? 0.5F : 1.0F);
    const float alike = std::max(0.0F, normal.dot(other.normal));
    const float lift = lifting.dot(other.position - here.position);
    const float weight = share * other.covered * alike * alike / (1 + lift * lift * lift * lift);
    sum += weight * *other.openness;
    total += weight;
  });
  return total > 0 ? sum / total : here.openness.value_or(1);
}

}  // namespace surpass::picture

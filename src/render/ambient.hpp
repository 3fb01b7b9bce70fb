// Ambient occlusion: corners and folds see less of the sky. A few rays for every second pixel, in a
// pattern that repeats every 4 x 4 pixels, then a mean over such a block that does not cross edges.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/raster.hpp"
#include "render/scene.hpp"
#include "render/style.hpp"

namespace surpass::picture {

/// What the samples of a pixel saw: the mean over those that met something.
struct Pixel {
  Light light;
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  float covered = 0;              ///< share of the samples that met something
  std::optional<float> openness;  ///< where it was measured
};

/// Rays into the sky.
class SkyProbe {
 public:
  /// `reach` is the length beyond which nothing blocks.
  SkyProbe(const Scene& scene, int samples, float reach);

  /// Part of the sky that is seen from the places that the samples in pixel (x, y) met, 0 to 1.
  [[nodiscard]] float openness(std::span<const SurfacePlace> places, int x, int y) const;
  /// Whether a pixel with neighbours like itself needs rays of its own.
  [[nodiscard]] static bool measures(int x, int y) { return (x + y) % 2 == 0; }

 private:
  struct Ray {
    Vec3 direction;  // around the z axis
    float length;
  };
  [[nodiscard]] std::size_t first_ray(int x, int y) const;
  static void aim(std::span<const Ray> rays, const SurfacePlace& place, std::vector<Probe>& probes);

  const Scene& scene_;
  std::size_t rays_a_pixel_;
  std::vector<Ray> rays_;
};

/// The mean openness around a covered pixel, over pixels of the same piece of the surface.
/// `thickness` is how far from the tangent plane that may lie.
[[nodiscard]] float smoothed_openness(const Raster<Pixel>& band, int x, int y, float thickness);

/// Pixels around one that smoothed_openness looks at.
inline constexpr int kOpennessRadius = 2;

}  // namespace surpass::picture

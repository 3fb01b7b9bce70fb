// Ambient occlusion: corners and folds see less of the sky. A few rays a pixel, in a pattern that
// repeats every 4 x 4 pixels, then a mean over such a block that does not cross edges.
#pragma once

#include <vector>

#include "render/raster.hpp"
#include "render/scene.hpp"
#include "render/style.hpp"

namespace surpass::picture {

/// What the samples of a pixel saw, added up over those that met something.
struct Pixel {
  Light light;
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  float openness = 0;
  float covered = 0;  ///< number of samples that met something
  float samples = 0;
};

/// Rays into the sky.
class SkyProbe {
 public:
  /// `reach` is the length beyond which nothing blocks.
  SkyProbe(const Scene& scene, int samples, float reach);

  /// Part of the sky that is seen from a place in pixel (x, y), 0 to 1: by the rays of one of the
  /// pixel's samples, or by those of a pixel that has a single one.
  [[nodiscard]] float openness(const SurfacePlace& place, int x, int y, int sample) const;
  [[nodiscard]] float openness(const SurfacePlace& place, int x, int y) const;

 private:
  struct Ray {
    Vec3 direction;  // around the z axis
    float length;
  };
  [[nodiscard]] std::size_t first_ray(int x, int y) const;
  [[nodiscard]] float open_share(const SurfacePlace& place, std::size_t first,
                                 std::size_t count) const;

  const Scene& scene_;
  std::size_t rays_a_sample_;
  std::size_t rays_a_pixel_;
  std::vector<Ray> rays_;
};

/// The mean openness around a covered pixel, over pixels of the same piece of the surface.
/// `thickness` is how far from the tangent plane that may lie.
[[nodiscard]] float smoothed_openness(const Raster<Pixel>& band, int x, int y, float thickness);

/// Pixels around one that smoothed_openness looks at.
inline constexpr int kOpennessRadius = 2;

}  // namespace surpass::picture

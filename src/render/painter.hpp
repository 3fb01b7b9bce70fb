// From rays to the pixels of a picture: one ray a pixel, then more where neighbours differ, at
// outlines and sharp edges.
#pragma once

#include <surpass/render.hpp>

#include <optional>

#include "render/ambient.hpp"
#include "render/edges.hpp"
#include "render/srgb.hpp"

namespace surpass::picture {

class Painter {
 public:
  /// Keeps references to the scene's parts. `points` are the mesh's in the unit frame.
  Painter(const DisplayMesh& display, std::span<const Vec3> points, const Scene& scene,
          const Camera& camera, const RenderOptions& options);

  /// Rows [begin, end) of the picture into `image`, which has its full size. What they need of the
  /// rows around is computed again for every call, so that bands bound the memory.
  void paint(int begin, int end, Image& image, const Context& context) const;

 private:
  struct Sight {
    SurfacePlace place;
    Index triangle;  // or kNone for a ball
  };

  [[nodiscard]] std::optional<Sight> look(const Vec2& place) const;
  [[nodiscard]] Vec3 shading_normal(const Hit& hit) const;
  [[nodiscard]] bool is_plain(const Raster<std::optional<Sight>>& first, int x, int y) const;
  [[nodiscard]] Pixel sample_pixel(int x, int y) const;
  [[nodiscard]] Pixel plain_pixel(const std::optional<Sight>& sight, int x, int y) const;
  void add(Pixel& pixel, const Sight& sight, const Vec2& place, float spacing, float open) const;
  [[nodiscard]] Colour develop(const Raster<Pixel>& band, int x, int y) const;

  const DisplayMesh& display_;
  const Scene& scene_;
  const Camera& camera_;
  int width_;
  int height_;
  int side_;  // of the square of samples in a pixel
  Style style_;
  SkyProbe sky_;
  std::optional<EdgeLines> lines_;
  SrgbTable to_srgb_;
};

}  // namespace surpass::picture

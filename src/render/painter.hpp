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
  /// Keeps references to the scene's parts. `points` are the mesh's in the unit frame. The scene's
  /// first balls are points of a cloud with these normals, the others marks.
  Painter(const DisplayMesh& display, std::span<const Vec3> points, const Scene& scene,
          std::span<const Vec3> cloud_normals, const Camera& camera, const RenderOptions& options);

  /// The picture into `image`, which has its size; false if it was cancelled.
  [[nodiscard]] bool paint(Image& image, const Context& context) const;

 private:
  struct Sight {
    SurfacePlace place;
    Index triangle;  // or kNone for a ball
  };

  // A band of rows, and what it needs of the rows around, which is computed again for every band.
  struct Band {
    explicit Band(int width) : seen(width), lit(width) {}
    Raster<std::optional<Sight>> seen;
    Raster<Pixel> lit;
  };
  using Sights = std::span<std::optional<Sight>>;

  void paint_rows(int begin, int end, Band& band, Image& image, const Context& context) const;
  void look(std::span<const Vec2> places, Sights sights) const;
  [[nodiscard]] Sight describe(const Hit& hit, const Vec3& ray) const;
  [[nodiscard]] Vec3 shading_normal(const Hit& hit) const;
  [[nodiscard]] double value_at(const Hit& hit) const;
  [[nodiscard]] bool is_plain(const Raster<std::optional<Sight>>& first, int x, int y) const;
  [[nodiscard]] Pixel plain_pixel(const std::optional<Sight>& sight, int x, int y) const;
  [[nodiscard]] Pixel sample_pixel(int x, int y) const;
  [[nodiscard]] std::vector<Vec2> sample_places(int x, int y) const;
  [[nodiscard]] Light shade(const Sight& sight, const Vec2& place, float spacing) const;
  [[nodiscard]] Colour develop(const Raster<Pixel>& band, int x, int y) const;

  const DisplayMesh& display_;
  const Scene& scene_;
  std::span<const Vec3> cloud_normals_;
  const Camera& camera_;
  int width_;
  int height_;
  int side_;                  // of the square of samples in a pixel
  bool fine_;                 // the style has more detail than the surface
  const ColourField* field_;  // or null
  float line_strength_;
  Style style_;
  SkyProbe sky_;
  std::optional<EdgeLines> lines_;
  SrgbTable to_srgb_;
};

}  // namespace surpass::picture

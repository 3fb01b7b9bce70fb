// Shaded pictures without a display. Library surpass::render (Embree, libpng).
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace surpass {

/// An 8-bit sRGB picture, rows from the top, 3 bytes a pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

struct RenderOptions {
  int width = 1024;
  int height = 768;
  int samples = 9;                 ///< rays a pixel; rounded up to a square
  double azimuth = 30;             ///< camera, degrees around the up axis
  double elevation = 20;           ///< camera, degrees above the horizon
  char up = 'y';                   ///< 'x', 'y' or 'z'
  bool smooth = true;              ///< shade with vertex normals (channel "normal", else averaged)
  bool edges = false;              ///< draw the edges of the mesh
  std::vector<Point> points = {};  ///< drawn as small balls, hidden where the surface covers them
  double point_radius = 0;  ///< relative to the box side; 0 chooses from the number of points
  std::optional<std::array<Point, 2>> frame =
      {};  ///< low and high of the box to fit; default: the mesh's
};

/// The mesh on a plain light background, fitted to the picture. Deterministic for any number of
/// threads. Errors: no faces, a size out of 1..16384.
[[nodiscard]] Result<Image> render(const Mesh& mesh, const RenderOptions& options = {},
                                   const Context& context = {});

/// Pictures of equal height side by side.
[[nodiscard]] Result<Image> beside(const std::vector<Image>& images);

/// The PNG file's bytes.
[[nodiscard]] Result<std::string> encode_png(const Image& image);

}  // namespace surpass

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

enum class Shading {
  matte,       ///< clay
  reflection,  ///< a mirror in a hall of 12 parallel lamps: lines show what is not fair
  wireframe,   ///< the edges of the mesh's polygons on white paper, hidden ones left out
  field,       ///< colours that stand for the numbers of RenderOptions::field
};

/// Numbers at the vertices, to be shown as colours.
struct ColourField {
  std::vector<double> values;  ///< #V, linear inside triangles; NaN is dark grey
  double low = 0;              ///< of the scale; numbers beyond its ends have the ends' colours
  double high = 1;
  bool diverging = false;  ///< blue, white in the middle, red; else pale to dark
  std::string title = {};  ///< over the scale: small letters, digits and . - + /
  bool legend = true;      ///< the scale at the right, in pictures of at least 240 x 160 pixels
};

struct RenderOptions {
  int width = 1024;       ///< pixels, 1 to 16384
  int height = 768;       ///< pixels, 1 to 16384
  int samples = 9;        ///< rays a pixel, 1 to 1024; rounded up to a square
  double azimuth = 30;    ///< camera, degrees around the up axis; 0 looks from the scene's front
  double elevation = 20;  ///< camera, degrees above the horizon
  double zoom = 1;        ///< 2 shows the middle at twice the size; 0.01 to 1000
  char up = 'y';          ///< 'y' with +z in front, 'z' with -y in front, or 'x' with +y in front
  bool smooth = true;     ///< false: flat facets
  double crease_angle = 45;  ///< degrees; edges that turn by more stay sharp although `smooth`
  bool edges = false;        ///< draw the edges of the mesh's polygons as fine lines
  Shading shading = Shading::matte;
  std::optional<ColourField> field = {};  ///< for Shading::field
  /// Least width of a strip at the right, in pixels, that belongs to the scale and stays empty
  /// without one: pictures with the same strip show the same frame equally large.
  int strip = 0;
  std::vector<Point> points = {};  ///< drawn as small balls, hidden where the surface covers them
  double point_radius = 0;         ///< relative to the box side; 0 chooses by number or distance
  std::vector<Point> frame = {};   ///< what to fit into the picture; empty: the mesh and `points`
};

/// The mesh on a plain light background, seen in perspective and fitted into the picture with a
/// small border. Two pictures with the same `frame`, `point_radius`, `strip`, size and camera share
/// a view.
///
/// Fronts of faces (counterclockwise) are warm, backs cool. Smooth shading takes the vertex channel
/// "normal", else face normals averaged by angle and, then, parted at edges above `crease_angle`;
/// creases (sharpness above 0) always stay sharp. Meshes that are no oriented manifold are drawn
/// with flat facets. Hole faces are not drawn. A mesh without faces is drawn as its points: small
/// balls, each with the shade of the plane through its neighbours; all styles but the matte one are
/// for faces. "Box side" in `point_radius` is that of what is fitted. The same bits for any number
/// of threads.
///
/// Errors: `invalid_argument` for an option out of its range, `mismatch` for a field without a
/// number for each vertex, `empty_mesh` for nothing to draw, `not_finite` and `index_out_of_range`
/// with the vertex or face, `degenerate_face` for faces of fewer than three corners, `cancelled`.
[[nodiscard]] Result<Image> render(const Mesh& mesh, const RenderOptions& options = {},
                                   const Context& context = {});

/// Pixels that the scale of `options.field` takes at the right of such a picture; 0 without one.
[[nodiscard]] int scale_width(const RenderOptions& options);

/// Pictures of equal height side by side, from left to right. Errors (`invalid_argument`): none, of
/// different heights, or with a number of bytes that does not fit their size.
[[nodiscard]] Result<Image> beside(const std::vector<Image>& images);

/// Pictures of one size in rows of so many columns; the background fills the last row. Errors
/// (`invalid_argument`): none, of different sizes, or with a wrong number of bytes.
[[nodiscard]] Result<Image> in_rows(const std::vector<Image>& images, std::size_t columns);

/// The PNG file's bytes. Errors: `invalid_argument` for an image whose bytes do not fit its size.
[[nodiscard]] Result<std::string> encode_png(const Image& image);

}  // namespace surpass

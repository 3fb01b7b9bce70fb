// Meshes and pixels for tests of pictures.
#pragma once

#include <surpass/render.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace surpass::samples {

/// Unit sphere around the origin, quads between two fans, outward.
inline Mesh sphere(Index meridians, Index parallels, double radius = 1) {
  Mesh mesh;
  mesh.points.push_back({0, radius, 0});
  for (Index j = 1; j < parallels; ++j) {
    const double down = std::numbers::pi * j / parallels;
    for (Index i = 0; i < meridians; ++i) {
      const double round = 2 * std::numbers::pi * i / meridians;
      mesh.points.push_back({radius * std::sin(down) * std::sin(round), radius * std::cos(down),
                             radius * std::sin(down) * std::cos(round)});
    }
  }
  mesh.points.push_back({0, -radius, 0});
  const auto at = [&](Index i, Index j) { return 1 + (j - 1) * meridians + i % meridians; };
  const Index south = mesh.vertex_count() - 1;
  for (Index i = 0; i < meridians; ++i) {
    mesh.add_face(std::array{Index{0}, at(i, 1), at(i + 1, 1)});
    for (Index j = 1; j + 1 < parallels; ++j) {
      mesh.add_face(std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh.add_face(std::array{south, at(i + 1, parallels - 1), at(i, parallels - 1)});
  }
  return mesh;
}

/// A square of side 2 in the plane z = 0 that faces +z, as one quad or as two triangles.
inline Mesh square(bool cut) {
  Mesh mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  if (cut) {
    mesh.add_face(std::array<Index, 3>{0, 1, 2});
    mesh.add_face(std::array<Index, 3>{0, 2, 3});
  } else {
    mesh.add_face(std::array<Index, 4>{0, 1, 2, 3});
  }
  return mesh;
}

/// Seen straight from the front (+z), without a tilt.
inline RenderOptions from_front(int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.azimuth = 0;
  options.elevation = 0;
  return options;
}

inline std::array<int, 3> pixel(const Image& image, int x, int y) {
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x));
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

inline int brightness(const Image& image, int x, int y) {
  const auto [r, g, b] = pixel(image, x, y);
  return r + g + b;
}

/// Whether something is drawn: the background does not change along a row, and pictures have a
/// free border.
inline bool is_drawn(const Image& image, int x, int y) {
  return pixel(image, x, y) != pixel(image, 0, y);
}

inline int count_drawn(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += is_drawn(image, x, y) ? 1 : 0;
  }
  return count;
}

/// The picture, which must succeed.
inline Image draw(const Mesh& mesh, const RenderOptions& options, int threads = 0) {
  Context context;
  context.threads = threads;
  Result<Image> image = render(mesh, options, context);
  EXPECT_TRUE(image) << (image ? "" : describe(image.error()));
  return image ? std::move(*image) : Image{};
}

}  // namespace surpass::samples

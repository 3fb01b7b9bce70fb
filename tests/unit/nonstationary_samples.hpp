// Meshes of the reference values and of the paper's examples, and surfaces made of them.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace surpass::test {

inline double side(const Mesh& mesh) { return bounding_box(mesh.points).side(); }

inline Mesh irregular_sphere(std::uint64_t seed) { return random_mesh({.seed = seed, .size = 6}); }

inline Mesh reference_tetrahedron() {
  return make_mesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

/// Apexes first; the rim's radius alternates between 1 and `inner`.
inline Mesh reference_bipyramid(Index n, double height = 1, double inner = 1) {
  Mesh mesh;
  mesh.points = {{0, 0, height}, {0, 0, -height}};
  for (Index i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    const double r = i % 2 == 0 ? 1 : inner;
    mesh.points.push_back({r * std::cos(t), r * std::sin(t), 0});
  }
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.add_face(std::vector<Index>{0, 2 + i, 2 + j});
    mesh.add_face(std::vector<Index>{1, 2 + j, 2 + i});
  }
  return mesh;
}

/// n triangles around vertex 0, the rim up and down; with `open`, one of them is missing.
inline Mesh wavy_fan(Index n, bool open = false) {
  Mesh mesh;
  mesh.points = {{0, 0, 0.5}};
  for (Index i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    mesh.points.push_back({std::cos(t), std::sin(t), 0.1 * (i % 2 == 0 ? 1 : -1)});
  }
  for (Index i = 0; i + (open ? 1 : 0) < n; ++i) {
    mesh.add_face(std::vector<Index>{0, 1 + i, 1 + (i + 1) % n});
  }
  return mesh;
}

inline NonstationaryLoop made(const Mesh& mesh, const NonstationaryOptions& options,
                              int levels = 0) {
  auto surface = NonstationaryLoop::create(mesh, options);
  EXPECT_TRUE(surface) << describe(surface.error());
  for (int level = 0; level < levels; ++level) {
    const auto refined = surface->refine();
    EXPECT_TRUE(refined) << describe(refined.error());
  }
  return std::move(*surface);
}

/// Largest difference of a coordinate between the first points of `found` and these.
inline double largest_error(const std::vector<Point>& found, const std::vector<Point>& points) {
  double largest = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::abs(found[v][c] - points[v][c]);
      if (!(error <= largest)) largest = error;
    }
  }
  return largest;
}

/// The largest angle, in degrees, between a face at one of the first vertices and its normal.
inline double worst_angle(const Mesh& mesh, const std::vector<Point>& normals) {
  double worst = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Point& a = mesh.points[face[0]];
    const Point& b = mesh.points[face[1]];
    const Point& c = mesh.points[face[2]];
    const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point w = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point n = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                     u[0] * w[1] - u[1] * w[0]};
    for (const Index v : face) {
      if (v >= normals.size()) continue;
      const double cosine = (n[0] * normals[v][0] + n[1] * normals[v][1] + n[2] * normals[v][2]) /
                            std::hypot(n[0], n[1], n[2]);
      worst = std::max(worst, std::acos(std::min(1.0, cosine)) * 180 / M_PI);
    }
  }
  return worst;
}

}  // namespace surpass::test

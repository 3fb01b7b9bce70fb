// Meshes for tests: closed forms, random ones, and the committed files.
#pragma once

#include <surpass/surpass.hpp>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace surpass::test {

inline Mesh make_mesh(std::vector<Point> points, const std::vector<std::vector<Index>>& faces) {
  Mesh mesh;
  mesh.points = std::move(points);
  for (const auto& face : faces) mesh.add_face(face);
  return mesh;
}

inline Mesh tetrahedron() {
  return make_mesh({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

inline Mesh octahedron() {
  return make_mesh(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

inline Mesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return make_mesh(
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

/// n-sided double pyramid: apexes are the last two vertices.
inline Mesh bipyramid(Index n) {
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    mesh.points.push_back({std::cos(t), std::sin(t), 0});
  }
  mesh.points.push_back({0, 0, 1});
  mesh.points.push_back({0, 0, -1});
  for (Index i = 0; i < n; ++i) {
    mesh.add_face(std::vector<Index>{i, (i + 1) % n, n});
    mesh.add_face(std::vector<Index>{(i + 1) % n, i, n + 1});
  }
  return mesh;
}

/// An nx by ny grid of points, each cell cut by one diagonal; heights from a small pattern.
inline Mesh triangle_grid(Index nx, Index ny) {
  Mesh mesh;
  for (Index y = 0; y < ny; ++y) {
    for (Index x = 0; x < nx; ++x) {
      const double z = 0.1 * ((7 * (y * nx + x)) % 5);
      mesh.points.push_back({static_cast<double>(x), static_cast<double>(y), z});
    }
  }
  for (Index y = 0; y + 1 < ny; ++y) {
    for (Index x = 0; x + 1 < nx; ++x) {
      const Index a = y * nx + x;
      mesh.add_face(std::vector<Index>{a, a + 1, a + nx + 1});
      mesh.add_face(std::vector<Index>{a, a + nx + 1, a + nx});
    }
  }
  return mesh;
}

/// Flips interior edges at random while that keeps the mesh simple: irregular valences.
Mesh flip_edges(const Mesh& mesh, std::mt19937_64& random, std::size_t tries);

/// Moves every point by up to `amount` in each coordinate.
Mesh jitter(Mesh mesh, std::mt19937_64& random, double amount);

/// What a random mesh looks like; see random_mesh.
struct RandomShape {
  std::uint64_t seed = 0;
  int kind = 0;        ///< 0 closed sphere, 1 torus, 2 open patch, 3 patch with a hole, 4 two parts
  int size = 6;        ///< resolution
  double creases = 0;  ///< share of edges made sharp or semi-sharp
  bool semi_sharp = false;
};

/// An irregular triangle mesh, the same for the same shape.
Mesh random_mesh(const RandomShape& shape);

/// Largest distance between corresponding points.
double max_distance(const std::vector<Point>& a, const std::vector<Point>& b);

/// A folder of real meshes given from outside, or "" without one.
std::string data_folder();

/// Paths of the meshes in a subfolder of it, sorted; empty without one.
std::vector<std::string> real_meshes(const std::string& subfolder);

/// Paths of the committed meshes, sorted.
std::vector<std::string> committed_meshes();

}  // namespace surpass::test

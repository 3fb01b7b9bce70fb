// Small meshes that tests of the mesh folder share.
#pragma once

#include <surpass/mesh.hpp>

#include <cmath>
#include <initializer_list>
#include <random>
#include <vector>

namespace surpass::samples {

using Face = std::vector<Index>;

/// Faces on vertices whose points lie on a curve that meets no plane more than three times.
inline Mesh faces(Index vertices, const std::vector<Face>& list) {
  Mesh mesh;
  for (Index v = 0; v < vertices; ++v) {
    const double t = v;
    mesh.points.push_back({t, t * t, t * t * t});
  }
  for (const Face& face : list) mesh.add_face(face);
  return mesh;
}

/// Unit cube of quads, outward.
inline Mesh cube() {
  Mesh mesh;
  for (unsigned v = 0; v < 8; ++v) {
    mesh.points.push_back({double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)});
  }
  for (const Face& f : std::vector<Face>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.add_face(f);
  }
  return mesh;
}

/// Tetrahedron, outward.
inline Mesh tetrahedron() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Face& f : std::vector<Face>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    mesh.add_face(f);
  }
  return mesh;
}

/// A quadrilateral grid of n by n squares of side 1 in the plane z = 0, facing up.
inline Mesh grid(Index n) {
  Mesh mesh;
  for (Index y = 0; y <= n; ++y) {
    for (Index x = 0; x <= n; ++x) mesh.points.push_back({double(x), double(y), 0});
  }
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x;
      mesh.add_face(Face{a, a + 1, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// Quads on an m by n torus grid; `twist` reflects it where the first direction closes: a Klein
/// bottle. Positions are those of a torus.
inline Mesh torus(Index m, Index n, bool twist) {
  Mesh mesh;
  const double pi = std::acos(-1.0);
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m;
      const double w = 2 * pi * j / n;
      mesh.points.push_back(
          {(3 + std::cos(w)) * std::cos(u), (3 + std::cos(w)) * std::sin(u), std::sin(w)});
    }
  }
  const auto at = [&](Index i, Index j) {
    if (i == m) return twist ? (n - j % n) % n : j % n;
    return i * n + j % n;
  };
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      mesh.add_face(Face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A band of n triangles on n vertices: a Moebius band for odd n.
inline Mesh band(Index n) {
  std::vector<Face> list;
  for (Index i = 0; i < n; ++i) {
    Face f{i, (i + 1) % n, (i + 2) % n};
    if (i % 2 == 1) std::swap(f[1], f[2]);
    list.push_back(f);
  }
  return faces(n, list);
}

/// n triangles around vertex 0, closed or open.
inline Mesh wheel(Index n, bool closed) {
  std::vector<Face> list;
  for (Index i = 0; i + (closed ? 0 : 1) < n; ++i) list.push_back({0, 1 + i, 1 + (i + 1) % n});
  Mesh mesh = faces(n + 1, list);
  const double pi = std::acos(-1.0);
  mesh.points[0] = {0, 0, 0};
  for (Index i = 0; i < n; ++i) {
    mesh.points[1 + i] = {std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0};
  }
  return mesh;
}

/// Random polygons, with whatever wrongs come of it.
inline Mesh soup(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<Index>(random() % n); };
  const Index vertices = 3 + below(12);
  Mesh mesh;
  for (Index v = 0; v < vertices; ++v) {
    mesh.points.push_back({double(below(4)), double(below(4)), double(below(4))});
  }
  const Index count = 1 + below(30);
  for (Index f = 0; f < count; ++f) {
    Face face;
    if (f > 0 && below(6) == 0) {  // a repeat, turned and rotated
      const auto old = mesh.face(below(f));
      face.assign(old.begin(), old.end());
      if (below(2) == 0) face = Face(face.rbegin(), face.rend());
      if (!face.empty()) std::rotate(face.begin(), face.begin() + 1, face.end());
    } else {
      const Index size = below(10) == 0 ? below(9) : 3 + below(2);
      for (Index i = 0; i < size; ++i) face.push_back(below(vertices));
    }
    mesh.add_face(face);
  }
  return mesh;
}

/// Six times the volume that the faces enclose.
inline double six_volumes(const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Point& a = mesh.points[face[0]];
      const Point& b = mesh.points[face[i - 1]];
      const Point& c = mesh.points[face[i]];
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum;
}

}  // namespace surpass::samples

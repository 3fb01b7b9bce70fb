#include "support/polygons.hpp"

#include <algorithm>

namespace surpass::test {
namespace {

// The corners of both faces of an edge, without the edge.
std::vector<Index> joined(const Topology& topology, Index h) {
  std::vector<Index> face;
  for (const Index side : {h, topology.opposite(h)}) {
    for (Index g = topology.next(side); g != side; g = topology.next(g)) {
      face.push_back(topology.tail(g));
    }
  }
  return face;
}

bool is_simple(std::vector<Index> face) {
  std::sort(face.begin(), face.end());
  return std::adjacent_find(face.begin(), face.end()) == face.end();
}

Mesh with_creases(Mesh mesh, const std::vector<std::array<Index, 2>>& edges) {
  for (const auto& edge : edges) mesh.creases.push_back({edge, kInfinitelySharp});
  return mesh;
}

Mesh with_corners(Mesh mesh, const std::vector<Index>& vertices) {
  for (const Index v : vertices) mesh.corners.push_back({v, kInfinitelySharp});
  return mesh;
}

// b's vertex `at_b` becomes a's vertex `at_a`.
Mesh joined_at_vertex(const Mesh& a, Index at_a, const Mesh& b, Index at_b) {
  Mesh out = a;
  std::vector<Index> number(b.vertex_count());
  for (Index v = 0; v < b.vertex_count(); ++v) {
    number[v] = v == at_b ? at_a : out.vertex_count();
    Point p = b.points[v];
    for (std::size_t c = 0; c < 3; ++c) p[c] += a.points[at_a][c] - b.points[at_b][c];
    if (v != at_b) out.points.push_back(p);
  }
  for (Index f = 0; f < b.face_count(); ++f) {
    std::vector<Index> face;
    for (const Index v : b.face(f)) face.push_back(number[v]);
    out.add_face(face);
  }
  return out;
}

}  // namespace

Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  for (const auto& face : std::vector<std::vector<Index>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.add_face(face);
  }
  return mesh;
}

Mesh dual(const Mesh& mesh) {
  Mesh out;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Point mean = {};
    for (const Index v : mesh.face(f)) {
      for (std::size_t k = 0; k < 3; ++k) {
        mean[k] += mesh.points[v][k] / static_cast<double>(mesh.face(f).size());
      }
    }
    out.points.push_back(mean);
  }
  const Topology topology = Topology::build(mesh).value();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    std::vector<Index> face;
    topology.for_each_outgoing(v, [&](Index h) { face.push_back(topology.face(h)); });
    out.add_face(face);
  }
  return out;
}

Mesh prism(Index n) {
  Mesh mesh;
  std::vector<Index> bottom;
  std::vector<Index> top;
  for (const double z : {-0.7, 0.7}) {
    for (Index i = 0; i < n; ++i) {
      const double t = 2 * M_PI * i / n;
      mesh.points.push_back({std::cos(t), std::sin(t), z});
    }
  }
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.add_face(std::vector<Index>{i, j, n + j, n + i});
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  return mesh;
}

Mesh quad_grid(Index nx, Index ny) {
  Mesh mesh = triangle_grid(nx, ny);
  mesh.face_offsets = {0};
  mesh.face_vertices.clear();
  for (Index y = 0; y + 1 < ny; ++y) {
    for (Index x = 0; x + 1 < nx; ++x) {
      const Index a = y * nx + x;
      mesh.add_face(std::vector<Index>{a, a + 1, a + nx + 1, a + nx});
    }
  }
  return mesh;
}

Mesh pillow(Index n) {
  Mesh mesh;
  std::vector<Index> front;
  for (Index i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    mesh.points.push_back({std::cos(t), std::sin(t), 0.2 * std::cos(3 * t) + 0.1 * (i % 2)});
    front.push_back(i);
  }
  mesh.add_face(front);
  std::reverse(front.begin(), front.end());
  mesh.add_face(front);
  return mesh;
}

Mesh split_edge(const Mesh& mesh, Index a, Index b, const Point& point) {
  Mesh out = mesh;
  out.points.push_back(point);
  out.face_offsets = {0};
  out.face_vertices.clear();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> face;
    const auto given = mesh.face(f);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Index next = given[(i + 1) % given.size()];
      face.push_back(given[i]);
      if ((given[i] == a && next == b) || (given[i] == b && next == a)) {
        face.push_back(mesh.vertex_count());
      }
    }
    out.add_face(face);
  }
  return out;
}

Mesh join_faces(const Mesh& mesh, std::mt19937_64& random, std::size_t tries, Index valence) {
  Mesh out = mesh;
  for (std::size_t t = 0; t < tries; ++t) {
    const Topology topology = Topology::build(out).value();
    const auto e = static_cast<Index>(random() % topology.edge_count());
    if (topology.is_boundary_edge(e)) continue;
    const Index h = topology.edge_halfedge(e);
    const auto enough = [&](Index v) {
      return topology.is_boundary(v) || topology.valence(v) > valence;
    };
    const std::vector<Index> face = joined(topology, h);
    if (!is_simple(face) || face.size() > 7 || !enough(topology.tail(h)) ||
        !enough(topology.head(h))) {
      continue;
    }
    Mesh next = out;
    next.face_offsets = {0};
    next.face_vertices.clear();
    for (Index f = 0; f < out.face_count(); ++f) {
      if (f == topology.face(h)) next.add_face(face);
      if (f != topology.face(h) && f != topology.face(topology.opposite(h))) {
        next.add_face(out.face(f));
      }
    }
    out = std::move(next);
  }
  return out;
}

Mesh random_polygons(const RandomShape& shape, Index valence) {
  std::mt19937_64 random(shape.seed + 1000);
  RandomShape smooth = shape;
  smooth.creases = 0;
  const Mesh triangles = random_mesh(smooth);
  Mesh mesh = join_faces(triangles, random, triangles.points.size(), valence);
  const Topology topology = Topology::build(mesh).value();
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (static_cast<double>(random() >> 11) * 0x1p-53 >= shape.creases) continue;
    mesh.creases.push_back({topology.edge_vertices(e), kInfinitelySharp});
  }
  return mesh;
}

std::vector<Sample> polygon_samples() {
  const Mesh one_face =
      make_mesh({{0, 0, 0}, {2, 0, 0.3}, {3, 1, 0}, {1, 2, 0.2}, {0, 1, 0}}, {{0, 1, 2, 3, 4}});
  Mesh with_isolated = cube();
  with_isolated.points.push_back({3, 3, 3});
  const std::vector<std::array<Index, 2>> top = {{4, 5}, {5, 7}, {7, 6}, {6, 4}};
  const Mesh split = split_edge(cube(), 4, 5, {0.2, -1.3, 1.2});  // vertex 8 has two faces
  return {
      {"tetrahedron", tetrahedron()},
      {"cube", cube()},
      {"prism 7", prism(7)},
      {"isolated vertex", with_isolated},
      {"random sphere", random_polygons({.seed = 1, .kind = 0})},
      {"random torus", random_polygons({.seed = 2, .kind = 1})},
      {"grid", quad_grid(4, 4)},
      {"one face", one_face},
      {"random patch", random_polygons({.seed = 3, .kind = 2})},
      {"random patch with hole", random_polygons({.seed = 4, .kind = 3})},
      {"cube, top sharp", with_creases(cube(), top)},
      {"cube, top sharp and tagged", with_corners(with_creases(cube(), top), {4, 7})},
      {"cube, one sharp edge", with_creases(cube(), {{0, 1}})},
      {"cube, crease of two edges", with_creases(cube(), {{0, 1}, {1, 3}})},
      {"grid, crease to the boundary", with_creases(quad_grid(4, 4), {{1, 5}, {5, 9}})},
      {"random creases", random_polygons({.seed = 5, .kind = 0, .creases = 0.15})},
      {"random open creases", random_polygons({.seed = 6, .kind = 3, .creases = 0.15})},
      {"tip", with_corners(cube(), {0}), false},
      {"tip with a crease", with_corners(with_creases(cube(), {{0, 1}}), {0}), false},
      {"closed bow-tie", joined_at_vertex(tetrahedron(), 0, cube(), 7), false},
      {"open bow-tie", joined_at_vertex(quad_grid(3, 3), 8, quad_grid(2, 2), 0)},
      {"mixed bow-tie", joined_at_vertex(quad_grid(3, 3), 8, cube(), 0), false},
      {"bow-tie inside", joined_at_vertex(quad_grid(3, 3), 4, quad_grid(3, 3), 4), false},
      {"pillow", pillow(5), false},
      {"triangular pillow", pillow(3), false},
      {"doublets", random_polygons({.seed = 7, .kind = 0}, 2)},
      {"open doublets", random_polygons({.seed = 8, .kind = 2}, 2)},
      {"doublets and creases", random_polygons({.seed = 9, .kind = 0, .creases = 0.1}, 2)},
      {"pillow, one sharp edge", with_creases(pillow(5), {{0, 1}}), false},
      {"pillow, sharp seam", with_creases(pillow(4), {{0, 1}, {1, 2}, {2, 3}, {3, 0}}), false},
      {"doublet on an edge", split},
      {"doublet on a crease", with_creases(split, {{4, 8}, {8, 5}})},
      {"dart with two faces", with_creases(split, {{4, 8}})},
      {"lens on an edge", with_corners(split, {8}), false},
      {"lens and crease on an edge", with_corners(with_creases(split, {{4, 8}}), {8}), false},
      {"corner of two faces", with_corners(with_creases(split, {{4, 8}, {8, 5}}), {8})},
      {"lens", with_corners(pillow(5), {2}), false},
      {"two lenses", with_corners(pillow(4), {1, 2}), false},
      {"bow-tie lens", joined_at_vertex(pillow(5), 0, cube(), 0), false},
      {"lens and crease", with_corners(with_creases(pillow(5), {{2, 3}}), {2}), false},
  };
}

}  // namespace surpass::test

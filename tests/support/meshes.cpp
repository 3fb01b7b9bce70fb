#include "support/meshes.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace surpass::test {
namespace {

std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> paths;
  if (!std::filesystem::is_directory(folder)) return paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (format_of_path(entry.path().string()) != Format::automatic) {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// A grid that closes in both directions.
Mesh torus(Index nu, Index nv) {
  Mesh mesh;
  for (Index j = 0; j < nv; ++j) {
    for (Index i = 0; i < nu; ++i) {
      const double u = 2 * M_PI * i / nu;
      const double v = 2 * M_PI * j / nv;
      const double r = 2 + 0.8 * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), 0.8 * std::sin(v)});
    }
  }
  const auto at = [&](Index i, Index j) { return (j % nv) * nu + i % nu; };
  for (Index j = 0; j < nv; ++j) {
    for (Index i = 0; i < nu; ++i) {
      mesh.add_face(std::vector<Index>{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.add_face(std::vector<Index>{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

Mesh sphere(int levels) {
  Mesh mesh = refine(icosahedron(), {}, levels).value();
  for (Point& p : mesh.points) {
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x /= length;
  }
  return mesh;
}

// Without a block of faces in the middle; vertices that lose all faces stay as isolated ones.
Mesh with_hole(const Mesh& mesh) {
  Mesh out = mesh;
  out.face_offsets = {0};
  out.face_vertices.clear();
  const Index n = mesh.face_count();
  for (Index f = 0; f < n; ++f) {
    if (f < n / 2 || f >= n / 2 + 2) out.add_face(mesh.face(f));
  }
  return out;
}

Mesh beside(const Mesh& a, const Mesh& b) {
  Mesh out = a;
  for (Point p : b.points) {
    p[0] += 6;
    out.points.push_back(p);
  }
  for (Index f = 0; f < b.face_count(); ++f) {
    std::vector<Index> face;
    for (const Index v : b.face(f)) face.push_back(v + a.vertex_count());
    out.add_face(face);
  }
  return out;
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

Mesh flip_edges(const Mesh& mesh, std::mt19937_64& random, std::size_t tries) {
  Mesh flipped = mesh;
  for (std::size_t t = 0; t < tries; ++t) {
    const Topology topology = Topology::build(flipped).value();
    const auto e = static_cast<Index>(random() % topology.edge_count());
    if (topology.is_boundary_edge(e)) continue;
    const Index h = topology.edge_halfedge(e);
    const Index g = topology.opposite(h);
    const Index a = topology.tail(h);
    const Index b = topology.head(h);
    const Index c = topology.tail(topology.previous(h));
    const Index d = topology.tail(topology.previous(g));
    const bool simple = c != d && topology.find_edge(c, d) == kNone && topology.valence(a) > 3 &&
                        topology.valence(b) > 3;
    if (!simple) continue;
    const auto set = [&](Index face, Index p, Index q, Index r) {
      std::copy_n(std::initializer_list<Index>{p, q, r}.begin(), 3,
                  flipped.face_vertices.begin() + topology.face_begin(face));
    };
    set(topology.face(h), c, d, b);
    set(topology.face(g), d, c, a);
  }
  return flipped;
}

Mesh jitter(Mesh mesh, std::mt19937_64& random, double amount) {
  for (Point& p : mesh.points) {
    for (double& x : p) x += uniform(random, -amount, amount);
  }
  return mesh;
}

Mesh random_mesh(const RandomShape& shape) {
  std::mt19937_64 random(shape.seed);
  const auto n = static_cast<Index>(shape.size);
  Mesh mesh;
  switch (shape.kind) {
    case 0: mesh = sphere(1); break;
    case 1: mesh = torus(n + 2, n); break;
    case 2: mesh = triangle_grid(n, n + 1); break;
    case 3: mesh = with_hole(triangle_grid(n + 2, n + 2)); break;
    default: mesh = beside(sphere(1), triangle_grid(n, n)); break;
  }
  mesh = jitter(flip_edges(mesh, random, 3 * mesh.points.size()), random, 0.15);
  const Topology topology = Topology::build(mesh).value();
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (uniform(random, 0, 1) >= shape.creases) continue;
    const auto sharpness = static_cast<float>(uniform(random, 0.2, 2.8));
    mesh.creases.push_back({topology.edge_vertices(e), shape.semi_sharp ? sharpness : 10.0F});
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (uniform(random, 0, 1) >= shape.creases / 4) continue;
    const auto sharpness = static_cast<float>(uniform(random, 0.2, 2.5));
    mesh.corners.push_back({v, shape.semi_sharp ? sharpness : 10.0F});
  }
  return mesh;
}

double max_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]);
    if (!(d <= largest)) largest = d;
  }
  return largest;
}

std::string data_folder() {
  const char* folder = std::getenv("SURPASS_TEST_DATA");
  return folder != nullptr ? folder : "";
}

std::vector<std::string> real_meshes(const std::string& subfolder) {
  if (data_folder().empty()) return {};
  return files_in(std::filesystem::path(data_folder()) / subfolder);
}

std::vector<std::string> committed_meshes() { return files_in(SURPASS_DATA_DIR); }

}  // namespace surpass::test

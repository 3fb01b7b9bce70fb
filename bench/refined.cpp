// New vertices are recognized by the given ones around them: two for an edge, four for a quad.
//
// Loop, Smooth subdivision surfaces based on triangles, 1987; Catmull, Clark, Recursively generated
// B-spline surfaces on arbitrary topological meshes, 1978.
#include "refined.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace surpass::bench {
namespace {

using Vector = std::array<double, 3>;

Vector& operator+=(Vector& a, const Vector& b) {
  for (std::size_t k = 0; k < 3; ++k) a[k] += b[k];
  return a;
}
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vector operator+(Vector a, const Vector& b) { return a += b; }

// The given vertices around a new one, ascending, and its point.
struct NewVertex {
  std::array<Index, 4> around = {kNone, kNone, kNone, kNone};
  Point point = {};
};

bool in_order(const NewVertex& a, const NewVertex& b) { return a.around < b.around; }

// A half-edge, as seen from its edge.
struct Side {
  std::array<Index, 2> edge;  // ascending
  Index face;
  Index corner;  // in the face
};

// The two sides of an edge next to each other.
std::vector<Side> sides(const Mesh& mesh) {
  std::vector<Side> all;
  all.reserve(mesh.face_vertices.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (Index k = 0; k < face.size(); ++k) {
      const auto [a, b] = std::minmax(face[k], face[(k + 1) % face.size()]);
      all.push_back({{a, b}, f, k});
    }
  }
  std::sort(all.begin(), all.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  return all;
}

// All new points of a closed mesh: the given vertices' in order, the others sorted.
struct Expected {
  std::vector<Point> old_points;
  std::vector<NewVertex> new_vertices;
};

Expected loop_step(const Mesh& mesh) {
  Expected expected;
  std::vector<Vector> ring(mesh.points.size(), Vector{});
  std::vector<double> valence(mesh.points.size(), 0);
  const auto edges = sides(mesh);
  const auto across = [&](const Side& side) {
    return mesh.points[mesh.face(side.face)[(side.corner + 2) % 3]];
  };
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const auto [a, b] = edges[i].edge;
    ring[a] += mesh.points[b];
    ring[b] += mesh.points[a];
    ++valence[a], ++valence[b];
    const Vector ends = mesh.points[a] + mesh.points[b];
    const Vector sides = across(edges[i]) + across(edges[i + 1]);
    expected.new_vertices.push_back({{a, b, kNone, kNone}, 3.0 / 8 * ends + 1.0 / 8 * sides});
  }
  for (std::size_t v = 0; v < ring.size(); ++v) {
    const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / valence[v]) / 4;
    const double moved = 5.0 / 8 - c * c;
    expected.old_points.push_back((1 - moved) * mesh.points[v] + moved / valence[v] * ring[v]);
  }
  return expected;
}

// The vertex point is (F + 2 R + (n - 3) P) / n with the means F of face points and R of edges'
// midpoints.
Expected catmull_clark_step(const Mesh& mesh) {
  Expected expected;
  std::vector<Vector> centroids;
  std::vector<Vector> faces(mesh.points.size(), Vector{});
  std::vector<Vector> middles(mesh.points.size(), Vector{});
  std::vector<double> valence(mesh.points.size(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    NewVertex center;
    for (std::size_t k = 0; k < 4; ++k) {
      center.around[k] = mesh.face(f)[k];
      center.point += 1.0 / 4 * mesh.points[center.around[k]];
    }
    for (const Index v : center.around) faces[v] += center.point;
    std::sort(center.around.begin(), center.around.end());
    centroids.push_back(center.point);
    expected.new_vertices.push_back(center);
  }
  const auto edges = sides(mesh);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const auto [a, b] = edges[i].edge;
    const Vector ends = mesh.points[a] + mesh.points[b];
    for (const Index v : {a, b}) {
      middles[v] += 1.0 / 2 * ends;
      ++valence[v];
    }
    const Vector beside = centroids[edges[i].face] + centroids[edges[i + 1].face];
    expected.new_vertices.push_back({{a, b, kNone, kNone}, 1.0 / 4 * (ends + beside)});
  }
  for (std::size_t v = 0; v < valence.size(); ++v) {
    const double n = valence[v];
    expected.old_points.push_back(
        1 / n * (1 / n * (faces[v] + 2.0 * middles[v]) + (n - 3) * mesh.points[v]));
  }
  return expected;
}

void note(NewVertex& vertex, Index around) {
  for (Index& place : vertex.around) {
    if (place == around) return;
    if (place != kNone) continue;
    place = around;
    return;
  }
}

// In a child face with a given vertex its neighbours are on edges and, in quads, the corner
// opposite to it is a face's.
std::vector<NewVertex> new_vertices(const RefinedFaces& refined, Index old) {
  std::vector<NewVertex> found(refined.points.size() - old);
  for (std::size_t v = 0; v < found.size(); ++v) found[v].point = refined.points[old + v];
  for (std::size_t begin = 0; begin < refined.corners.size(); begin += refined.size) {
    for (Index k = 0; k < refined.size; ++k) {
      const Index v = refined.corners[begin + k];
      if (v >= old) continue;
      for (Index j = 1; j < refined.size; ++j) {
        const Index w = refined.corners[begin + (k + j) % refined.size];
        if (w >= old) note(found[w - old], v);
      }
    }
  }
  for (NewVertex& vertex : found) std::sort(vertex.around.begin(), vertex.around.end());
  return found;
}

}  // namespace

const Mesh& given(const Workload& workload, Scheme scheme) {
  return scheme == Scheme::loop ? workload.mesh() : workload.quads();
}

Verdict judge_refined(const Workload& workload, Scheme scheme, const RefinedFaces& refined,
                      Agreement agreement) {
  Verdict verdict{.difference = std::numeric_limits<double>::infinity(),
                  .allowed = agreement == Agreement::doubles ? 1e-14 : 1e-7};
  const Mesh& mesh = given(workload, scheme);
  Expected expected = scheme == Scheme::loop ? loop_step(mesh) : catmull_clark_step(mesh);
  const std::size_t old = mesh.points.size();
  if (refined.points.size() != old + expected.new_vertices.size() ||
      refined.corners.size() != std::size_t{refined.size == 3 ? 12U : 4U} * mesh.face_count() *
                                    (refined.size == 3 ? 1 : 4)) {
    return verdict;
  }
  auto found = new_vertices(refined, mesh.vertex_count());
  std::sort(found.begin(), found.end(), in_order);
  std::sort(expected.new_vertices.begin(), expected.new_vertices.end(), in_order);
  const std::span<const Point> points = refined.points;
  std::vector<Point> theirs(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(old));
  std::vector<Point>& ours = expected.old_points;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].around != expected.new_vertices[i].around) return verdict;
    theirs.push_back(found[i].point);
    ours.push_back(expected.new_vertices[i].point);
  }
  verdict.difference = workload.difference(theirs, ours);
  return verdict;
}

}  // namespace surpass::bench

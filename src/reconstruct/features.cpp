#include "reconstruct/features.hpp"

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mesh/disjoint_sets.hpp"
#include "reconstruct/vectors.hpp"

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kShortestCurve = 4;  // edges

Vector3d position(const Mesh& mesh, Index v) { return as_vector(mesh.points[v]); }

Vector3d normal(const Mesh& mesh, Index f) {
  const auto face = mesh.face(f);
  const Vector3d a = position(mesh, face[0]);
  return (position(mesh, face[1]) - a).cross(position(mesh, face[2]) - a);
}

// Of the angle between two vectors; for a vector of length zero the angle is none.
bool turns_more(const Vector3d& a, const Vector3d& b, double cosine) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0 && a.dot(b) < cosine * lengths;
}

std::vector<std::array<Index, 2>> sharp_edges(const Mesh& mesh, const Topology& topology,
                                              double cosine) {
  std::vector<std::array<Index, 2>> found;
  for (Index h = 0; h < topology.corner_count(); ++h) {
    const Index other = topology.opposite(h);
    if (other == kNone || other < h) continue;
    if (turns_more(normal(mesh, topology.face(h)), normal(mesh, topology.face(other)), cosine)) {
      found.push_back({topology.tail(h), topology.head(h)});
    }
  }
  return found;
}

std::vector<std::array<Index, 2>> without_short_curves(
    const std::vector<std::array<Index, 2>>& edges, std::size_t vertices) {
  DisjointSets curves(vertices);
  for (const auto& [a, b] : edges) curves.unite(a, b);
  std::vector<std::size_t> length(vertices, 0);
  for (const auto& [a, b] : edges) ++length[curves.find(a)];
  std::vector<std::array<Index, 2>> kept;
  for (const auto& edge : edges) {
    if (length[curves.find(edge[0])] >= kShortestCurve) kept.push_back(edge);
  }
  return kept;
}

}  // namespace

Features find_features(const Mesh& mesh, const Topology& topology, double degrees) {
  const double cosine = std::cos(degrees * M_PI / 180);
  Features features;
  features.creases = without_short_curves(sharp_edges(mesh, topology, cosine), mesh.points.size());
  std::vector<std::array<Index, 2>> ends(mesh.points.size(), {kNone, kNone});
  std::vector<Index> count(mesh.points.size(), 0);
  const auto note = [&](Index v, Index w) {
    if (count[v] < 2) ends[v][count[v]] = w;
    ++count[v];
  };
  for (const auto& [a, b] : features.creases) {
    note(a, b);
    note(b, a);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (count[v] != 2) continue;
    const Vector3d in = position(mesh, v) - position(mesh, ends[v][0]);
    const Vector3d out = position(mesh, ends[v][1]) - position(mesh, v);
    if (turns_more(in, out, cosine)) features.corners.push_back(v);
  }
  return features;
}

}  // namespace surpass::reconstruction

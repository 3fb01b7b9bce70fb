// The triangles of a hole are those whose largest angle between neighbours is smallest and, among
// such, whose area is: P. Liepa, Filling holes in meshes, Symposium on Geometry Processing 2003,
// found by the dynamic programme of G. Barequet, M. Sharir, Filling gaps in the boundary of a
// polyhedron, Computer Aided Geometric Design 12 (1995). Without Liepa's refinement: the points of
// the mesh are data, and none is added.
#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "reconstruct/clean_up.hpp"
#include "reconstruct/vectors.hpp"

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

// The programme takes time with the cube of the length: longer loops are cut at short chords first.
constexpr std::size_t kLongestLoop = 150;
constexpr std::size_t kSmallLoop = 30;

// The edges that a mesh has, by their end vertices.
class Edges {
 public:
  void add(Index a, Index b) { edges_.insert(key(a, b)); }
  [[nodiscard]] bool has(Index a, Index b) const { return edges_.contains(key(a, b)); }

 private:
  static std::uint64_t key(Index a, Index b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }
  std::unordered_set<std::uint64_t> edges_;
};

// A closed polygon that runs as the boundary of its faces will; `beyond[i]` is the normal of the
// face on the other side of the edge from vertex i to the next, or zero where there is none yet.
struct Polygon {
  std::vector<Index> vertices;
  std::vector<Vector3d> beyond;
};

struct Weight {
  double turn = 0;  // 1 - cosine of the largest angle between neighbouring normals
  double area = 0;
  [[nodiscard]] bool operator<(const Weight& other) const {
    return turn != other.turn ? turn < other.turn : area < other.area;
  }
};
constexpr Weight kImpossible = {std::numeric_limits<double>::infinity(), 0};

// One run of the programme.
class PolygonFilling {
 public:
  PolygonFilling(const Mesh& mesh, const Edges& edges, const Polygon& polygon)
      : mesh_(mesh),
        edges_(edges),
        polygon_(polygon),
        n_(polygon.vertices.size()),
        best_(n_ * n_),
        apex_(n_ * n_, 0) {}

  // False if there is none.
  bool run(std::vector<std::array<Index, 3>>& triangles) {
    for (std::size_t length = 2; length < n_; ++length) {
      for (std::size_t i = 0; i + length < n_; ++i) choose(i, i + length);
    }
    if (best_[n_ - 1].turn == kImpossible.turn) return false;
    std::vector<std::array<std::size_t, 2>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j - i < 2) continue;
      const std::size_t k = apex_[i * n_ + j];
      triangles.push_back({vertex(i), vertex(k), vertex(j)});
      open.push_back({i, k});
      open.push_back({k, j});
    }
    return true;
  }

 private:
  [[nodiscard]] Index vertex(std::size_t i) const { return polygon_.vertices[i]; }
  [[nodiscard]] Vector3d at(std::size_t i) const { return as_vector(mesh_.points[vertex(i)]); }
  [[nodiscard]] Vector3d cross(std::size_t i, std::size_t k, std::size_t j) const {
    return (at(k) - at(i)).cross(at(j) - at(i));
  }
  static double turn(const Vector3d& a, const Vector3d& b) {
    if (b.squaredNorm() == 0) return 0;
    const double lengths = a.norm() * b.norm();
    return lengths > 0 ? 1 - a.dot(b) / lengths : 2;
  }
  [[nodiscard]] bool allowed(std::size_t i, std::size_t j) const {
    const bool side = j == i + 1 || (i == 0 && j == n_ - 1);
    return side || (vertex(i) != vertex(j) && !edges_.has(vertex(i), vertex(j)));
  }
  // Normal of what lies on the other side of the diagonal, as chosen before.
  [[nodiscard]] Vector3d across(std::size_t i, std::size_t j) const {
    return j == i + 1 ? polygon_.beyond[i] : cross(i, apex_[i * n_ + j], j);
  }

  void choose(std::size_t i, std::size_t j) {
    Weight& best = best_[i * n_ + j];
    best = kImpossible;
    if (!allowed(i, j)) return;
    for (std::size_t k = i + 1; k < j; ++k) {
      const Weight& left = best_[i * n_ + k];
      const Weight& right = best_[k * n_ + j];
      const double parts = std::max(left.turn, right.turn);
      if (parts > best.turn || parts == kImpossible.turn) continue;
      const Vector3d normal = cross(i, k, j);
      Weight weight = {std::max({parts, turn(normal, across(i, k)), turn(normal, across(k, j))}),
                       left.area + right.area + normal.norm()};
      if (i == 0 && j == n_ - 1) {
        weight.turn = std::max(weight.turn, turn(normal, polygon_.beyond.back()));
      }
      if (!(weight < best)) continue;
      best = weight;
      apex_[i * n_ + j] = k;
    }
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const Polygon& polygon_;
  std::size_t n_;
  std::vector<Weight> best_;  // of the part from vertex i to vertex j, at i n + j
  std::vector<std::size_t> apex_;
};

// The chord that cuts off at least a third, shortest first; false if none may be drawn.
bool cut(const Mesh& mesh, const Edges& edges, const Polygon& polygon,
         std::array<Polygon, 2>& parts) {
  const std::size_t n = polygon.vertices.size();
  double shortest = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 2> ends = {};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + n / 3; j < n && j - i <= n - n / 3; ++j) {
      const Index a = polygon.vertices[i];
      const Index b = polygon.vertices[j];
      const double length = (as_vector(mesh.points[a]) - as_vector(mesh.points[b])).squaredNorm();
      if (length >= shortest || a == b || edges.has(a, b)) continue;
      shortest = length;
      ends = {i, j};
    }
  }
  if (shortest == std::numeric_limits<double>::infinity()) return false;
  const auto take = [&](std::size_t from, std::size_t to) {
    Polygon part;
    for (std::size_t k = from; k != to; k = (k + 1) % n) {
      part.vertices.push_back(polygon.vertices[k]);
      part.beyond.push_back(polygon.beyond[k]);
    }
    part.vertices.push_back(polygon.vertices[to]);
    part.beyond.push_back(Vector3d::Zero());
    return part;
  };
  parts = {take(ends[0], ends[1]), take(ends[1], ends[0])};
  return true;
}

// The new edges are added to `edges`, also if the loop is given up: they bar nothing but
// themselves.
bool fill(const Mesh& mesh, Edges& edges, const Polygon& polygon,
          std::vector<std::array<Index, 3>>& triangles) {
  std::vector<Polygon> open = {polygon};
  while (!open.empty()) {
    const Polygon part = std::move(open.back());
    open.pop_back();
    if (part.vertices.size() <= kLongestLoop) {
      const std::size_t before = triangles.size();
      if (!PolygonFilling(mesh, edges, part).run(triangles)) return false;
      for (std::size_t t = before; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) edges.add(triangles[t][k], triangles[t][(k + 1) % 3]);
      }
      continue;
    }
    std::array<Polygon, 2> halves;
    if (!cut(mesh, edges, part, halves)) return false;
    edges.add(halves[0].vertices.front(), halves[0].vertices.back());
    open.insert(open.end(), halves.begin(), halves.end());
  }
  return true;
}

std::vector<std::size_t> vertices_of_pieces(const Topology& topology, const Components& pieces) {
  std::vector<std::size_t> count(pieces.count, 0);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (pieces.of_vertex[v] != kNone) ++count[pieces.of_vertex[v]];
  }
  return count;
}

// A sheet's own outline is no hole: a small loop is short beside the piece that it bounds.
bool is_small(std::size_t edges, std::size_t vertices) {
  return edges <= kSmallLoop && edges * edges <= 2 * vertices;
}

Polygon hole_of(const Mesh& mesh, const Topology& topology, const std::vector<Index>& loop) {
  Polygon polygon;
  for (std::size_t i = loop.size(); i-- > 0;) {
    const Index h = loop[i];
    const auto face = mesh.face(topology.face(h));
    const Vector3d a = as_vector(mesh.points[face[0]]);
    polygon.vertices.push_back(topology.head(h));
    polygon.beyond.push_back(
        (as_vector(mesh.points[face[1]]) - a).cross(as_vector(mesh.points[face[2]]) - a));
  }
  return polygon;
}

}  // namespace

Result<Holes> fill_holes(Mesh& mesh, Closing closing, const Context& context) {
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  const std::vector<std::vector<Index>> loops = boundary_loops(*topology);
  Holes holes{.left = loops.size()};
  if (closing == Closing::none || loops.empty()) return holes;
  const Components pieces = find_components(*topology);
  const std::vector<std::size_t> sizes = vertices_of_pieces(*topology, pieces);
  // Chords join vertices of loops, so no other edges can be in their way.
  Edges edges;
  for (Index h = 0; h < topology->corner_count(); ++h) {
    const Index a = topology->tail(h);
    const Index b = topology->head(h);
    if (topology->is_boundary(a) && topology->is_boundary(b)) edges.add(a, b);
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double done = static_cast<double>(i) / static_cast<double>(loops.size());
    context.report({.stage = "holes", .fraction = done});
    if (context.cancelled())
      return fail(ErrorCode::cancelled, "the reconstruction was interrupted");
    const Index piece = pieces.of_vertex[topology->head(loops[i].front())];
    if (closing == Closing::small && !is_small(loops[i].size(), sizes[piece])) continue;
    std::vector<std::array<Index, 3>> triangles;
    if (!fill(mesh, edges, hole_of(mesh, *topology, loops[i]), triangles)) continue;
    for (const auto& t : triangles) mesh.add_face(t);
    ++holes.filled;
    --holes.left;
  }
  return holes;
}

}  // namespace surpass::reconstruction

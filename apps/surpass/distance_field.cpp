#include "distance_field.hpp"

#include <surpass/quality.hpp>
#include <surpass/repair.hpp>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace surpass::cli {

namespace {

constexpr std::size_t kMostVertices = 30000;

// Neighbours share the vertex in the middle of their edge, so that no gap looks like a boundary.
class EdgeMiddles {
 public:
  explicit EdgeMiddles(std::vector<Point>& points) : points_(points) {}

  Index of(Index a, Index b) {
    const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
    const auto [found, is_new] = known_.try_emplace(key, static_cast<Index>(points_.size()));
    if (is_new) {
      Point middle;
      for (std::size_t c = 0; c < 3; ++c) middle[c] = points_[a][c] / 2 + points_[b][c] / 2;
      points_.push_back(middle);
    }
    return found->second;
  }

 private:
  std::vector<Point>& points_;
  std::unordered_map<std::uint64_t, Index> known_;
};

// Every triangle in four of its own plane.
Mesh cut(const Mesh& mesh) {
  Mesh finer;
  finer.points = mesh.points;
  EdgeMiddles middles(finer.points);
  const auto add = [&](Index a, Index b, Index c) {
    finer.face_vertices.insert(finer.face_vertices.end(), {a, b, c});
    finer.face_offsets.push_back(static_cast<Index>(finer.face_vertices.size()));
  };
  finer.face_offsets.assign(1, 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Index ab = middles.of(face[0], face[1]);
    const Index bc = middles.of(face[1], face[2]);
    const Index ca = middles.of(face[2], face[0]);
    add(face[0], ab, ca);
    add(face[1], bc, ab);
    add(face[2], ca, bc);
    add(ab, bc, ca);
  }
  return finer;
}

}  // namespace

Result<Mesh> distance_field(const Mesh& mesh, const Mesh& other, const Context& context) {
  Mesh field = triangulate(mesh).mesh;
  field.channels.clear();
  field.corner_channels.clear();
  field.creases.clear();
  // A triangle brings three half edges, so cutting adds at most three vertices for each.
  while (field.face_count() > 0 &&
         field.points.size() + 3 * std::size_t{field.face_count()} <= 2 * kMostVertices) {
    field = cut(field);
  }
  auto distances = distances_to(field.points, other, context);
  if (!distances) return tl::make_unexpected(distances.error());
  field.channels.push_back({"distance", {"distance"}, std::move(*distances)});
  return field;
}

}  // namespace surpass::cli

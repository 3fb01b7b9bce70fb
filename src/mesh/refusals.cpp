#include "mesh/refusals.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/edge_buckets.hpp"

namespace surpass::refusal {

Error too_large() {
  return {ErrorCode::too_large,
          fmt::format("at most {} vertices and face corners can be held", kMostCorners),
          {}};
}

Error degenerate_face(Index face, std::size_t degree) {
  return {ErrorCode::degenerate_face,
          fmt::format("a face needs at least 3 vertices, this one has {}", degree),
          {.face = face}};
}

Error index_out_of_range(Index face, Index vertex, std::size_t vertex_count) {
  return {ErrorCode::index_out_of_range,
          fmt::format("a face names vertex {}, but there are {}", vertex, vertex_count),
          {.face = face}};
}

Error repeated_vertex(Index face, Index vertex) {
  return {ErrorCode::repeated_vertex,
          "a face names the same vertex twice",
          {.vertex = vertex, .face = face}};
}

Error duplicate_face(Index face, Index first) {
  return {ErrorCode::duplicate_face,
          fmt::format("a face has the same vertices as face {}", first),
          {.face = face}};
}

Error not_finite(Index vertex, const Point& point) {
  return {ErrorCode::not_finite,
          fmt::format("a coordinate is not finite: {} {} {}", point[0], point[1], point[2]),
          {.vertex = vertex}};
}

Error non_manifold_edge(Index face, std::array<Index, 2> edge, Index faces) {
  return {ErrorCode::non_manifold_edge,
          fmt::format("an edge has {} faces; at most 2 can meet at one", faces),
          {.face = face, .edge = edge}};
}

Error inconsistent_orientation(Index face, std::array<Index, 2> edge) {
  return {ErrorCode::inconsistent_orientation,
          "the two faces at an edge run along it in the same direction: one of them is inside out",
          {.face = face, .edge = edge}};
}

Result<void> check_measurable(const Mesh& mesh) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() < 3) {
      return tl::make_unexpected(degenerate_face(f, mesh.face(f).size()));
    }
    for (const Index v : mesh.face(f)) {
      if (v >= mesh.points.size()) {
        return tl::make_unexpected(index_out_of_range(f, v, mesh.points.size()));
      }
      const Point& p = mesh.points[v];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
        return tl::make_unexpected(not_finite(v, p));
      }
    }
  }
  return {};
}

std::optional<Error> FaceCheck::operator()(Index face) {
  const auto vertices = mesh_.face(face);
  if (vertices.size() < 3) return degenerate_face(face, vertices.size());
  for (const Index v : vertices) {
    if (v >= mesh_.points.size()) return index_out_of_range(face, v, mesh_.points.size());
  }
  if (const Index v = repeated(vertices); v != kNone) return repeated_vertex(face, v);
  return std::nullopt;
}

// The smallest vertex that the face names twice, or kNone.
Index FaceCheck::repeated(std::span<const Index> face) {
  constexpr std::size_t kFewCorners = 8;
  Index found = kNone;
  if (face.size() <= kFewCorners) {
    for (std::size_t i = 1; i < face.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (face[i] == face[j]) found = std::min(found, face[i]);
      }
    }
    return found;
  }
  sorted_.assign(face.begin(), face.end());
  std::sort(sorted_.begin(), sorted_.end());
  const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end());
  return twice == sorted_.end() ? kNone : *twice;
}

}  // namespace surpass::refusal

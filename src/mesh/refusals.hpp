// The errors for which a mesh is refused, each worded once: `Topology::build` returns the first,
// `diagnose` collects them all.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

namespace surpass::refusal {

[[nodiscard]] Error too_large();
[[nodiscard]] Error degenerate_face(Index face, std::size_t degree);
[[nodiscard]] Error index_out_of_range(Index face, Index vertex, std::size_t vertex_count);
[[nodiscard]] Error repeated_vertex(Index face, Index vertex);
[[nodiscard]] Error duplicate_face(Index face, Index first);
[[nodiscard]] Error not_finite(Index vertex, const Point& point);
[[nodiscard]] Error non_manifold_edge(Index face, std::array<Index, 2> edge, Index faces);
[[nodiscard]] Error inconsistent_orientation(Index face, std::array<Index, 2> edge);

/// What keeps faces, in any order and direction, from being measured as a surface: too few corners,
/// vertices that are not there, positions that are not finite. O(#corners).
[[nodiscard]] Result<void> check_measurable(const Mesh& mesh);

/// What is wrong with single faces, looked at one after the other.
class FaceCheck {
 public:
  explicit FaceCheck(const Mesh& mesh) : mesh_(mesh) {}
  /// The error of a face by itself, or nullopt. O(k log k) for k corners, O(k) up to 8.
  [[nodiscard]] std::optional<Error> operator()(Index face);

 private:
  [[nodiscard]] Index repeated(std::span<const Index> face);

  const Mesh& mesh_;
  std::vector<Index> sorted_;
};

}  // namespace surpass::refusal

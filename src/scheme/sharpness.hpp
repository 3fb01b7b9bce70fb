// Sharpness of edges and vertices of one refinement level, under OpenSubdiv's rules.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <vector>

namespace surpass {

[[nodiscard]] inline bool is_infinite(float sharpness) { return sharpness >= kInfinitelySharp; }
[[nodiscard]] inline bool is_semi_sharp(float sharpness) {
  return sharpness > 0 && !is_infinite(sharpness);
}

/// Sharpness of the child: one less, in float as OpenSubdiv computes it; infinity stays.
[[nodiscard]] inline float child_sharpness(float sharpness) {
  if (is_infinite(sharpness)) return sharpness;
  return sharpness > 1.0F ? sharpness - 1.0F : 0.0F;
}

/// Effective sharpness: boundary edges, bow-ties and, under edge-and-corner, vertices of exactly
/// one face are infinitely sharp whatever the mesh says.
class Sharpness {
 public:
  /// Fails if a crease names two vertices without an edge, a corner names none, or a sharpness is
  /// negative or NaN.
  static Result<Sharpness> build(const Mesh& mesh, const Topology& topology, Boundary boundary);

  [[nodiscard]] float edge(const Topology& topology, Index e) const {
    if (topology.is_boundary_edge(e)) return kInfinitelySharp;
    return edges_.empty() ? 0.0F : edges_[e];
  }
  [[nodiscard]] float vertex(Index v) const { return vertices_.empty() ? 0.0F : vertices_[v]; }

  /// Neither on the boundary nor touched by a crease or corner: the plain interior rules apply.
  [[nodiscard]] bool is_plain(Index v) const { return plain_.empty() || plain_[v] != 0; }

 private:
  std::vector<float> edges_;          // #E, or empty: all smooth
  std::vector<float> vertices_;       // #V, or empty: all smooth
  std::vector<unsigned char> plain_;  // #V, or empty: all plain
};

}  // namespace surpass

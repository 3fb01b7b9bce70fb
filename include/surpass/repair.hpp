// What is wrong with a mesh, and what can be mended on request. Nothing is mended silently.
#pragma once

#include <surpass/mesh.hpp>

#include <string>
#include <vector>

namespace surpass {

/// What was found by `diagnose`. `refusals` are those for which `Topology::build` would fail.
struct Diagnosis {
  std::vector<Error> refusals;  ///< at most `limit` of each code, in order of face, edge, vertex
  std::vector<std::string>
      remarks;  ///< legal but worth knowing: bow-ties, isolated or coincident vertices
  std::size_t refusal_count = 0;  ///< of all, also those above the limit
};

/// Everything for which the mesh would be refused, and remarks on what is legal but unusual.
/// O(#corners log #corners).
[[nodiscard]] Diagnosis diagnose(const Mesh& mesh, std::size_t limit = 10);

/// A mended mesh and a sentence for each thing that was done.
struct Mended {
  Mesh mesh;
  std::vector<std::string> done;
};

/// In this order: drops faces with fewer than three different vertices and repeats of a face, turns
/// faces so that neighbours agree (each component outward if it is closed: positive volume), and
/// splits what is still non-manifold: vertices are duplicated along edges of more than two faces
/// and along edges whose faces cannot be turned to agree (Moebius bands). Vertices keep their
/// numbers; copies come last. Creases, corners, channels, face sets and holes follow.
[[nodiscard]] Mended repair(const Mesh& mesh);

/// Merges vertices closer than `distance` (absolute, at least 0; 0 merges equal coordinates only)
/// into the one with the smallest number. The others disappear and numbers close up.
/// Channels keep the value of the vertex that stays. Faces that degenerate are left for `repair`.
[[nodiscard]] Result<Mended> weld(const Mesh& mesh, double distance);

/// Cuts every polygon into triangles without new vertices: ears in the polygon's mean plane, convex
/// or concave; triangles stay as they are. Corner channels, face sets and holes follow.
[[nodiscard]] Mended triangulate(const Mesh& mesh);

/// The mesh without the vertices that no face uses; numbers close up.
[[nodiscard]] Mended drop_isolated_vertices(const Mesh& mesh);

}  // namespace surpass

// What is wrong with a mesh, and what can be mended on request. Nothing is mended silently.
#pragma once

#include <surpass/mesh.hpp>

#include <string>
#include <vector>

namespace surpass {

/// What was found by `diagnose`: everything for which `Topology::build` fails, repeated faces, and
/// coordinates that are not finite.
struct Diagnosis {
  std::vector<Error> refusals;  ///< at most `limit` of each code, in order of face, edge, vertex
  std::vector<std::string> remarks;  ///< legal but worth knowing: bow-ties, isolated vertices, ...
  std::size_t refusal_count = 0;     ///< of all, also those above the limit
};

/// Everything for which the mesh would be refused, and remarks on what is legal but unusual.
/// Refusals are in the order of faces, edges and vertices; edges are looked at for the faces that
/// are sound by themselves. O(#corners log #corners).
[[nodiscard]] Diagnosis diagnose(const Mesh& mesh, std::size_t limit = 10);

/// A mended mesh and a sentence for each thing that was done.
struct Mended {
  Mesh mesh;
  std::vector<std::string> done;
};

/// In this order: drops faces with fewer than three different vertices, faces that name a vertex
/// which does not exist, and repeats of a face (same vertices in the same cyclic order, forwards or
/// backwards; two faces that are a closed surface back to back stay); gives vertices that a face
/// names again a copy; turns faces so that neighbours agree, as the majority of each piece does;
/// splits what is still non-manifold: vertices are duplicated along edges of more than two faces
/// and along edges whose faces cannot be turned to agree (Moebius bands); and turns closed pieces
/// outward: positive volume. Vertices keep their numbers; copies come last. A turned face keeps its
/// first corner. Creases, corners, channels, face sets and holes follow. `Topology::build` succeeds
/// on the result. O(#corners log #corners).
[[nodiscard]] Mended repair(const Mesh& mesh);

/// Merges vertices at most `distance` apart (absolute, at least 0; 0 merges equal coordinates
/// only). In order of their numbers, each goes to the first vertex that stays and is close enough,
/// or stays itself; so those that stay are further apart. The others disappear and numbers close
/// up. Channels keep the value of the vertex that stays. Faces that degenerate are left for
/// `repair`. Expected O(#V + #corners). Errors: a distance that is negative or not finite.
[[nodiscard]] Result<Mended> weld(const Mesh& mesh, double distance);

/// Cuts every polygon into triangles without new vertices: ears in the polygon's mean plane, those
/// with the shortest diagonal first, convex or concave; triangles stay as they are. Corner
/// channels, face sets and holes follow. O(k log k) for a convex polygon of k corners, nearly that
/// for usual outlines, O(k^2) for the worst.
[[nodiscard]] Mended triangulate(const Mesh& mesh);

/// The mesh without the vertices that no face uses; numbers close up.
[[nodiscard]] Mended drop_isolated_vertices(const Mesh& mesh);

}  // namespace surpass

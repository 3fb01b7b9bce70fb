// Polygon meshes for tests, among them every special case of the rules at vertices.
#pragma once

#include <string>
#include <vector>

#include "support/meshes.hpp"

namespace surpass::test {

Mesh cube();

/// n-sided prism: bottom ring first; side quads, then the two n-gons.
Mesh prism(Index n);

/// nx by ny points, quads; heights from a small pattern.
Mesh quad_grid(Index nx, Index ny);

/// Two n-gons, back to back: every vertex has two faces. The points do not lie in a plane.
Mesh pillow(Index n);

/// A new vertex on an edge, the last: both faces get a corner more.
Mesh split_edge(const Mesh& mesh, Index a, Index b, const Point& point);

/// A vertex at each face's mean and a face around each vertex of a closed mesh: valence 3
/// everywhere for triangles.
Mesh dual(const Mesh& mesh);

/// Joins faces across random interior edges while faces stay simple polygons that share one edge
/// with each neighbour, and interior vertices keep at least `valence` edges.
Mesh join_faces(const Mesh& mesh, std::mt19937_64& random, std::size_t tries, Index valence = 3);

/// random_mesh with joined faces.
Mesh random_polygons(const RandomShape& shape, Index valence = 3);

/// random_mesh in faces that the scheme takes.
inline Mesh random_mesh_for(Scheme scheme, const RandomShape& shape) {
  return scheme == Scheme::loop ? random_mesh(shape) : random_polygons(shape);
}

/// A mesh with a name for messages.
struct Sample {
  std::string name;
  Mesh mesh;
  bool has_normals = true;  ///< false with tips, and where two sides of the surface coincide
};

/// Closed, open, creased, with darts, tips, bow-ties, doublets; faces of three and more sides.
/// Sharp elements are infinitely sharp.
std::vector<Sample> polygon_samples();

}  // namespace surpass::test

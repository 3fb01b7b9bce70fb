// Open meshes as Lai and Cheng 2006, section 3, have them: a ring of dummy faces goes around each
// boundary, so that the given vertices on it are inside.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <span>
#include <vector>

namespace surpass {

/// The given mesh with a dummy vertex at every visit of a boundary loop, and a quad outside every
/// boundary edge.
struct ExtendedMesh {
  Mesh mesh;              ///< the given vertices and faces first; without vertex channels
  std::vector<Index> at;  ///< #dummies: the given vertex where each starts
};

/// Where exactly one crease ends at a boundary vertex it goes on to its dummy.
[[nodiscard]] ExtendedMesh with_dummy_ring(const Mesh& given, const Topology& topology);

/// What is left of the refined extended mesh: of its two rings of dummy faces the inner one, which
/// becomes hole faces. The outer one has no influence on the rest.
struct DummyParts {
  Mesh mesh;                           ///< faces of the given mesh first, then the hole faces
  std::vector<Index> kept;             ///< #V: its vertices' numbers in the refined extended mesh
  std::vector<unsigned char> sampled;  ///< #F: 1 where the face is one of the surface
};
[[nodiscard]] DummyParts without_outer_ring(Mesh refined, const Mesh& given);

}  // namespace surpass

// How far each place of a mesh is from another mesh, to be coloured.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/result.hpp>

namespace surpass::cli {

/// The faces of `mesh` as triangles, cut finer while there are at most some 30,000 vertices, with
/// the distance of every vertex to the nearest point of `other` in the vertex channel "distance":
/// in the meshes' unit. The given vertices come first. Costs a search for each vertex; errors: as
/// distances_to.
[[nodiscard]] Result<Mesh> distance_field(const Mesh& mesh, const Mesh& other,
                                          const Context& context);

}  // namespace surpass::cli

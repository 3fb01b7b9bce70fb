// Connectivity of schemes that cut each triangle into four.
#pragma once

#include <surpass/context.hpp>
#include <surpass/topology.hpp>

namespace surpass {

/// The mesh with a vertex for each vertex, then one for each edge, and all that it inherits;
/// without positions and vertex channels. Child faces: those at the three corners, then the middle
/// one.
[[nodiscard]] Result<Mesh> quartered_triangles(const Mesh& mesh, const Topology& topology,
                                               const Context& context);

}  // namespace surpass

// Normals to shade with, one per face corner, so that they can differ on both sides of a crease.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <vector>

#include "render/vector.hpp"

namespace surpass::picture {

/// The normal of each corner's face, from its area vector: flat facets.
[[nodiscard]] std::vector<Vec3> facet_normals(const Mesh& mesh, const Context& context = {});

/// Smooth normals. At each vertex the faces between two hard edges (boundaries and creases) share
/// one: the vertex channel "normal" where it has a direction and the faces are all faces of the
/// vertex, else the mean of the face normals weighted by the angle at the vertex. Without that
/// channel edges that turn by more than `crease_angle` (degrees) are hard, too.
[[nodiscard]] std::vector<Vec3> smooth_normals(const Mesh& mesh, const Topology& topology,
                                               double crease_angle, const Context& context = {});

}  // namespace surpass::picture

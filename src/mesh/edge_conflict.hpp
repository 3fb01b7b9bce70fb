// Which edge keeps a mesh from being an oriented manifold.
#pragma once

#include <surpass/mesh.hpp>

namespace surpass {

/// The error of the first edge, in the order in which edges are numbered, that has more than two
/// faces, or two that run along it in the same direction. There must be one, and the faces must be
/// sound by themselves. O(#corners log #corners).
[[nodiscard]] Error edge_conflict(const Mesh& mesh);

}  // namespace surpass

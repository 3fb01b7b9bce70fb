// What is legal in a mesh, but worth knowing.
#pragma once

#include <surpass/topology.hpp>

#include <span>
#include <string>
#include <vector>

namespace surpass {

/// Sentences on isolated and coincident vertices, zero-area faces, zero-length edges, and
/// coordinates that a computation may stumble over. Faces f with skip[f] != 0 are
/// left out. On bow-ties, faces back to back and creases off the edges only where the mesh has a
/// topology, else nullptr. Up to `limit` elements are named in each. Expected O(#corners).
[[nodiscard]] std::vector<std::string> remarks_on(const Mesh& mesh, const Topology* topology,
                                                  std::span<const unsigned char> skip,
                                                  std::size_t limit);

}  // namespace surpass

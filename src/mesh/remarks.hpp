// What is legal in a mesh, but worth knowing.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <string>
#include <vector>

namespace surpass {

/// Sentences on isolated and coincident vertices, zero-area faces, zero-length edges, creases off
/// the edges, and coordinates that a computation may stumble over. Faces f with skip[f] != 0 are
/// left out. If the mesh is sound, on bow-ties and faces back to back as well. Up to `limit`
/// elements are named in each. Expected O(#corners).
[[nodiscard]] std::vector<std::string> remarks_on(const Mesh& mesh,
                                                  std::span<const unsigned char> skip,
                                                  std::size_t limit);

}  // namespace surpass

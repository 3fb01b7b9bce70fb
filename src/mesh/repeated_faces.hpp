// Faces that a mesh holds more than once.
#pragma once

#include <span>
#include <vector>

#include "mesh/edge_table.hpp"

namespace surpass {

/// A face with the same vertices in the same cyclic order, forwards or backwards, as an earlier
/// one.
struct RepeatedFace {
  Index face;
  Index first;  ///< the earliest face with this cycle
};

/// All repeats, ascending by face. Faces f with skip[f] != 0 are left out; `skip` may be empty.
/// O(#corners + #F log #F).
[[nodiscard]] std::vector<RepeatedFace> find_repeated_faces(
    const Mesh& mesh, std::span<const unsigned char> skip = {});

/// True if a repeated face and its first one lie back to back with no other face at their edges:
/// a closed surface without volume, which is legal.
[[nodiscard]] bool is_back_to_back(const Mesh& mesh, const EdgeTable& edges, Index repeated_face);

}  // namespace surpass

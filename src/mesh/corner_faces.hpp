#pragma once

#include <surpass/mesh.hpp>

namespace surpass {

/// The face of each corner.
[[nodiscard]] std::vector<Index> corner_faces(const Mesh& mesh);

}  // namespace surpass

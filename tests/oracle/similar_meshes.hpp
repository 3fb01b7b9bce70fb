// Similarity and fair interpolation of whole meshes, judged by OpenSubdiv.
#pragma once

#include "support/meshes.hpp"

namespace surpass::test {

/// Expects every form to meet the given vertices to 1e-12, at no and at all iterations; on open
/// meshes under both boundary rules and inside a dummy ring. False where the mesh is refused, which
/// must be because it is not manifold.
bool is_interpolated_by_similarity(const Mesh& given);

/// How many of the files' meshes are.
int interpolated_by_similarity(const std::vector<std::string>& paths);

}  // namespace surpass::test

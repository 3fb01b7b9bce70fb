// Curvature to look at: an estimate at every vertex of a surface that comes as a fine mesh.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <vector>

namespace surpass {

/// Per vertex; both are positive where the surface is curved like a sphere seen from outside: it
/// bends away from its normal.
struct VertexCurvatures {
  std::vector<double> mean;   ///< #V, (k1 + k2) / 2 in 1 / length
  std::vector<double> gauss;  ///< #V, k1 k2 in 1 / length^2
};

/// For a mesh with vertex normals in channel "normal", as `limit_mesh` makes them. At each vertex,
/// the symmetric map from steps in the tangent plane to turns of the normal that fits the edges
/// there best. With the exact normals of a limit surface the error falls by about 4 with each
/// refinement where the mesh is regular, by 2 elsewhere; on creases, where a normal is a mean, the
/// numbers are as large as the edges are short. 0 where a vertex has no normal or edges in one
/// direction only.
///
/// For integrals and figures to rely on there is `fairness`, by exact derivatives. O(#corners).
/// Errors: `invalid_argument` without such normals, those of Topology::build, `cancelled`.
[[nodiscard]] Result<VertexCurvatures> vertex_curvatures(const Mesh& surface,
                                                         const Context& context = {});

}  // namespace surpass

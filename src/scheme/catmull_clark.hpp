// Catmull-Clark subdivision on whole meshes of any polygons: limit operator, refinement, normals.
#pragma once

#include "scheme/subdivision_scheme.hpp"

namespace surpass::catmull_clark {

Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, Boundary boundary,
                                     const Context& context);

/// Refined vertices: the given ones, then one per edge, then one per face.
Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, Boundary boundary,
                              const Context& context);

Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                         Boundary boundary, const Context& context);

[[nodiscard]] const SubdivisionScheme& scheme();

}  // namespace surpass::catmull_clark

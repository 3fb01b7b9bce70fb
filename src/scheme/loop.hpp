// Loop subdivision on whole meshes: limit operator, refinement, normals.
#pragma once

#include "scheme/subdivision_scheme.hpp"

namespace surpass::loop {

Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, Boundary boundary,
                                     const Context& context);

Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, Boundary boundary,
                              const Context& context);

Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                         Boundary boundary, const Context& context);

[[nodiscard]] const SubdivisionScheme& scheme();

}  // namespace surpass::loop

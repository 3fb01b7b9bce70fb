// Loop subdivision on whole meshes: limit operator, refinement, normals.
#pragma once

#include "scheme/limit_operator.hpp"

namespace surpass::loop {

Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, Boundary boundary,
                                     const Context& context);

Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, Boundary boundary,
                              const Context& context);

Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                         Boundary boundary, const Context& context);

}  // namespace surpass::loop

// One refinement step, by everybody who can: from a mesh, and again with what has been prepared.
#pragma once

#include <string>

#include "refined.hpp"

namespace surpass::bench {

/// The name of a step under a scheme.
[[nodiscard]] std::string step_name(const char* what, Scheme scheme);

void add_refinement(Harness& harness, Index side);
void add_openmesh_refinement(Harness& harness, Index side);
void add_cgal_refinement(Harness& harness, Index side);
void add_opensubdiv_refinement(Harness& harness, Index side);

}  // namespace surpass::bench

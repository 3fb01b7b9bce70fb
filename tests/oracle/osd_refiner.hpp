// A mesh as OpenSubdiv takes it.
#pragma once

#include <memory>

#include <opensubdiv/far/topologyRefiner.h>

#include "support/meshes.hpp"

namespace surpass::test {

/// Uniformly refined.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> osd_refiner(const Mesh& mesh, const Rules& rules,
                                                              int levels);

}  // namespace surpass::test

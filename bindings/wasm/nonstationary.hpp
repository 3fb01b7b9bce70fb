// The scheme that interpolates by itself, for the page.
#pragma once

#include <surpass/context.hpp>
#include <surpass/nonstationary.hpp>
#include <surpass/topology.hpp>

#include <emscripten/val.h>

namespace surpass::wasm {

/// {lowest, highest, round, standard, flat}: the shape parameters that the mesh allows, and those
/// that have names.
[[nodiscard]] emscripten::val shapes_of(const Mesh& mesh, const Topology& topology);

/// The mesh refined so often. Errors: as NonstationaryLoop::create, too_large.
[[nodiscard]] Result<NonstationaryLoop> refined_by_itself(const Mesh& mesh,
                                                          const NonstationaryOptions& options,
                                                          int levels, const Context& context);

}  // namespace surpass::wasm

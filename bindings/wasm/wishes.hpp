// What the page asks for, from a JavaScript object.
#pragma once

#include <surpass/interpolate.hpp>
#include <surpass/nonstationary.hpp>
#include <surpass/similarity.hpp>

#include <optional>
#include <string>

#include <emscripten/val.h>

namespace surpass::wasm {

/// How to find the control mesh, and how finely to show its surface.
struct Wishes {
  std::string method = "progressive";  ///< or "similarity", "fair"
  InterpolateOptions progressive = {};
  SimilarityOptions similar = {};
  /// The scheme that interpolates by itself; the rules of the others are then those of the plain
  /// surface beside it.
  std::optional<NonstationaryOptions> nonstationary = {};
  int levels = 2;  ///< refinements of the shown surfaces, from the given mesh on
};

/// {scheme, boundary, method, solver, tolerance, maxIterations, tension, shape, levels}; what is
/// not there stays as it is in the library. `tension`, 0 to 1, is the membrane's share of the
/// energy under `fair`, `shape` the shape parameter of the scheme "nonstationary-loop". Errors:
/// names that the library does not know.
[[nodiscard]] Result<Wishes> read_wishes(const emscripten::val& from);

}  // namespace surpass::wasm

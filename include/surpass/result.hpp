// Errors are values: every function that can fail returns a Result. No exception leaves the
// library.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace surpass {

/// Number of a vertex, face, edge or face corner, counted from 0.
using Index = std::uint32_t;

/// "There is none": no neighbour across a boundary edge, no texture coordinate at a corner.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

/// What went wrong. The group decides the exit code of the command line (see `exit_status`).
enum class ErrorCode {
  // The caller asked for something that cannot be meant.
  invalid_argument,
  not_built_in,  ///< the component is not part of this build
  // The bytes or the text of a file.
  cannot_open,
  cannot_read,
  unknown_format,
  syntax,              ///< a word or byte that the format does not allow here
  unexpected_end,      ///< the file stops before what it announces
  bad_number,          ///< not a number, or out of the range of a double
  not_finite,          ///< NaN or infinity
  index_out_of_range,  ///< a face names a vertex that does not exist
  unsupported,         ///< legal in the format, but nothing this library can hold
  // The mesh that they describe.
  empty_mesh,
  non_manifold_edge,
  inconsistent_orientation,
  repeated_vertex,
  degenerate_face,
  duplicate_face,
  too_large,
  unsuitable_for_scheme,
  singular,       ///< the interpolation problem has no solution, or more than one
  contradictory,  ///< no surface meets all that is required of it
  mismatch,       ///< two meshes that should have the same vertices have not
  // The computation and its output.
  not_converged,
  cancelled,
  cannot_write,
};

/// Where it went wrong: a place in a file, an element of a mesh, or both. Unset parts are nullopt.
struct Place {
  std::string file = {};
  std::optional<std::uint64_t> line = {};    ///< from 1
  std::optional<std::uint64_t> column = {};  ///< from 1, in bytes
  std::optional<std::uint64_t> byte = {};    ///< from 0, for binary files
  std::optional<Index> vertex = {};
  std::optional<Index> face = {};
  std::optional<std::array<Index, 2>> edge = {};  ///< its end vertices
};

/// An error: a code for programs, a sentence for people, a place for both.
struct Error {
  ErrorCode code = ErrorCode::invalid_argument;
  std::string message = {};
  Place place = {};
};

/// A value or an Error.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function with a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message,
                                                Place place = {}) {
  return tl::make_unexpected(Error{code, std::move(message), std::move(place)});
}

/// The code's name as written in reports, such as "non-manifold-edge".
[[nodiscard]] const char* name_of(ErrorCode code);

/// `file:line:column: message (face 3, edge 4-7)`, with the parts that are known.
[[nodiscard]] std::string describe(const Error& error);

}  // namespace surpass

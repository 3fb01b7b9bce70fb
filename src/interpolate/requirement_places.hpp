// Where requirements are, on the given mesh refined once.
#pragma once

#include <surpass/requirements.hpp>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace surpass {

struct LocatedRequirement {
  SurfacePlace place;           ///< on the refined mesh
  std::array<double, 2> along;  ///< by its parameters
};

/// The same requirements in one way of saying them: what has no meaning where they are is left out,
/// and lengths without a meaning are 1. Those of normals, directions and, at places, of the
/// directions of derivatives; a derivative is divided by the last. Numbers that
/// check_requirements() refuses stay.
[[nodiscard]] std::vector<Requirement> canonical(std::span<const Requirement> requirements);

/// Of canonical requirements. Fails where check_requirements() does.
[[nodiscard]] Result<std::vector<LocatedRequirement>> located_requirements(
    const Mesh& given, std::span<const Requirement> requirements);

/// An error that names the requirement, its number and its place.
[[nodiscard]] tl::unexpected<Error> refuse_requirement(
    const Requirement& r, std::size_t number, std::string_view why,
    ErrorCode code = ErrorCode::invalid_argument);

/// The corner of its face that a place lies in; kNone elsewhere.
[[nodiscard]] inline Index corner_at(const SurfacePlace& place) {
  const auto is_at = [&](double u, double v) { return place.u == u && place.v == v; };
  if (place.corner != kNone) return is_at(0, 0) ? place.corner : kNone;
  return is_at(0, 0) ? 0 : is_at(1, 0) ? 1 : is_at(1, 1) ? 2 : is_at(0, 1) ? 3 : kNone;
}

/// "3 (normal at vertex 7), 5 (...) and 33 more: 7, 9-40": of ascending numbers, all of them, of
/// which six are described.
[[nodiscard]] std::string names_of(std::span<const std::size_t> numbers,
                                   std::span<const Requirement> requirements);

}  // namespace surpass

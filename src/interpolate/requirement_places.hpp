// Where requirements are, on the given mesh refined once.
#pragma once

#include <surpass/requirements.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace surpass {

struct LocatedRequirement {
  SurfacePlace place;           ///< on the refined mesh
  std::array<double, 2> along;  ///< by its parameters
};

/// Fails where check_requirements() does.
[[nodiscard]] Result<std::vector<LocatedRequirement>> located_requirements(
    const Mesh& given, std::span<const Requirement> requirements);

/// An error that names the requirement, its number and its place.
[[nodiscard]] tl::unexpected<Error> refuse_requirement(
    const Requirement& r, std::size_t number, std::string_view why,
    ErrorCode code = ErrorCode::invalid_argument);

}  // namespace surpass

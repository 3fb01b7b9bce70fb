// Contradictions that equations do not see. A normal and a direction say that something vanishes,
// and tangents of length 0 do all of that: two normals at one place would be met by a surface that
// has no plane there.
#pragma once

#include <set>

#include "interpolate/requirement_rows.hpp"

namespace surpass {

/// Fails with `contradictory`, naming two requirements whose places have the same tangents: normals
/// that differ by more than 1e-9 (radians, for all of this), a direction or derivative that does
/// not lie across a normal, directions and derivatives along one line that differ or are opposite,
/// and a derivative of length 0 beside a normal or direction. Of `equations` only `along` and
/// `repeated` need be there. O(n) where no two share a place.
[[nodiscard]] Result<void> check_tangents(std::span<const Requirement> requirements,
                                          std::span<const SurfaceStencil> stencils,
                                          const RequirementRows& equations);

/// Of each requirement the first one of tangents at the same place, itself for other kinds.
[[nodiscard]] std::vector<std::size_t> first_there(std::span<const Requirement> requirements,
                                                   std::span<const SurfaceStencil> stencils);

/// Fails with `contradictory`, naming them, if three or more at one place exclude each other only
/// together: whatever tangents do all of it, those of one have no length, or of a normal no plane.
[[nodiscard]] Result<void> check_places(std::span<const Requirement> requirements,
                                        const RequirementRows& equations);

/// Normals and directions at places where `control`'s surface has tangents of no length or no
/// plane, or next to none of those of `reference`, if there is one and no derivative is asked, so
/// that equations say nothing: the numbers of those at the first such place. `side` of the box.
[[nodiscard]] std::vector<std::size_t> without_tangents(std::span<const Requirement> requirements,
                                                        const RequirementRows& equations,
                                                        std::span<const Point> control,
                                                        std::span<const Point> reference,
                                                        double side);

/// Fails with `contradictory`, naming all requirements of tangents there and `opposed` ones, where
/// normals and directions are met only because their tangents have no length or no plane on the
/// final surface, `control`.
[[nodiscard]] Result<void> check_planes(std::span<const Requirement> requirements,
                                        const RequirementRows& equations,
                                        std::span<const Point> control,
                                        std::span<const Point> reference, double side,
                                        const std::set<std::size_t>& opposed);

}  // namespace surpass

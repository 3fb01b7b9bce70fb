// Tangents that would vanish or go the other way. What normals and directions ask is also done by
// tangents of length 0 or of the opposite sign, and the least change makes them just that where the
// wish lies across the surface as it is: an upright direction in a flat sheet. There the tangents
// are chosen: those of the reference, turned to what is asked.
#pragma once

#include "interpolate/requirement_rows.hpp"

namespace surpass {

/// Adds rows that give lengths to the tangents of those normals and directions that vanish on
/// `control`'s surface, or are opposite there, and have none yet: a direction's tangent is as long
/// as the reference's there, a normal's two are the reference's, turned by the least rotation that
/// takes normal to normal and then about the normal to the first direction or derivative that is
/// required in their plane. What else is required at the place is respected: the tangents are the
/// nearest that do all of it. Where the reference has no tangents they are as long as its points
/// are wide there. Returns whether there were any. O(#requirements) where nothing needs them.
[[nodiscard]] bool add_tangent_lengths(std::span<const Requirement> requirements,
                                       std::span<const Point> control,
                                       std::span<const Point> reference,
                                       RequirementRows& equations);

}  // namespace surpass

// The same certificate by an evaluator that is not ours: OpenSubdiv. Library surpass::oracle.
#pragma once

#include <surpass/quality.hpp>

namespace surpass {

/// #V limit positions by OpenSubdiv in double precision: its limit masks after one refinement of
/// the mesh. At darts, and at interior vertices of valence 2 on Catmull-Clark surfaces, its mask is
/// not the limit of its own refined points, so there, and where creases are semi-sharp, its refined
/// points themselves are followed to the limit; `notes` says how often. Errors: as
/// opensubdiv_knows, a topology that it refuses.
[[nodiscard]] Result<std::vector<Point>> opensubdiv_limit_positions(
    const Mesh& control, const Rules& rules, std::vector<std::string>* notes = nullptr);

/// Error `invalid_argument` for a scheme or boundary rule that OpenSubdiv lacks.
[[nodiscard]] Result<void> opensubdiv_knows(const Rules& rules);

/// certify() with OpenSubdiv as the evaluator.
[[nodiscard]] Result<Certificate> certify_with_opensubdiv(const Mesh& control,
                                                          std::span<const Point> given,
                                                          const Rules& rules);

/// "OpenSubdiv 3.5.0".
[[nodiscard]] std::string opensubdiv_version();

}  // namespace surpass

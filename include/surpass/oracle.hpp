// The same certificate by an evaluator that is not ours: OpenSubdiv. Library surpass::oracle.
#pragma once

#include <surpass/quality.hpp>

namespace surpass {

/// #V limit positions by OpenSubdiv's refiner in double precision. `notes` receives what was done
/// otherwise: at darts OpenSubdiv's limit mask is inexact, so there its refined points are combined
/// with the exact mask. Errors: a scheme or boundary rule that OpenSubdiv lacks
/// (`invalid_argument`), a topology that it refuses.
[[nodiscard]] Result<std::vector<Point>> opensubdiv_limit_positions(
    const Mesh& control, const Rules& rules, std::vector<std::string>* notes = nullptr);

/// certify() with OpenSubdiv as the evaluator.
[[nodiscard]] Result<Certificate> certify_with_opensubdiv(const Mesh& control,
                                                          std::span<const Point> given,
                                                          const Rules& rules);

/// "OpenSubdiv 3.5.0".
[[nodiscard]] std::string opensubdiv_version();

}  // namespace surpass

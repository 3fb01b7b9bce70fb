// What `surpass interpolate --html` shows: given mesh, control mesh and both limit surfaces, and
// how the paper's solver and the faster one converge.
#pragma once

#include <surpass/interpolate.hpp>

#include "html_report.hpp"

namespace surpass::cli {

/// `rivals` are the options to run both solvers with, or nothing where the method has no such.
[[nodiscard]] Result<void> add_interpolation(HtmlReport& page, const Mesh& given,
                                             const Mesh& control, const Rules& rules,
                                             const InterpolateOptions* rivals,
                                             const Session& session);

}  // namespace surpass::cli

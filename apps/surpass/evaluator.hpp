// Certificates for commands: by our own evaluator, and by OpenSubdiv's where it is built in.
#pragma once

#include <surpass/quality.hpp>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// --oracle.
void add_oracle(Options& options, bool& oracle);

/// Fails early where --oracle cannot be served: not built in, or a rule that OpenSubdiv lacks.
[[nodiscard]] Result<void> check_oracle(bool oracle, const Rules& rules);

/// certify_with_opensubdiv, or `not_built_in`.
[[nodiscard]] Result<Certificate> certify_by_oracle(const Mesh& control,
                                                    std::span<const Point> given,
                                                    const Rules& rules);

[[nodiscard]] Json certificate_json(const Certificate& certificate);

}  // namespace surpass::cli

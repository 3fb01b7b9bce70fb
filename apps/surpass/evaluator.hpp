// Certificates by OpenSubdiv's evaluator, for commands. It takes longer to load than a small mesh
// to interpolate, so there are two programs of the same commands: `surpass`, linked with
// no_oracle.cpp, becomes `surpass-oracle`, linked with oracle.cpp, where it is asked for
// OpenSubdiv.
#pragma once

#include <surpass/quality.hpp>

#include <optional>
#include <string>
#include <vector>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// --oracle.
void add_oracle(Options& options, bool& oracle);

/// "OpenSubdiv 3.5.0", the name of the program that has it, or "not built in".
[[nodiscard]] std::string oracle_version();

/// Fails early where --oracle cannot be served: not built in, or a rule that OpenSubdiv lacks.
[[nodiscard]] Result<void> check_oracle(bool oracle, const Rules& rules);

/// certify_with_opensubdiv, or `not_built_in`.
[[nodiscard]] Result<Certificate> certify_by_oracle(const Mesh& control,
                                                    std::span<const Point> given,
                                                    const Rules& rules);

/// Where what follows `surpass` is for the program that has OpenSubdiv, and this is not the one:
/// becomes it. Returns where there is no such program beside this one; an exit code where there is
/// one that cannot be started, and then has said so.
std::optional<int> become_oracle_if_asked(const std::vector<std::string>& words);

[[nodiscard]] Json certificate_json(const Certificate& certificate);

}  // namespace surpass::cli

// What a reconstruction found, as JSON and as lines for people.
#pragma once

#include <surpass/interpolate.hpp>
#include <surpass/reconstruct.hpp>

#include "session.hpp"

namespace surpass::cli {

[[nodiscard]] Json reconstruction_json(const ReconstructReport& r);

/// Relative to `box_side`.
[[nodiscard]] Json limit_distances_json(const LimitDistances& distances, double box_side);

[[nodiscard]] std::string summary(const ReconstructReport& r, const Mesh& mesh);
[[nodiscard]] std::string summary(const LimitDistances& distances, double box_side);

}  // namespace surpass::cli

// What the report says of a finished mesh.
#pragma once

#include <surpass/reconstruct.hpp>

namespace surpass::reconstruction {

/// Spacings: above it the vertices are the smoothed points, and a warning comes.
inline constexpr double kMuchNoise = 0.3;

/// Creases, corners, pieces, boundary loops and the genus.
void count_parts(const Mesh& mesh, ReconstructReport& report);

/// Warnings that help: sheets that may be joined, noise, points that are not used, and more
/// `vertices` than were wanted.
void add_warnings(double share_of_sheets, std::optional<Index> wanted, Index vertices,
                  ReconstructReport& report);

}  // namespace surpass::reconstruction

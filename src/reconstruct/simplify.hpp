// Fewer vertices, each of them one that was there.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/quality.hpp>

#include <optional>
#include <vector>

#include "reconstruct/features.hpp"

namespace surpass::reconstruction {

struct SimplifyLimits {
  /// No collapse of higher cost, the sum of squared distances of the vertex that stays to the
  /// planes that it stands for.
  std::optional<double> cost = {};
  std::optional<Index> vertices = {};  ///< stop at this many
};

/// Half-edge collapses of a manifold, oriented triangle mesh in the order of their plane quadrics:
/// one of two neighbours stays where it is, the other disappears, so vertices keep their positions
/// bit for bit. Refused are collapses that would change the topology, turn a face over by more than
/// some 75 degrees, make an angle below 10 degrees (unless there was a smaller one), a valence
/// above 10 or an edge above twice the mean edge that the result will have. Without these
/// guards flat places become fans of slivers, whose interpolants wave. `features` become
/// those of the result. Vertices that are no longer used stay in the mesh's points; faces keep
/// their order. One thread, O(#V log #V). Error: cancelled.
[[nodiscard]] Result<Mesh> simplify(const Mesh& mesh, Features& features,
                                    const SimplifyLimits& limits, const Context& context);

struct Simplified {
  Mesh mesh;
  Features features;
  PointDistances distances;  ///< of the vertices that there were
};

/// Simplifies until no vertex that there was would be further from the mesh than `tolerance`, or to
/// so many vertices, whichever is first. The tolerance is kept by measurement: where a simplified
/// mesh exceeds it, a lower cost is tried, and in the end the mesh stays as it is. Error:
/// cancelled.
[[nodiscard]] Result<Simplified> simplify_and_measure(const Mesh& mesh, const Features& features,
                                                      std::optional<double> tolerance,
                                                      std::optional<Index> vertices,
                                                      const Context& context);

}  // namespace surpass::reconstruction

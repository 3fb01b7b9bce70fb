#include <cmath>

#include "reconstruct/simplify.hpp"

namespace surpass::reconstruction {

Result<Simplified> simplify_and_measure(const Mesh& mesh, const Features& features,
                                        std::optional<double> tolerance,
                                        std::optional<Index> vertices, const Context& context) {
  constexpr int kTries = 6;
  constexpr double kRounding = 1e-14;  // of the distances, in a box of side 1
  SimplifyLimits limits = {.vertices = vertices};
  if (tolerance) limits.cost = *tolerance * *tolerance;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    Simplified found{{}, features, {}};
    Result<Mesh> simple = simplify(mesh, found.features, limits, context);
    if (!simple) return tl::make_unexpected(simple.error());
    const Result<PointDistances> distances = point_distances(mesh.points, *simple, context);
    if (!distances) return tl::make_unexpected(distances.error());
    if (!tolerance || distances->max <= *tolerance - kRounding) {
      found.mesh = std::move(*simple);
      found.distances = *distances;
      return found;
    }
    *limits.cost *= std::pow(0.7 * *tolerance / distances->max, 2);
  }
  return Simplified{mesh, features, {}};
}

}  // namespace surpass::reconstruction

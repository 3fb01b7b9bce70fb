// A limit surface with its curvature, and the part of it that fairness measures are taken over.
#pragma once

#include <surpass/fairness.hpp>

#include <functional>
#include <vector>

#include "parallel/parallel.hpp"
#include "quality/surface_curvature.hpp"

namespace surpass {

/// Lengths in here are divided by `unit`, so that no coordinate is too large or too small.
struct SampledSurface {
  Point origin = {};
  double unit = 1;  ///< a power of 2: dividing by it changes no bit
  int levels = 1;
  LimitSamples samples;
  std::vector<SurfaceCurvature> curvature;  ///< #V, where usable
  std::vector<unsigned char> usable;        ///< #V: has a curvature and is in no ring left out
  std::size_t degenerate_samples = 0;

  [[nodiscard]] Point place_of(Index sample) const {
    const Eigen::Vector3d& p = samples.jets[sample].position;
    return {origin[0] + p[0] * unit, origin[1] + p[1] * unit, origin[2] + p[2] * unit};
  }
};

/// From the mesh in a box around the origin, of a side between 1 and 4.
using MakeSamples = std::function<Result<LimitSamples>(const Mesh& framed)>;

/// Errors as `fairness`, but for nothing to measure.
[[nodiscard]] Result<SampledSurface> sample_surface(const Mesh& control, int levels, int rings,
                                                    const Context& context,
                                                    const MakeSamples& make);
[[nodiscard]] Result<SampledSurface> sample_surface(const Mesh& control, const Rules& rules,
                                                    int levels, int rings, const Context& context);

/// The patches whose samples are all usable.
struct MeasuredPart {
  std::vector<double> measure;  ///< #V: area of parameters around each sample, 0 where not measured
  FairnessCoverage coverage;    ///< in the units of the mesh
};

/// Error `unsuitable_for_scheme` if there is no such patch.
[[nodiscard]] Result<MeasuredPart> measured_part(const SampledSurface& surface,
                                                 const std::vector<unsigned char>& usable,
                                                 int rings, const Context& context);

/// The sum of value(v) over all samples, times the area around each. Adding goes chunk by chunk, in
/// order.
template <class Sum, class Value>
[[nodiscard]] Sum integrate(const SampledSurface& surface, const MeasuredPart& part,
                            const Sum& zero, const Context& context, Value&& value) {
  return parallel::reduce(
      context, part.measure.size(), zero,
      [&](std::size_t begin, std::size_t end) {
        Sum sum = zero;
        for (std::size_t v = begin; v < end; ++v) {
          if (part.measure[v] <= 0) continue;
          const double area = part.measure[v] * surface.curvature[v].area_element;
          sum += area * value(static_cast<Index>(v));
        }
        return sum;
      },
      [](const Sum& a, const Sum& b) { return Sum(a + b); });
}

}  // namespace surpass

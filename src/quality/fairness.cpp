#include <surpass/fairness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quality/curvature_variation.hpp"
#include "quality/sampled_surface.hpp"
#include "scheme/nonstationary_samples.hpp"

namespace surpass {
namespace {

// Integrals of one, k1^2 + k2^2 and k1 k2; the thin plate's is over parameters.
void integrate_curvature(const SampledSurface& surface, const MeasuredPart& part,
                         const Context& context, Fairness& found) {
  using Sums = Eigen::Vector3d;
  const Sums sums = integrate(surface, part, Sums(Sums::Zero()), context, [&](Index v) {
    const SurfaceCurvature& c = surface.curvature[v];
    const LimitJet& jet = surface.samples.jets[v];
    const double plate = jet.uu.squaredNorm() + 2 * jet.uv.squaredNorm() + jet.vv.squaredNorm();
    return Sums(c.square(), c.gauss(), plate / c.area_element);
  });
  found.bending = sums[0];
  found.total_gauss = sums[1];
  // A level halves the parameters: second derivatives in those of the control mesh are 4 times
  // those of its refined mesh, squares 16 times, and an area of parameters is a quarter.
  found.thin_plate = std::ldexp(sums[2], 2 * surface.levels) * surface.unit * surface.unit;
  const double parameters = std::accumulate(part.measure.begin(), part.measure.end(), 0.0);
  const double area = part.coverage.measured_area / surface.unit / surface.unit;
  found.thin_plate_relative = sums[2] * parameters / area;
}

// Sharpest samples first, until they make a hundredth of the area.
void find_extremes(const SampledSurface& surface, const MeasuredPart& part, Fairness& found) {
  constexpr double kSharpest = 0.01;
  std::vector<Index> order;
  for (Index v = 0; v < part.measure.size(); ++v) {
    if (part.measure[v] > 0) order.push_back(v);
  }
  const auto sharpness = [&](Index v) { return surface.curvature[v].largest(); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(-sharpness(a), a) < std::pair(-sharpness(b), b);
  });
  const double hundredth = kSharpest * part.coverage.measured_area / surface.unit / surface.unit;
  const auto area_at = [&](Index v) { return part.measure[v] * surface.curvature[v].area_element; };
  double area = 0;
  std::size_t k = 0;
  for (; k + 1 < order.size(); ++k) {
    area += area_at(order[k]);
    if (area >= hundredth) break;
  }
  // The sample that the limit goes through belongs to the rest.
  for (std::size_t i = order.size(); i-- > k;) {
    found.trimmed_bending += area_at(order[i]) * surface.curvature[order[i]].square();
  }
  found.largest_curvature = sharpness(order.front()) / surface.unit;
  found.largest_at = surface.place_of(order.front());
  found.high_curvature = sharpness(order[k]) / surface.unit;
}

}  // namespace

namespace {

// Hole faces make no patches: a ring of them would make a mesh look finer than it is.
double visible_corners(const Mesh& mesh) {
  std::size_t hidden = 0;
  for (const Index f : mesh.hole_faces) hidden += mesh.face(f).size();
  return std::max(1.0, static_cast<double>(mesh.corner_count() - hidden));
}

}  // namespace

int fairness_levels(const Mesh& control) {
  constexpr double kEnough = 200'000;
  constexpr double kMost = 8'000'000;
  constexpr int kFewest = 3;
  // The first refinement makes a face or so of each corner, further ones four of each face. Hole
  // faces are refined, too, and take as much memory.
  double patches = visible_corners(control);
  double faces = std::max(1.0, static_cast<double>(control.corner_count()));
  int levels = 1;
  while ((levels < kFewest || patches < kEnough) && 4 * faces <= kMost) {
    patches *= 4;
    faces *= 4;
    ++levels;
  }
  return levels;
}

int level_difference(const Mesh& first, const Mesh& second) {
  const double ratio = visible_corners(first) / visible_corners(second);
  return static_cast<int>(std::lround(std::log2(ratio) / 2));
}

namespace {

Result<Fairness> measured(const SampledSurface& surface, const FairnessOptions& options,
                          const Context& context) {
  const auto part = measured_part(surface, surface.usable, options.rings, context);
  if (!part) return tl::make_unexpected(part.error());
  Fairness found;
  found.levels = surface.levels;
  found.coverage = part->coverage;
  integrate_curvature(surface, *part, context, found);
  find_extremes(surface, *part, found);
  const CurvatureVariation variation = curvature_variation(surface, *part, context);
  const double area = found.coverage.measured_area;
  found.curvature_variation = variation.square / surface.unit / surface.unit;
  found.curvature_variation_relative = found.curvature_variation * area;
  found.total_variation = variation.total;
  found.largest_curvature_relative = found.largest_curvature * std::sqrt(area);
  found.high_curvature_relative = found.high_curvature * std::sqrt(area);
  return found;
}

}  // namespace

Result<Fairness> fairness(const Mesh& control, const Rules& rules, const FairnessOptions& options,
                          const Context& context) {
  const int levels = options.levels == 0 ? fairness_levels(control) : options.levels;
  const auto surface = sample_surface(control, rules, levels, options.rings, context);
  if (!surface) return tl::make_unexpected(surface.error());
  return measured(*surface, options, context);
}

Result<Fairness> fairness(const Mesh& control, const NonstationaryOptions& scheme,
                          const FairnessOptions& options, const Context& context) {
  if (scheme.rule == NonstationaryRule::mean) {
    return fail(ErrorCode::invalid_argument,
                "under the rule mean every vertex has parameters of its own around it, and there "
                "is no closed form of second derivatives to measure with; take another rule");
  }
  const int levels = options.levels == 0 ? fairness_levels(control) : options.levels;
  const auto surface = sample_surface(
      control, levels, options.rings, context,
      [&](const Mesh& mesh) { return nonstationary_samples(mesh, scheme, levels, context); });
  if (!surface) return tl::make_unexpected(surface.error());
  return measured(*surface, options, context);
}

}  // namespace surpass

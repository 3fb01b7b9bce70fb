#include <surpass/fairness.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "quality/sampled_surface.hpp"

namespace surpass {
namespace {

Result<void> check_faces(const Mesh& ours, const Mesh& theirs) {
  if (ours.face_offsets == theirs.face_offsets && ours.face_vertices == theirs.face_vertices) {
    return {};
  }
  return fail(ErrorCode::mismatch,
              fmt::format("the reference has other faces: as finely refined, the surface has {} "
                          "vertices and {} faces and the reference {} and {}{}; both must have "
                          "the same faces on the same vertices in the same order",
                          ours.vertex_count(), ours.face_count(), theirs.vertex_count(),
                          theirs.face_count(),
                          ours.face_count() == theirs.face_count() ? ", in another order" : ""));
}

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

Result<NormalDeviation> normal_deviation(const Mesh& control, const Mesh& reference,
                                         const Rules& rules, const FairnessOptions& options,
                                         const Context& context) {
  // Levels by which the reference is refined further: it may be negative.
  const int further = level_difference(control, reference);
  const int levels =
      options.levels == 0 ? std::max(fairness_levels(control), 1 - further) : options.levels;
  if (options.levels > 0 && levels + further < 1) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the reference is a mesh of {} more levels than the surface, so {} "
                            "levels are too few; take {} or more",
                            -further, levels, 1 - further));
  }
  const auto ours = sample_surface(control, rules, levels, options.rings, context);
  if (!ours) return tl::make_unexpected(ours.error());
  const auto theirs = sample_surface(reference, rules, levels + further, options.rings, context);
  if (!theirs) return tl::make_unexpected(theirs.error());
  if (auto same = check_faces(ours->samples.mesh, theirs->samples.mesh); !same) {
    return tl::make_unexpected(same.error());
  }
  std::vector<unsigned char> usable = ours->usable;
  for (std::size_t v = 0; v < usable.size(); ++v) usable[v] &= theirs->usable[v];
  const auto part = measured_part(*ours, usable, options.rings, context);
  if (!part) return tl::make_unexpected(part.error());

  const auto angle = [&](Index v) {
    return degrees_between(ours->curvature[v].normal, theirs->curvature[v].normal);
  };
  using Sums = Eigen::Vector2d;
  const Sums sums = integrate(*ours, *part, Sums(Sums::Zero()), context, [&](Index v) {
    const double degrees = angle(v);
    return Sums(degrees, degrees * degrees);
  });
  const double area = part->coverage.measured_area / ours->unit / ours->unit;
  NormalDeviation found{part->coverage, sums[0] / area, std::sqrt(sums[1] / area), 0};
  found.max = parallel::reduce(
      context, usable.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t v = begin; v < end; ++v) {
          if (part->measure[v] > 0) largest = std::max(largest, angle(static_cast<Index>(v)));
        }
        return largest;
      },
      [](double a, double b) { return std::max(a, b); });
  return found;
}

}  // namespace surpass

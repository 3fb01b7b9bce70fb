#include <surpass/fairness.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "mesh/select.hpp"
#include "quality/sampled_surface.hpp"

namespace surpass {
namespace {

// The reference's sample for each of ours, or kNone.
using Partners = std::vector<Index>;

Partners partners_by_number(const Mesh& mesh) {
  Partners partners(mesh.vertex_count());
  std::iota(partners.begin(), partners.end(), Index{0});
  return partners;
}

Partners partners_in_order(const Selection& ours, const Selection& theirs) {
  Partners partners(ours.vertex_image.size(), kNone);
  for (std::size_t v = 0; v < ours.vertex_source.size(); ++v) {
    partners[ours.vertex_source[v]] = theirs.vertex_source[v];
  }
  return partners;
}

bool same_faces(const auto& a, const auto& b) {
  return a.face_offsets == b.face_offsets && a.face_vertices == b.face_vertices;
}

// Where the faces are the same, samples have the same numbers. Else hole faces and what only they
// use are left out: there may be more of them around one surface than around the other.
Result<Partners> find_partners(const Mesh& ours, const Mesh& theirs) {
  if (same_faces(ours, theirs)) return partners_by_number(ours);
  const Selection we = visible_part(ours, 0);
  const Selection they = visible_part(theirs, 0);
  if (same_faces(we, they)) return partners_in_order(we, they);
  return fail(
      ErrorCode::mismatch,
      fmt::format("the reference has other faces: as finely refined, the surface has {} "
                  "vertices and {} faces and the reference {} and {}{}; both must have "
                  "the same faces on the same vertices in the same order",
                  we.vertex_source.size(), we.face_source.size(), they.vertex_source.size(),
                  they.face_source.size(),
                  we.face_source.size() == they.face_source.size() ? ", in another order" : ""));
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
  const auto partners = find_partners(ours->samples.mesh, theirs->samples.mesh);
  if (!partners) return tl::make_unexpected(partners.error());
  std::vector<unsigned char> usable = ours->usable;
  for (std::size_t v = 0; v < usable.size(); ++v) {
    const Index partner = (*partners)[v];
    if (partner == kNone || theirs->usable[partner] == 0) usable[v] = 0;
  }
  const auto part = measured_part(*ours, usable, options.rings, context);
  if (!part) return tl::make_unexpected(part.error());

  const auto angle = [&](Index v) {
    return degrees_between(ours->curvature[v].normal, theirs->curvature[(*partners)[v]].normal);
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

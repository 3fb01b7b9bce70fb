#include <surpass/quality.hpp>

#include <algorithm>

#include <fmt/format.h>

#include "interpolate/requirement_outcomes.hpp"
#include "interpolate/requirement_places.hpp"
#include "interpolate/tangent_wishes.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {
namespace {

// Whether faces of `refined` begin with those that the corners of `given` turn into: from the
// corner's vertex to the middle of the edge that leaves it, the centre, the middle of the one
// before.
bool begins_with_corners(const Mesh& refined, const Mesh& given) {
  if (refined.face_count() < given.corner_count()) return false;
  for (Index f = 0; f < given.face_count(); ++f) {
    const auto face = given.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      const auto quad = refined.face(given.face_offsets[f] + static_cast<Index>(k));
      const auto beside = refined.face(given.face_offsets[f] + static_cast<Index>(next));
      if (quad.size() != 4 || beside.size() != 4 || quad[0] != face[k] || quad[1] != beside[3] ||
          quad[2] != beside[2]) {
        return false;
      }
    }
  }
  return true;
}

Result<void> check_places(const Mesh& refined, const Mesh& given, const Rules& rules,
                          std::span<const Requirement> requirements) {
  if (!scheme_of(rules.scheme).makes_corners_faces() ||
      std::all_of(requirements.begin(), requirements.end(), is_of_vertex) ||
      begins_with_corners(refined, given)) {
    return {};
  }
  return fail(
      ErrorCode::mismatch,
      "the faces of the control mesh are not those that the given mesh's turn into, in their "
      "order, so that places on these are not known on its surface");
}

Result<Mesh> refined_control(const Mesh& control, const Rules& rules, const Context& context) {
  return refine(control, rules, control.annotation("refined") == "1" ? 0 : 1, context);
}

void aim(const RequirementRows& equations, std::span<const Point> limits, const Mesh& given,
         RequiredCertificate& certificate) {
  certificate.targets = equations.targets;
  for (std::size_t v = 0; v < equations.released.size(); ++v) {
    if (equations.released[v] == 0) continue;
    certificate.targets[v] = limits[v];
    ++certificate.removed;
  }
  for (std::size_t v = 0; v < given.points.size(); ++v) {
    if (equations.targets[v] != given.points[v]) ++certificate.replaced;
  }
}

Result<void> check_tangents_exist(std::span<const Requirement> requirements,
                                  const RequirementRows& equations, const Mesh& refined,
                                  double side) {
  const auto found = without_tangents(requirements, equations, refined.points, {}, side);
  if (found.empty()) return {};
  const Requirement& r = requirements[found.front()];
  return fail(ErrorCode::not_converged,
              fmt::format("requirement {} ({}) is not met: the surface has no tangent plane there",
                          found.front(), describe(r)),
              place_of(r));
}

}  // namespace

Result<RequiredCertificate> certify_required(const Mesh& control, const Mesh& given,
                                             const Rules& rules,
                                             std::span<const Requirement> requirements,
                                             const Context& context) {
  const std::vector<Requirement> asked = canonical(requirements);
  if (auto ok = check_vertex_counts(control, given.points.size()); !ok) {
    return tl::make_unexpected(ok.error());
  }
  const auto refined = refined_control(control, rules, context);
  if (!refined) return tl::make_unexpected(refined.error());
  if (auto ok = check_places(*refined, given, rules, asked); !ok) {
    return tl::make_unexpected(ok.error());
  }
  const auto equations = requirement_rows(*refined, rules, given, asked, context);
  if (!equations) return tl::make_unexpected(equations.error());
  const auto limits = given_limit_points(*refined, given, rules, context);
  if (!limits) return tl::make_unexpected(limits.error());
  RequiredCertificate certificate;
  aim(*equations, *limits, given, certificate);
  const double extent = bounding_box(equations->targets).side();
  const double side = extent > 0 ? extent : 1;
  if (auto ok = check_tangents_exist(asked, *equations, *refined, side); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto outcomes = requirement_outcomes(*refined, rules, *limits, *equations, asked, side, context);
  if (!outcomes) return tl::make_unexpected(outcomes.error());
  certificate.outcomes = std::move(*outcomes);
  auto vertices = compare_points(*limits, certificate.targets, "surpass");
  if (!vertices) return tl::make_unexpected(vertices.error());
  certificate.vertices = relative_to(side, std::move(*vertices));
  return certificate;
}

}  // namespace surpass

#include <surpass/quality.hpp>

#include <cmath>

#include <fmt/format.h>

#include "scheme/subdivision_scheme.hpp"

namespace surpass {

Result<void> check_vertex_counts(const Mesh& control, std::size_t given) {
  const std::size_t n = control.points.size();
  if (n == given) return {};
  const bool refined = control.annotation("refined") == "1";
  if (refined && given < n) return {};
  const char* reason = refined ? "it was refined once, from a mesh of fewer vertices"
                               : "they must be the same vertices in the same order";
  return fail(
      ErrorCode::mismatch,
      fmt::format("the control mesh has {} vertices and the given mesh {}: {}", n, given, reason));
}

Result<Certificate> compare_points(std::span<const Point> limit, std::span<const Point> given,
                                   std::string evaluator) {
  if (limit.size() != given.size()) {
    return fail(ErrorCode::mismatch,
                fmt::format("the control mesh has {} vertices and the given mesh {}: they must be "
                            "the same vertices in the same order",
                            limit.size(), given.size()));
  }
  Certificate certificate;
  certificate.evaluator = std::move(evaluator);
  const double side = bounding_box(given).side();
  certificate.box_side = side > 0 ? side : 1;
  double sum = 0;
  for (std::size_t v = 0; v < given.size(); ++v) {
    // Relative before squaring, so that no coordinate is too large or too small for it.
    const double distance = std::hypot((limit[v][0] - given[v][0]) / certificate.box_side,
                                       (limit[v][1] - given[v][1]) / certificate.box_side,
                                       (limit[v][2] - given[v][2]) / certificate.box_side);
    sum += distance;
    if (distance > certificate.max || std::isnan(distance)) {
      certificate.max = distance;
      certificate.worst_vertex = static_cast<Index>(v);
    }
  }
  if (!given.empty()) certificate.mean = sum / static_cast<double>(given.size());
  return certificate;
}

Certificate relative_to(double side, Certificate certificate) {
  if (!(side > 0)) side = 1;
  if (side == certificate.box_side) return certificate;
  const double scale = certificate.box_side / side;
  certificate.max *= scale;
  certificate.mean *= scale;
  certificate.box_side = side;
  return certificate;
}

Result<Certificate> certify(const Mesh& control, std::span<const Point> given, const Rules& rules,
                            const Context& context) {
  if (auto ok = check_vertex_counts(control, given.size()); !ok) {
    return tl::make_unexpected(ok.error());
  }
  if (control.points.size() != given.size() && scheme_of(rules.scheme).finds_given_by_faces()) {
    return fail(ErrorCode::mismatch,
                fmt::format("where the given vertices are on a refined mesh of {} surfaces, only "
                            "the faces of the given mesh tell",
                            scheme_of(rules.scheme).title()));
  }
  const auto limit = limit_positions(control, rules, context);
  if (!limit) return tl::make_unexpected(limit.error());
  return compare_points(std::span(*limit).first(given.size()), given, "surpass");
}

Result<Certificate> certify(const Mesh& control, const Mesh& given, const Rules& rules,
                            const Context& context) {
  const SubdivisionScheme& scheme = scheme_of(rules.scheme);
  const bool by_faces = control.annotation("refined") == "1" && scheme.finds_given_by_faces();
  if (!by_faces) return certify(control, given.points, rules, context);
  const auto limits = given_limit_points(control, given, rules, context);
  if (!limits) return tl::make_unexpected(limits.error());
  return compare_points(*limits, given.points, "surpass");
}

}  // namespace surpass

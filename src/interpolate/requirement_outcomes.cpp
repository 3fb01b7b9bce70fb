#include "interpolate/requirement_outcomes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace surpass {
namespace {

using Vector3 = Eigen::Vector3d;

Vector3 vector_of(const Point& p) { return {p[0], p[1], p[2]}; }

// 0 to pi; pi where there is no vector to measure.
double angle_between(const Vector3& a, const Vector3& b) {
  if (a.isZero(0) || b.isZero(0)) return std::acos(-1.0);
  const Vector3 u = a.stableNormalized();
  const Vector3 v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// How far both together have to move to be parallel: their least singular value.
double distance_to_parallel(const Vector3& u, const Vector3& v) {
  Eigen::Matrix<double, 3, 2> both;
  both << u, v;
  return Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>>(both).singularValues()[1];
}

// Only where there are two. Rounding tells them apart by less.
bool are_parallel(const Vector3& u, const Vector3& v) {
  constexpr double kParallel = 1e-12;
  if (u.isZero(0) || v.isZero(0)) return false;
  return u.stableNormalized().cross(v.stableNormalized()).norm() <= kParallel;
}

RequirementOutcome outcome_of(const Requirement& r, const std::array<double, 2>& along,
                              const SurfaceSample& s, double side) {
  RequirementOutcome outcome;
  const Vector3 value = vector_of(r.value);
  const Vector3 derivative = along[0] * vector_of(s.du) + along[1] * vector_of(s.dv);
  // `way`: how far the tangents are from the nearest that point the right way.
  const auto judge_angle = [&](const Vector3& found, auto&& way) {
    outcome.angle = angle_between(value, found);
    outcome.flipped = outcome.angle > std::acos(-1.0) / 2;
    if (outcome.flipped) outcome.error = std::max(outcome.error, way() / side);
  };
  switch (r.kind) {
    case Requirement::Kind::position:
      outcome.error = (vector_of(s.position) - value).norm() / side;
      break;
    case Requirement::Kind::normal: {
      const Vector3 n = value.stableNormalized();
      outcome.error =
          std::max(std::abs(n.dot(vector_of(s.du))), std::abs(n.dot(vector_of(s.dv)))) / side;
      judge_angle(vector_of(s.normal),
                  [&] { return distance_to_parallel(vector_of(s.du), vector_of(s.dv)); });
      break;
    }
    case Requirement::Kind::direction: {
      const Vector3 d = value.stableNormalized();
      outcome.error = (derivative - derivative.dot(d) * d).norm() / side;
      judge_angle(derivative, [&] { return derivative.norm(); });
      break;
    }
    case Requirement::Kind::derivative: outcome.error = (derivative - value).norm() / side; break;
    case Requirement::Kind::remove: break;
  }
  if (r.kind == Requirement::Kind::direction || r.kind == Requirement::Kind::derivative) {
    outcome.without_plane = are_parallel(vector_of(s.du), vector_of(s.dv));
  }
  return outcome;
}

}  // namespace

Result<std::vector<RequirementOutcome>> requirement_outcomes(
    const Mesh& control, const Rules& rules, std::span<const Point> limits,
    const RequirementRows& equations, std::span<const Requirement> requirements, double side,
    const Context& context) {
  std::vector<SurfaceSample> samples(requirements.size());
  if (!std::all_of(requirements.begin(), requirements.end(), is_of_vertex)) {
    const auto surface = LimitSurface::create(control, rules, context);
    if (!surface) return tl::make_unexpected(surface.error());
    auto found = surface->evaluate(equations.places, context);
    if (!found) return tl::make_unexpected(found.error());
    samples = std::move(*found);
  }
  std::vector<RequirementOutcome> outcomes(requirements.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Requirement& r = requirements[i];
    if (is_of_vertex(r)) samples[i].position = limits[r.vertex];
    outcomes[i] = outcome_of(r, equations.along[i], samples[i], side);
  }
  return outcomes;
}

}  // namespace surpass

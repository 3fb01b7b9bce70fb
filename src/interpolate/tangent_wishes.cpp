#include "interpolate/tangent_wishes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "interpolate/requirement_places.hpp"
#include "interpolate/tangent_place.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;
using Vector3 = Eigen::Vector3d;

constexpr double kSame = 1e-9;
// In radians: by this much normals may differ at places that are the same but for that.
constexpr double kSameAngle = 1e-7;
constexpr double kNoWeight = 1e-12;

/// Weights of control points, of one requirement's tangents: one column a tangent.
struct Wish {
  std::size_t requirement = 0;
  std::vector<Index> columns;
  Eigen::MatrixXd tangents;

  [[nodiscard]] bool is_normal() const { return tangents.cols() == 2; }
};

Wish wish_of(const Requirement& r, std::size_t number, const SurfaceStencil& s,
             const std::array<double, 2>& along) {
  const auto n = static_cast<Eigen::Index>(s.columns.size());
  const auto vector = [n](const std::vector<double>& w) {
    return w.empty() ? Eigen::VectorXd(Eigen::VectorXd::Zero(n))
                     : Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(w.data(), n));
  };
  Wish wish{number, s.columns, Eigen::MatrixXd(n, r.kind == Kind::normal ? 2 : 1)};
  if (r.kind == Kind::normal) {
    wish.tangents << vector(s.tangent_u), vector(s.tangent_v);
  } else {
    wish.tangents = along[0] * vector(s.du) + along[1] * vector(s.dv);
  }
  for (auto tangent : wish.tangents.colwise()) tangent.normalize();
  return wish;
}

/// The tangents of `b` by those of `a`, or nothing if they go elsewhere.
std::optional<Eigen::MatrixXd> by_those_of(const Wish& a, const Wish& b) {
  std::map<Index, Eigen::Index> row;
  for (const auto* columns : {&a.columns, &b.columns}) {
    for (const Index c : *columns) row.emplace(c, static_cast<Eigen::Index>(row.size()));
  }
  const auto spread = [&](const Wish& w) {
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(row.size()), w.tangents.cols());
    for (std::size_t k = 0; k < w.columns.size(); ++k) {
      all.row(row[w.columns[k]]) = w.tangents.row(static_cast<Eigen::Index>(k));
    }
    return all;
  };
  const Eigen::MatrixXd of_a = spread(a);
  const Eigen::MatrixXd of_b = spread(b);
  const Eigen::MatrixXd found = of_a.colPivHouseholderQr().solve(of_b);
  if ((of_a * found - of_b).cwiseAbs().maxCoeff() > kSame) return std::nullopt;
  return found;
}

bool is_zero(const Requirement& r) { return r.kind == Kind::derivative && r.value == Point{}; }

bool contradict(const Requirement& a, const Wish& of_a, const Requirement& b, const Wish& of_b) {
  if (of_b.is_normal() && !of_a.is_normal()) return contradict(b, of_b, a, of_a);
  // Equations see whether two vectors agree.
  if (a.kind == Kind::derivative && b.kind == Kind::derivative) return false;
  const auto shares = by_those_of(of_a, of_b);
  if (!shares) return false;
  if (is_zero(a) || is_zero(b)) return true;
  const Vector3 u = unit_vector(a.value);
  const Vector3 v = unit_vector(b.value);
  if (of_a.is_normal() && !of_b.is_normal()) return std::abs(u.dot(v)) > kSameAngle;
  const double turn = of_a.is_normal() ? shares->determinant() : (*shares)(0, 0);
  return (v - std::copysign(1.0, turn) * u).norm() > kSameAngle;
}

/// Places have the same tangents only if they are the same, and then their position has the same
/// columns.
std::vector<Index> key_of(const SurfaceStencil& s) {
  std::vector<Index> key;
  for (std::size_t k = 0; k < s.columns.size(); ++k) {
    if (std::abs(s.position[k]) > kNoWeight) key.push_back(s.columns[k]);
  }
  std::sort(key.begin(), key.end());
  return key;
}

using Numbers = std::vector<std::size_t>;

Result<void> check_group(const Numbers& group, std::span<const Requirement> requirements,
                         std::span<const SurfaceStencil> stencils,
                         std::span<const std::array<double, 2>> along) {
  std::vector<Wish> wishes;
  for (const std::size_t i : group) {
    const Wish& wish = wishes.emplace_back(wish_of(requirements[i], i, stencils[i], along[i]));
    for (std::size_t k = 0; k + 1 < wishes.size(); ++k) {
      const std::size_t j = wishes[k].requirement;
      if (!contradict(requirements[j], wishes[k], requirements[i], wish)) continue;
      return fail(ErrorCode::contradictory,
                  fmt::format("requirements contradict each other: {}; {}",
                              names_of(std::array{j, i}, requirements),
                              wishes[k].is_normal() && wish.is_normal()
                                  ? "a surface has one normal at a place"
                                  : "no tangent of a length other than 0 does both"),
                  place_of(requirements[i]));
    }
  }
  return {};
}

bool collapsed(const Eigen::Matrix3Xd& tangents, double side) {
  constexpr double kNothing = 10 * kRequirementTolerance;  // then what is across them is met anyhow
  return tangents.colwise().norm().minCoeff() <= kNothing * side || sine_between(tangents) <= kSame;
}

// Whether next to nothing is left of the reference's tangents.
bool shrunk(const Eigen::Matrix3Xd& tangents, const Eigen::Matrix3Xd& reference) {
  constexpr double kNextToNothing = 1e-6;
  return (tangents.colwise().norm().array() <= kNextToNothing * reference.colwise().norm().array())
      .any();
}

// The weights of a position that are not nothing, by columns.
std::vector<std::pair<Index, double>> position_of(const SurfaceStencil& s) {
  std::vector<std::pair<Index, double>> weights;
  for (std::size_t k = 0; k < s.columns.size(); ++k) {
    if (std::abs(s.position[k]) > kNoWeight) weights.emplace_back(s.columns[k], s.position[k]);
  }
  std::sort(weights.begin(), weights.end());
  return weights;
}

bool same_position(const SurfaceStencil& a, const SurfaceStencil& b) {
  const auto of_a = position_of(a);
  const auto of_b = position_of(b);
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                    [](const auto& x, const auto& y) {
                      return x.first == y.first && std::abs(x.second - y.second) <= kSame;
                    });
}

}  // namespace

Result<void> check_tangents(std::span<const Requirement> requirements,
                            std::span<const SurfaceStencil> stencils,
                            const RequirementRows& equations) {
  std::map<std::vector<Index>, Numbers> groups;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (!has_tangents(requirements, equations, i)) continue;
    groups[key_of(stencils[i])].push_back(i);
  }
  for (const auto& [key, group] : groups) {
    if (group.size() < 2) continue;
    if (auto ok = check_group(group, requirements, stencils, equations.along); !ok) return ok;
  }
  return {};
}

std::vector<std::size_t> first_there(std::span<const Requirement> requirements,
                                     std::span<const SurfaceStencil> stencils) {
  Numbers first(requirements.size());
  std::map<std::vector<Index>, Numbers> places;  // the first of each
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    first[i] = i;
    if (!is_of_tangents(requirements[i].kind)) continue;
    Numbers& near = places[key_of(stencils[i])];
    const auto same = std::find_if(near.begin(), near.end(), [&](std::size_t j) {
      return same_position(stencils[i], stencils[j]);
    });
    if (same == near.end()) {
      near.push_back(i);
    } else {
      first[i] = *same;
    }
  }
  return first;
}

Result<void> check_places(std::span<const Requirement> requirements,
                          const RequirementRows& equations) {
  for (const Numbers& numbers : tangent_places(requirements, equations)) {
    if (numbers.size() < 3) continue;  // check_tangents compares two
    const auto excluded = TangentPlace(numbers, requirements, equations).exclusive();
    if (excluded.empty()) continue;
    return fail(ErrorCode::contradictory,
                fmt::format("requirements contradict each other: {}; no tangents that have lengths "
                            "other than 0 and a plane do all of them",
                            names_of(excluded, requirements)),
                place_of(requirements[excluded.back()]));
  }
  return {};
}

std::vector<std::size_t> without_tangents(std::span<const Requirement> requirements,
                                          const RequirementRows& equations,
                                          std::span<const Point> control,
                                          std::span<const Point> reference, double side) {
  Numbers found;
  std::set<std::size_t> with_derivatives;  // places, where short tangents may be what is asked
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (requirements[i].kind == Kind::derivative) with_derivatives.insert(equations.first_there[i]);
  }
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Kind kind = requirements[i].kind;
    if (kind == Kind::derivative || !has_tangents(requirements, equations, i)) continue;
    if (!found.empty() && equations.first_there[i] != equations.first_there[found.front()]) {
      continue;
    }
    const Eigen::Matrix3Xd tangents = tangents_on(control, equations, i, kind);
    const bool gone = !reference.empty() && !with_derivatives.contains(equations.first_there[i]) &&
                      shrunk(tangents, tangents_on(reference, equations, i, kind));
    if (gone || collapsed(tangents, side)) found.push_back(i);
  }
  return found;
}

Result<void> check_planes(std::span<const Requirement> requirements,
                          const RequirementRows& equations, std::span<const Point> control,
                          std::span<const Point> reference, double side,
                          const std::set<std::size_t>& opposed) {
  const auto found = without_tangents(requirements, equations, control, reference, side);
  if (found.empty()) return {};
  // All that take part: those of the place, and those by which lengths were given up.
  std::set<std::size_t> involved = opposed;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (!has_tangents(requirements, equations, i)) continue;
    if (equations.first_there[i] == equations.first_there[found.front()]) involved.insert(i);
  }
  return fail(
      ErrorCode::contradictory,
      fmt::format("no surface was found that passes through what is given and does, by tangents "
                  "that have a length other than 0 and a plane, what is required: {}",
                  names_of(Numbers(involved.begin(), involved.end()), requirements)),
      place_of(requirements[found.front()]));
}

}  // namespace surpass

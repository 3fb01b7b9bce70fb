#include "interpolate/tangent_wishes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace surpass {
namespace {

using Kind = Requirement::Kind;
using Vector3 = Eigen::Vector3d;

constexpr double kSame = 1e-9;

bool is_of_tangents(Kind kind) {
  return kind == Kind::normal || kind == Kind::direction || kind == Kind::derivative;
}

Vector3 unit(const Point& p) { return Eigen::Map<const Vector3>(p.data()).stableNormalized(); }

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
  const Vector3 u = unit(a.value);
  const Vector3 v = unit(b.value);
  if (of_a.is_normal() && !of_b.is_normal()) return std::abs(u.dot(v)) > kSame;
  const double turn = of_a.is_normal() ? shares->determinant() : (*shares)(0, 0);
  return (v - std::copysign(1.0, turn) * u).norm() > kSame;
}

/// Places have the same tangents only if they are the same, and then their position has the same
/// columns.
std::vector<Index> key_of(const SurfaceStencil& s) {
  std::vector<Index> key;
  for (std::size_t k = 0; k < s.columns.size(); ++k) {
    if (std::abs(s.position[k]) > 1e-12) key.push_back(s.columns[k]);
  }
  std::sort(key.begin(), key.end());
  return key;
}

std::string named(std::size_t number, const Requirement& r) {
  return fmt::format("{} ({})", number, describe(r));
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
                  fmt::format("requirements contradict each other: {}, {}; no tangent of a length "
                              "other than 0 does both",
                              named(j, requirements[j]), named(i, requirements[i])),
                  place_of(requirements[i]));
    }
  }
  return {};
}

/// The tangents of requirement i on the final surface, two of a normal.
std::vector<Vector3> tangents_of(const RequirementRows& equations, std::size_t first_row, Kind kind,
                                 std::span<const Point> control) {
  std::vector<Vector3> tangents;
  for (std::size_t k = 0; k < (kind == Kind::normal ? 2U : 1U); ++k) {
    const auto& weights = equations.weights[equations.rows[first_row + k].stencil];
    // From differences, for far from the origin the sum of rounded weights would tell.
    const auto at = [&](Index j) { return Eigen::Map<const Vector3>(control[j].data()); };
    Vector3 sum = Vector3::Zero();
    for (std::size_t n = 0; n < weights.columns.size(); ++n) {
      sum += weights.values[n] * (at(weights.columns[n]) - at(weights.columns[0]));
    }
    tangents.push_back(sum);
  }
  return tangents;
}

bool collapsed(const std::vector<Vector3>& tangents, double side) {
  constexpr double kNothing = 1e-12;
  for (const Vector3& t : tangents) {
    if (t.norm() > kNothing * side) continue;
    return true;
  }
  if (tangents.size() < 2) return false;
  return tangents[0].stableNormalized().cross(tangents[1].stableNormalized()).norm() <= kSame;
}

}  // namespace

Result<void> check_tangents(std::span<const Requirement> requirements,
                            std::span<const SurfaceStencil> stencils,
                            std::span<const std::array<double, 2>> along) {
  std::map<std::vector<Index>, Numbers> groups;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (!is_of_tangents(requirements[i].kind)) continue;
    groups[key_of(stencils[i])].push_back(i);
  }
  for (const auto& [key, group] : groups) {
    if (group.size() < 2) continue;
    if (auto ok = check_group(group, requirements, stencils, along); !ok) return ok;
  }
  return {};
}

std::vector<std::size_t> without_tangents(std::span<const Requirement> requirements,
                                          const RequirementRows& equations,
                                          std::span<const Point> control, double side) {
  std::vector<std::size_t> first(requirements.size(), equations.rows.size());
  for (std::size_t row = equations.rows.size(); row > 0; --row) {
    first[equations.rows[row - 1].requirement] = row - 1;
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Requirement& r = requirements[i];
    if (r.kind != Requirement::Kind::normal && r.kind != Requirement::Kind::direction) continue;
    if (!collapsed(tangents_of(equations, first[i], r.kind, control), side)) continue;
    const Requirement& other = requirements[found.empty() ? i : found.front()];
    if (other.vertex == r.vertex && other.place == r.place) found.push_back(i);
  }
  return found;
}

Result<void> check_planes(std::span<const Requirement> requirements,
                          const RequirementRows& equations, std::span<const Point> control,
                          double side) {
  const auto found = without_tangents(requirements, equations, control, side);
  if (found.empty()) return {};
  std::string names;
  for (const std::size_t i : found) {
    names += (names.empty() ? "" : ", ") + named(i, requirements[i]);
  }
  return fail(ErrorCode::contradictory,
              fmt::format("requirements contradict each other or what is given around them: {} "
                          "can only be met by a surface that has no tangent plane there",
                          names),
              place_of(requirements[found.front()]));
}

}  // namespace surpass

#include "interpolate/tangent_lengths.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "interpolate/tangent_place.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;
using Vector3 = Eigen::Vector3d;
using Tangents = Eigen::Matrix3Xd;
using PlaceWish = TangentPlace::Wish;

// Of the reference's: tangents that are not longer, or a normal's two whose sine is not greater,
// count as vanishing.
constexpr double kVanishing = 0.05;
constexpr double kNoTangent = 1e-9;

bool do_vanish(const Tangents& tangents, const Tangents& reference) {
  for (Eigen::Index k = 0; k < tangents.cols(); ++k) {
    if (tangents.col(k).norm() <= kVanishing * reference.col(k).norm()) return true;
  }
  return sine_between(tangents) <= kVanishing * sine_between(reference);
}

// Of the normal or direction that is asked for and the one that is there.
double cosine_to(const Tangents& tangents, const Requirement& r) {
  const Vector3 found = tangents.cols() == 1
                            ? Vector3(tangents.col(0))
                            : Vector3(tangents.col(0)).cross(Vector3(tangents.col(1)));
  return found.stableNormalized().dot(unit_vector(r.value));
}

// Equations do not know signs.
bool are_bad(const Tangents& tangents, const Tangents& reference, const Requirement& r) {
  return do_vanish(tangents, reference) || cosine_to(tangents, r) < 0;
}

// The reference's tangents, or stand-ins where it has none: not folded, and of the points' width.
class PresentTangents {
 public:
  PresentTangents(const TangentPlace& place, std::span<const Point> reference)
      : basis_(place.on(reference)), width_(place.width(reference)) {
    if (!(width_ > 0)) width_ = 1;
  }

  [[nodiscard]] Tangents of(const Eigen::MatrixXd& shares) const {
    Tangents tangents = basis_ * shares;
    bool fit = sine_between(tangents) > kNoTangent;
    for (Eigen::Index k = 0; k < tangents.cols(); ++k) {
      fit = fit && tangents.col(k).norm() > kNoTangent * width_ * shares.col(k).norm();
    }
    for (Eigen::Index k = 0; !fit && k < tangents.cols(); ++k) {
      tangents.col(k) = width_ * shares.col(k).norm() * Vector3::Unit(k);
    }
    return tangents;
  }

 private:
  Tangents basis_;
  double width_;
};

// A vector wish's tangent by the two of a normal, if it lies in their plane.
bool lies_in_plane(const PlaceWish& normal, const PlaceWish& other, Eigen::Vector2d& by) {
  by = normal.shares.colPivHouseholderQr().solve(other.shares.col(0));
  const double missed = (normal.shares * by - other.shares.col(0)).norm();
  return missed <= kNoTangent * other.shares.norm();
}

// The turn about `axis` that takes `from` to `to`, of any lengths, as seen along it.
Eigen::Matrix3d turn_about(const Vector3& axis, const Vector3& from, const Vector3& to) {
  const Vector3 start = from - from.dot(axis) * axis;
  const double angle = std::atan2(axis.dot(start.cross(to)), start.dot(to));
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Tangents turned_to_normal(const TangentPlace& place, const PlaceWish& wish,
                          const Tangents& reference) {
  const Vector3 wanted = unit_vector(place.asked(wish).value);
  const Vector3 present = Vector3(reference.col(0)).cross(Vector3(reference.col(1)));
  Tangents turned =
      Eigen::Quaterniond::FromTwoVectors(present, wanted).toRotationMatrix() * reference;
  for (const PlaceWish& other : place.wishes()) {
    const Requirement& r = place.asked(other);
    Eigen::Vector2d by;
    if (r.kind == Kind::normal || r.value == Point{} || !lies_in_plane(wish, other, by)) continue;
    turned = turn_about(wanted, turned * by, unit_vector(r.value)) * Tangents(turned);
    break;
  }
  return turned;
}

// What a wish's tangents should be if nothing else were required there.
Tangents aim_of(const TangentPlace& place, const PlaceWish& wish,
                const PresentTangents& reference) {
  const Requirement& r = place.asked(wish);
  if (r.kind == Kind::derivative) return Eigen::Map<const Vector3>(r.value.data());
  const Tangents present = reference.of(wish.shares);
  if (r.kind == Kind::direction) return present.norm() * unit_vector(r.value);
  return turned_to_normal(place, wish, present);
}

// The basis that does all that is required and comes nearest to the aims.
Tangents nearest(const TangentPlace& place, const PresentTangents& reference) {
  const TangentSolutions all = place.solutions();
  const Eigen::Index width = all.more.cols();
  if (width == 0) return all.moved(Eigen::VectorXd());
  Eigen::MatrixXd normal_equations = Eigen::MatrixXd::Zero(width, width);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(width);
  for (const PlaceWish& wish : place.wishes()) {
    const Tangents aim = aim_of(place, wish, reference);
    // A direction has one way to be met, and opposite aims must not cancel to nothing.
    const double weight = place.asked(wish).kind == Kind::normal ? 1 : 100;
    for (Eigen::Index k = 0; k < aim.cols(); ++k) {
      const double length = wish.shares.col(k).norm();
      Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(3, width);
      for (Eigen::Index m = 0; m < wish.shares.rows(); ++m) {
        moves += wish.shares(m, k) / length * all.more.middleRows<3>(3 * m);
      }
      const Vector3 at = all.moved(Eigen::VectorXd::Zero(width)) * wish.shares.col(k);
      normal_equations += weight * moves.transpose() * moves;
      right += weight * moves.transpose() * ((aim.col(k) - at) / length);
    }
  }
  return all.moved(normal_equations.completeOrthogonalDecomposition().solve(right));
}

void add_lengths(const Requirement& r, std::size_t number, const Tangents& tangents,
                 RequirementRows& equations) {
  for (Eigen::Index k = 0; k < tangents.cols(); ++k) {
    const std::size_t first = equations.first_row[number] + static_cast<std::size_t>(k);
    const std::size_t stencil = equations.rows[first].stencil;
    const auto add = [&](const Vector3& axis) {
      equations.rows.push_back(
          {number, {axis[0], axis[1], axis[2]}, stencil, axis.dot(tangents.col(k)), true});
    };
    if (r.kind == Kind::direction) {
      add(unit_vector(r.value));
    } else {
      for (const Vector3& axis : across(r.value)) add(axis);
    }
  }
}

std::vector<unsigned char> with_lengths(std::size_t requirements,
                                        const RequirementRows& equations) {
  std::vector<unsigned char> with(requirements, 0);
  for (const RequirementRow& row : equations.rows) {
    if (row.chosen) with[row.requirement] = 1;
  }
  return with;
}

// Cheaper than the place: whether tangents are bad or the reference's may need a stand-in.
bool may_be_bad(std::span<const Point> control, std::span<const Point> reference,
                const RequirementRows& equations, std::size_t i, const Requirement& r) {
  const Tangents present = tangents_on(reference, equations, i, r.kind);
  const double nothing = kNoTangent * reach_of(reference, equations, i);
  const bool folded =
      present.colwise().norm().minCoeff() <= nothing || sine_between(present) <= kNoTangent;
  return folded || are_bad(tangents_on(control, equations, i, r.kind), present, r);
}

// At one place; the positions in its list of those that may need it.
bool choose_lengths(const TangentPlace& place, const std::vector<std::size_t>& suspects,
                    std::span<const Point> control, std::span<const Point> reference,
                    RequirementRows& equations) {
  const PresentTangents present(place, reference);
  const Tangents basis = place.on(control);
  const Tangents chosen = nearest(place, present);
  bool added = false;
  for (const std::size_t k : suspects) {
    const PlaceWish& wish = place.wishes()[k];
    const Tangents before = present.of(wish.shares);
    const Requirement& r = place.asked(wish);
    if (!are_bad(basis * wish.shares, before, r) || are_bad(chosen * wish.shares, before, r)) {
      continue;
    }
    add_lengths(r, wish.number, chosen * wish.shares, equations);
    added = true;
  }
  return added;
}

}  // namespace

bool add_tangent_lengths(std::span<const Requirement> requirements, std::span<const Point> control,
                         std::span<const Point> reference, RequirementRows& equations) {
  const auto done = with_lengths(requirements.size(), equations);
  bool added = false;
  for (const auto& numbers : tangent_places(requirements, equations)) {
    std::vector<std::size_t> suspects;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::size_t i = numbers[k];
      const Requirement& r = requirements[i];
      if (r.kind == Kind::derivative || done[i] != 0) continue;
      if (may_be_bad(control, reference, equations, i, r)) suspects.push_back(k);
    }
    if (suspects.empty()) continue;
    const TangentPlace place(numbers, requirements, equations);
    added = choose_lengths(place, suspects, control, reference, equations) || added;
  }
  return added;
}

}  // namespace surpass

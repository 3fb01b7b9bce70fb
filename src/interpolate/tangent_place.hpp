// What is asked of the tangents at one place of the surface, as equations of a few vectors: a basis
// of these tangents, and each requirement's by it.
#pragma once

#include <Eigen/Core>

#include "interpolate/requirement_rows.hpp"

namespace surpass {

[[nodiscard]] inline bool is_of_tangents(Requirement::Kind kind) {
  return kind == Requirement::Kind::normal || kind == Requirement::Kind::direction ||
         kind == Requirement::Kind::derivative;
}

/// Whether requirement i has equations of tangents.
[[nodiscard]] inline bool has_tangents(std::span<const Requirement> requirements,
                                       const RequirementRows& equations, std::size_t i) {
  return is_of_tangents(requirements[i].kind) && equations.repeated[i] == 0;
}

[[nodiscard]] Eigen::Vector3d unit_vector(const Point& p);

/// Two unit vectors that make a right-handed frame with the direction, of any length but 0.
[[nodiscard]] std::array<Eigen::Vector3d, 2> across(const Point& direction);

/// The tangents of requirement i on the surface of these points, one a column: two of a normal.
[[nodiscard]] Eigen::Matrix3Xd tangents_on(std::span<const Point> control,
                                           const RequirementRows& equations, std::size_t i,
                                           Requirement::Kind kind);

/// How long the first of them could be if the points that it is made of lay apart one way.
[[nodiscard]] double reach_of(std::span<const Point> control, const RequirementRows& equations,
                              std::size_t i);

/// Between the two of a normal; 1 for a single tangent, which has no other to be parallel to.
[[nodiscard]] double sine_between(const Eigen::Matrix3Xd& tangents);

/// The basis' vectors one below the other: `some` that do what is asked, and all others that do by
/// adding columns of `more`. `exist`: otherwise `some` miss by least.
struct TangentSolutions {
  Eigen::VectorXd some;
  Eigen::MatrixXd more;
  bool exist = false;

  /// 3 by #basis: `some` and as much of each of `more` as `by` says.
  [[nodiscard]] Eigen::Matrix3Xd moved(const Eigen::VectorXd& by) const;
};

class TangentPlace {
 public:
  struct Wish {
    std::size_t number;      ///< of the requirement
    Eigen::MatrixXd shares;  ///< #basis by tangents, of which a normal has two
  };

  /// `numbers` of requirements of tangents at one place; `requirements` must outlive it.
  TangentPlace(std::span<const std::size_t> numbers, std::span<const Requirement> requirements,
               const RequirementRows& equations);

  [[nodiscard]] const std::vector<Wish>& wishes() const { return wishes_; }
  [[nodiscard]] const Requirement& asked(const Wish& wish) const {
    return requirements_[wish.number];
  }

  /// The basis on the surface of these points, 3 by #basis.
  [[nodiscard]] Eigen::Matrix3Xd on(std::span<const Point> control) const;

  /// How far the points lie apart that the tangents are made of: their mean distance from the
  /// middle.
  [[nodiscard]] double width(std::span<const Point> control) const;

  [[nodiscard]] TangentSolutions solutions() const { return solutions(wishes_); }

  /// The numbers of as few wishes as exclude each other, as only tangents of length 0, or parallel
  /// ones for a normal, do all they ask; empty if there are none.
  [[nodiscard]] std::vector<std::size_t> exclusive() const;

 private:
  [[nodiscard]] TangentSolutions solutions(const std::vector<Wish>& wishes) const;
  [[nodiscard]] bool exclude_each_other(const std::vector<Wish>& wishes) const;

  std::span<const Requirement> requirements_;
  std::vector<Wish> wishes_;
  std::vector<Index> columns_;
  Eigen::MatrixXd basis_;  // #columns by #basis, orthonormal
};

/// The requirements of tangents, place by place, in the order of each one's first.
[[nodiscard]] std::vector<std::vector<std::size_t>> tangent_places(
    std::span<const Requirement> requirements, const RequirementRows& equations);

}  // namespace surpass

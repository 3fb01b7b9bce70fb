#include "interpolate/tangent_place.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace surpass {
namespace {

using Kind = Requirement::Kind;
using Vector3 = Eigen::Vector3d;
using PlaceWish = TangentPlace::Wish;

// Weights of the same tangent, from two faces around, differ by rounding alone.
constexpr double kSameWeights = 1e-9;
// Equations whose difference is less are one. Above what pairs may differ by (tangent_wishes), or
// what is allowed there would be refused as three.
constexpr double kSameEquation = 1e-8;
constexpr double kNoExtent = 1e-7;

const RequirementRows::Weights& weights_of(const RequirementRows& equations, std::size_t i,
                                           std::size_t tangent) {
  return equations.weights[equations.rows[equations.first_row[i] + tangent].stencil];
}

std::size_t tangent_count(Kind kind) { return kind == Kind::normal ? 2 : 1; }

// One equation of the basis' vectors: the sum over them of share * (axis . vector) is value.
struct BasisEquation {
  Vector3 axis;
  Eigen::VectorXd shares;
  double value;
};

void add_equations(const PlaceWish& wish, const Requirement& r, std::vector<BasisEquation>& all) {
  for (const auto tangent : wish.shares.colwise()) {
    const double length = tangent.norm();
    if (!(length > 0)) continue;
    const Eigen::VectorXd shares = tangent / length;
    if (r.kind == Kind::normal) {
      all.push_back({unit_vector(r.value), shares, 0});
    } else if (r.kind == Kind::direction) {
      for (const Vector3& axis : across(r.value)) all.push_back({axis, shares, 0});
    } else {
      for (int c = 0; c < 3; ++c) {
        all.push_back({Vector3::Unit(c), shares, r.value[static_cast<std::size_t>(c)] / length});
      }
    }
  }
}

}  // namespace

Vector3 unit_vector(const Point& p) {
  return Eigen::Map<const Vector3>(p.data()).stableNormalized();
}

std::array<Vector3, 2> across(const Point& direction) {
  const Vector3 d = unit_vector(direction);
  const Vector3 a = d.unitOrthogonal();
  return {a, d.cross(a)};
}

Eigen::Matrix3Xd tangents_on(std::span<const Point> control, const RequirementRows& equations,
                             std::size_t i, Kind kind) {
  const auto at = [&](Index j) { return Eigen::Map<const Vector3>(control[j].data()); };
  Eigen::Matrix3Xd tangents(3, tangent_count(kind));
  for (std::size_t k = 0; k < tangent_count(kind); ++k) {
    const auto& weights = weights_of(equations, i, k);
    // From differences, for far from the origin the sum of rounded weights would tell.
    Vector3 sum = Vector3::Zero();
    for (std::size_t n = 0; n < weights.columns.size(); ++n) {
      sum += weights.values[n] * (at(weights.columns[n]) - at(weights.columns[0]));
    }
    tangents.col(static_cast<Eigen::Index>(k)) = sum;
  }
  return tangents;
}

double reach_of(std::span<const Point> control, const RequirementRows& equations, std::size_t i) {
  const auto& weights = weights_of(equations, i, 0);
  const auto at = [&](std::size_t n) {
    return Eigen::Map<const Vector3>(control[weights.columns[n]].data());
  };
  double reach = 0;
  for (std::size_t n = 0; n < weights.columns.size(); ++n) {
    reach += std::abs(weights.values[n]) * (at(n) - at(0)).norm();
  }
  return reach;
}

double sine_between(const Eigen::Matrix3Xd& tangents) {
  if (tangents.cols() < 2) return 1;
  const Vector3 u = tangents.col(0);
  const Vector3 v = tangents.col(1);
  return u.stableNormalized().cross(v.stableNormalized()).norm();
}

Eigen::Matrix3Xd TangentSolutions::moved(const Eigen::VectorXd& by) const {
  const Eigen::VectorXd all = some + more * by;
  return Eigen::Map<const Eigen::Matrix3Xd>(all.data(), 3, all.size() / 3);
}

TangentPlace::TangentPlace(std::span<const std::size_t> numbers,
                           std::span<const Requirement> requirements,
                           const RequirementRows& equations)
    : requirements_(requirements) {
  std::vector<const RequirementRows::Weights*> tangents;
  for (const std::size_t i : numbers) {
    for (std::size_t k = 0; k < tangent_count(requirements[i].kind); ++k) {
      tangents.push_back(&weights_of(equations, i, k));
      const auto& columns = tangents.back()->columns;
      columns_.insert(columns_.end(), columns.begin(), columns.end());
    }
  }
  std::sort(columns_.begin(), columns_.end());
  columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(columns_.size()),
                                              static_cast<Eigen::Index>(tangents.size()));
  for (std::size_t t = 0; t < tangents.size(); ++t) {
    for (std::size_t n = 0; n < tangents[t]->columns.size(); ++n) {
      const auto at = std::lower_bound(columns_.begin(), columns_.end(), tangents[t]->columns[n]);
      all(at - columns_.begin(), static_cast<Eigen::Index>(t)) += tangents[t]->values[n];
    }
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(all.colwise().normalized());
  qr.setThreshold(kSameWeights);
  basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(all.rows(), qr.rank());
  Eigen::Index at = 0;
  for (const std::size_t i : numbers) {
    const auto count = static_cast<Eigen::Index>(tangent_count(requirements[i].kind));
    wishes_.push_back({i, basis_.transpose() * all.middleCols(at, count)});
    at += count;
  }
}

Eigen::Matrix3Xd TangentPlace::on(std::span<const Point> control) const {
  Eigen::Matrix3Xd vectors = Eigen::Matrix3Xd::Zero(3, basis_.cols());
  const Eigen::Map<const Vector3> first(control[columns_.front()].data());
  for (std::size_t n = 0; n < columns_.size(); ++n) {
    const Eigen::Map<const Vector3> point(control[columns_[n]].data());
    vectors += (point - first) * basis_.row(static_cast<Eigen::Index>(n));
  }
  return vectors;
}

double TangentPlace::width(std::span<const Point> control) const {
  const auto count = static_cast<double>(columns_.size());
  Vector3 middle = Vector3::Zero();
  for (const Index j : columns_) middle += Eigen::Map<const Vector3>(control[j].data()) / count;
  double sum = 0;
  for (const Index j : columns_) {
    sum += (Eigen::Map<const Vector3>(control[j].data()) - middle).norm() / count;
  }
  return sum;
}

TangentSolutions TangentPlace::solutions(const std::vector<PlaceWish>& wishes) const {
  std::vector<BasisEquation> equations;
  for (const PlaceWish& wish : wishes) add_equations(wish, asked(wish), equations);
  const auto count = static_cast<Eigen::Index>(equations.size());
  Eigen::MatrixXd rows(count, 3 * basis_.cols());
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const BasisEquation& e = equations[static_cast<std::size_t>(i)];
    for (Eigen::Index m = 0; m < basis_.cols(); ++m) {
      rows.block<1, 3>(i, 3 * m) = e.shares[m] * e.axis.transpose();
    }
    values[i] = e.value;
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(kSameEquation);
  TangentSolutions found;
  found.some = svd.solve(values);
  found.more = svd.matrixV().rightCols(rows.cols() - svd.rank());
  found.exist = (rows * found.some - values).norm() <= kNoExtent * values.norm();
  return found;
}

bool TangentPlace::exclude_each_other(const std::vector<PlaceWish>& wishes) const {
  const TangentSolutions all = solutions(wishes);
  if (!all.exist) return false;  // the equations see that
  // Lengths, and what spans a plane, are polynomials: 0 for vectors at random only if for all.
  const double size = all.some.norm() > 0 ? all.some.norm() : 1;
  Eigen::VectorXd by(all.more.cols());
  for (Eigen::Index k = 0; k < by.size(); ++k) {
    by[k] = size * std::cos(1 + 2.4 * static_cast<double>(k));
  }
  const Eigen::Matrix3Xd vectors = all.moved(by);
  return std::any_of(wishes.begin(), wishes.end(), [&](const PlaceWish& wish) {
    if (asked(wish).kind == Kind::derivative) return false;
    const Eigen::Matrix3Xd tangents = vectors * wish.shares;
    for (Eigen::Index k = 0; k < tangents.cols(); ++k) {
      const double nothing = kNoExtent * size * wish.shares.col(k).norm();
      if (tangents.col(k).norm() <= nothing) return true;
    }
    return sine_between(tangents) <= kNoExtent;
  });
}

std::vector<std::size_t> TangentPlace::exclusive() const {
  if (!exclude_each_other(wishes_)) return {};
  std::vector<PlaceWish> left = wishes_;
  for (std::size_t k = left.size(); k > 0; --k) {
    std::vector<PlaceWish> fewer = left;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k - 1));
    if (!fewer.empty() && exclude_each_other(fewer)) left = std::move(fewer);
  }
  std::vector<std::size_t> numbers;
  numbers.reserve(left.size());
  for (const PlaceWish& wish : left) numbers.push_back(wish.number);
  return numbers;
}

std::vector<std::vector<std::size_t>> tangent_places(std::span<const Requirement> requirements,
                                                     const RequirementRows& equations) {
  std::vector<std::vector<std::size_t>> places;
  std::vector<std::size_t> place_of(requirements.size());
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (!has_tangents(requirements, equations, i)) continue;
    const std::size_t first = equations.first_there[i];
    if (first == i) {
      place_of[i] = places.size();
      places.emplace_back();
    }
    places[place_of[first]].push_back(i);
  }
  return places;
}

}  // namespace surpass

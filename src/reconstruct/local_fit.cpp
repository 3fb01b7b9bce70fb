// The fit is the first step of F. Cazals, M. Pouget, Estimating differential quantities using
// polynomial fitting of osculating jets, Computer Aided Geometric Design 22 (2005), for degree two.
// It is written here because the neighbours are at hand, threads share the points, and it stops
// when asked to.
#include "reconstruct/local_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

std::vector<Index> with_itself(Index i, std::span<const Index> neighbours) {
  std::vector<Index> all(neighbours.begin(), neighbours.end());
  all.push_back(i);
  return all;
}

using Vector6d = Eigen::Matrix<double, 6, 1>;

Vector6d monomials(double u, double v) {
  Vector6d m;
  m << 1, u, v, u * u, u * v, v * v;
  return m;
}

}  // namespace

LocalPlane fit_plane(std::span<const Point> points, std::span<const Index> chosen) {
  LocalPlane plane;
  plane.centre = Vector3d::Zero();
  for (const Index j : chosen) plane.centre += as_vector(points[j]);
  plane.centre /= static_cast<double>(chosen.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Index j : chosen) {
    const Vector3d d = as_vector(points[j]) - plane.centre;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(spread);  // ascending: the normal comes first
  plane.axes.col(0) = solver.eigenvectors().col(2);
  plane.axes.col(1) = solver.eigenvectors().col(1);
  plane.axes.col(2) = solver.eigenvectors().col(0);
  return plane;
}

LocalFit fit_quadric(std::span<const Point> points, Index i, std::span<const Index> neighbours) {
  const std::vector<Index> all = with_itself(i, neighbours);
  const LocalPlane plane = fit_plane(points, all);
  std::vector<Vector3d> local;
  double size = 0;
  for (const Index j : all) {
    local.push_back(plane.local(points[j]));
    size = std::max(size, local.back().norm());
  }
  if (!(size > 0)) return {points[i], 0};
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  for (Vector3d& p : local) {
    p /= size;
    const Vector6d m = monomials(p[0], p[1]);
    matrix += m * m.transpose();
    right += m * p[2];
  }
  // Points on a line leave curvature undetermined; a trace of stiffness settles it at none.
  matrix.diagonal().array() += 1e-9 * static_cast<double>(all.size());
  const Vector6d quadric = matrix.ldlt().solve(right);
  double sum = 0;
  for (const Vector3d& p : local) {
    const double residual = p[2] - quadric.dot(monomials(p[0], p[1]));
    sum += residual * residual;
  }
  const Vector3d& own = local.back();
  const double height = quadric.dot(monomials(own[0], own[1]));
  const Vector3d moved = plane.centre + plane.axes * (size * Vector3d(own[0], own[1], height));
  const double freedom = static_cast<double>(all.size()) - 6;
  return {{moved[0], moved[1], moved[2]}, freedom > 0 ? size * std::sqrt(sum / freedom) : 0};
}

}  // namespace surpass::reconstruction

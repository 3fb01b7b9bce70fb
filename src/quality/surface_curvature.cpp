#include "quality/surface_curvature.hpp"

#include <Eigen/Dense>

namespace surpass {

std::optional<SurfaceCurvature> curvature_of(const LimitJet& jet) {
  constexpr double kParallel = 1e-12;
  const Eigen::Vector3d cross = jet.u.cross(jet.v);
  SurfaceCurvature found;
  found.area_element = cross.norm();
  const double longer = std::max(jet.u.squaredNorm(), jet.v.squaredNorm());
  if (!(found.area_element > kParallel * longer)) return std::nullopt;
  found.normal = cross / found.area_element;

  // Both fundamental forms in an orthonormal frame of the tangent plane: with I = L L', the shape
  // operator there is L^-1 II L^-T, which is symmetric.
  Eigen::Matrix2d second;
  second(0, 0) = found.normal.dot(jet.uu);
  second(0, 1) = second(1, 0) = found.normal.dot(jet.uv);
  second(1, 1) = found.normal.dot(jet.vv);
  const double length = jet.u.norm();
  Eigen::Matrix2d factor;
  factor << length, 0, jet.u.dot(jet.v) / length, found.area_element / length;
  const auto lower = factor.triangularView<Eigen::Lower>();
  const Eigen::Matrix2d half = lower.solve(second);
  const Eigen::Matrix2d shape = lower.solve(half.transpose());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(shape, Eigen::EigenvaluesOnly);
  found.k1 = solver.eigenvalues()[0];
  found.k2 = solver.eigenvalues()[1];
  return found;
}

}  // namespace surpass

#include "support/dense.hpp"

#include <surpass/quality.hpp>

#include <Eigen/Dense>

namespace surpass::test {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

Eigen::MatrixXd to_eigen(const Dense& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.size);
  return Eigen::Map<const RowMajor>(matrix.values.data(), n, n);
}

Eigen::MatrixXd to_eigen(const std::vector<Point>& points) {
  return Eigen::Map<const Points>(points.front().data(), static_cast<Eigen::Index>(points.size()),
                                  3);
}

}  // namespace

Dense dense_operator(const Mesh& mesh, const Rules& rules) {
  const std::size_t n = mesh.points.size();
  Dense matrix(n);
  Mesh unit = mesh;
  for (std::size_t j = 0; j < n; ++j) {
    for (Point& p : unit.points) p = {};
    unit.points[j] = {1, 0, 0};
    const std::vector<Point> limits = limit_positions(unit, rules).value();
    for (std::size_t i = 0; i < n; ++i) matrix(i, j) = limits[i][0];
  }
  return matrix;
}

std::vector<Point> solve(const Dense& matrix, const std::vector<Point>& right) {
  const Eigen::MatrixXd found = to_eigen(matrix).partialPivLu().solve(to_eigen(right));
  std::vector<Point> points;
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    points.push_back({found(i, 0), found(i, 1), found(i, 2)});
  }
  return points;
}

std::vector<std::complex<double>> eigenvalues(const Dense& matrix) {
  const Eigen::VectorXcd values = to_eigen(matrix).eigenvalues();
  return {values.begin(), values.end()};
}

std::vector<double> symmetric_eigenvalues(const Dense& matrix) {
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(to_eigen(matrix), Eigen::EigenvaluesOnly)
          .eigenvalues();
  return {values.begin(), values.end()};
}

BestFit best_fit(const Dense& matrix, const std::vector<Point>& right, double threshold) {
  const Eigen::MatrixXd full = to_eigen(matrix);
  const Eigen::MatrixXd points = to_eigen(right);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(threshold);
  decomposition.compute(full);
  const Eigen::MatrixXd left = points - full * decomposition.solve(points);
  return {static_cast<std::size_t>(decomposition.rank()), left.rowwise().norm().maxCoeff()};
}

}  // namespace surpass::test

// Darts have no closed form that we know: the small eigenproblem is solved.
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "scheme/tangents.hpp"

namespace surpass {
namespace {

using Matrix = Eigen::MatrixXd;

// The left eigenvector of the largest eigenvalue below 1.
Eigen::VectorXd subdominant(const Matrix& step) {
  const Eigen::EigenSolver<Matrix> solver(step.transpose());
  const Eigen::VectorXd values = solver.eigenvalues().real();
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] < 1 - 1e-9 && (best < 0 || values[i] > values[best])) best = i;
  }
  return solver.eigenvectors().col(best).real();
}

}  // namespace

Mask even_dart_tangent(const std::vector<Mask>& masks, const std::vector<std::size_t>& image,
                       std::size_t end, std::size_t spokes) {
  const std::size_t count = masks.size();
  std::vector<Eigen::Index> row(count, 0);  // points that mirror each other share one: their mean
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < count; ++i) row[i] = image[i] < i ? row[image[i]] : size++;
  Matrix step = Matrix::Zero(size, size);
  for (std::size_t i = 0; i < count; ++i) {
    if (image[i] < i) continue;
    for (std::size_t k = 0; k < count; ++k) step(row[i], row[k]) += masks[i][k];
  }
  const Eigen::VectorXd left = subdominant(step);
  Mask mask(count);
  for (std::size_t i = 0; i < count; ++i) mask[i] = left[row[i]] / (image[i] == i ? 1 : 2);
  double along = 0;  // response to a flat ring, whose crease points along +x
  for (std::size_t j = 0; j < spokes; ++j) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(spokes);
    along += mask[1 + (end + j) % spokes] * std::cos(angle);
  }
  if (along < 0) {
    for (double& w : mask) w = -w;
  }
  return mask;
}

}  // namespace surpass

// Small dense linear algebra to judge by. Eigen does the work, in dense.cpp alone: its
// decompositions take long to compile.
#pragma once

#include <surpass/scheme.hpp>

#include <complex>
#include <vector>

namespace surpass::test {

/// A square matrix, row after row.
struct Dense {
  explicit Dense(std::size_t n) : size(n), values(n * n, 0.0) {}
  double& operator()(std::size_t i, std::size_t j) { return values[i * size + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values[i * size + j]; }

  std::size_t size;
  std::vector<double> values;
};

/// The limit operator column by column: limits of meshes with one vertex at (1, 0, 0) and the rest
/// at 0.
Dense dense_operator(const Mesh& mesh, const Rules& rules);

/// By an LU decomposition with pivoting.
std::vector<Point> solve(const Dense& matrix, const std::vector<Point>& right);

std::vector<std::complex<double>> eigenvalues(const Dense& matrix);

/// Of a symmetric matrix, ascending.
std::vector<double> symmetric_eigenvalues(const Dense& matrix);

/// The solution closest in the least-squares sense, by a rank-revealing decomposition.
struct BestFit {
  std::size_t rank = 0;
  double error = 0;  ///< largest distance that remains
};
BestFit best_fit(const Dense& matrix, const std::vector<Point>& right, double threshold);

}  // namespace surpass::test

// For blocks without a proven bound: decide by a factorisation whether there is a solution.
#include <algorithm>

#include <Eigen/SparseLU>
#include <fmt/format.h>

#include "interpolate/solvers.hpp"
#include "interpolate/sparse_cholesky.hpp"

namespace surpass {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::MatrixXd;

// What a row of the block is multiplied with: symmetry where there is some.
double row_weight(const LinearSystem& system, Index v) {
  return system.block.symmetric ? system.op.symmetric_weight[v] : 1.0;
}

// L on the block, times the row weights.
Matrix block_matrix(const LinearSystem& system) {
  const auto size = static_cast<Eigen::Index>(system.block.vertices.size());
  std::vector<Index> number(system.op.rows.row_count(), kNone);
  for (std::size_t i = 0; i < system.block.vertices.size(); ++i) {
    number[system.block.vertices[i]] = static_cast<Index>(i);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const Index v : system.block.vertices) {
    const auto columns = system.op.rows.row_columns(v);
    const auto weights = system.op.rows.row_weights(v);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (number[columns[k]] == kNone) continue;
      entries.emplace_back(static_cast<int>(number[v]), static_cast<int>(number[columns[k]]),
                           row_weight(system, v) * weights[k]);
    }
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Inverse iteration: a few solves make the part along the smallest eigenvalue stand out.
struct Smallest {
  double eigenvalue = 0;
  Eigen::Index where = 0;  ///< largest entry of its vector
};
template <class Factors>
Smallest smallest_eigenvalue(const Factors& factors, Eigen::Index size) {
  Eigen::VectorXd v(size);
  for (Eigen::Index i = 0; i < size; ++i) v[i] = std::sin(1.0 + static_cast<double>(i));
  v.normalize();
  Smallest smallest;
  for (int k = 0; k < 6; ++k) {
    const Eigen::VectorXd w = factors.solve(v);
    const double length = w.norm();
    if (!std::isfinite(length)) break;
    smallest.eigenvalue = 1 / length;
    v = w / length;
  }
  v.cwiseAbs().maxCoeff(&smallest.where);
  return smallest;
}

template <class Factors>
Result<void> require_regular(const LinearSystem& system, const Factors& factors, bool factored) {
  const auto size = static_cast<Eigen::Index>(system.block.vertices.size());
  const Smallest smallest = factored ? smallest_eigenvalue(factors, size) : Smallest{};
  constexpr double kZero = 1e-10;  // far above rounding, far below any eigenvalue worth solving for
  if (smallest.eigenvalue >= kZero) return {};
  const Index v = system.block.vertices[static_cast<std::size_t>(smallest.where)];
  return fail(ErrorCode::singular,
              "no control mesh interpolates these points in general: the limit operator is "
              "singular around this vertex; choose another scheme or boundary rule",
              {.vertex = v});
}

template <class Factors>
Result<Verdict> solve_with(const Factors& factors, bool factored, const LinearSystem& system,
                           Monitor& monitor, std::span<double> x) {
  const auto size = static_cast<Eigen::Index>(system.block.vertices.size());
  if (auto ok = require_regular(system, factors, factored); !ok)
    return tl::make_unexpected(ok.error());
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  std::vector<double> r(system.values(), 0.0);
  const auto width = static_cast<Eigen::Index>(system.width);
  for (;;) {
    const Verdict verdict = monitor.record(system.residual(x, r));
    if (verdict != Verdict::go_on) return verdict;
    Values rhs(size, width);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Index v = system.block.vertices[static_cast<std::size_t>(i)];
      for (Eigen::Index c = 0; c < width; ++c) {
        rhs(i, c) = row_weight(system, v) * r[v * system.width + static_cast<std::size_t>(c)];
      }
    }
    const Values correction = factors.solve(rhs);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Index v = system.block.vertices[static_cast<std::size_t>(i)];
      for (Eigen::Index c = 0; c < width; ++c) {
        x[v * system.width + static_cast<std::size_t>(c)] += correction(i, c);
      }
    }
  }
}

}  // namespace

Result<Verdict> direct_solve(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  const Matrix matrix = block_matrix(system);
  if (system.block.symmetric) {
    SparseCholesky factors;
    const bool factored = factors.compute(matrix, 0, system.context);
    if (system.context.cancelled()) return Verdict::cancelled;
    return solve_with(factors, factored, system, monitor, x);
  }
  Eigen::SparseLU<Matrix> factors;
  factors.compute(matrix);
  return solve_with(factors, factors.info() == Eigen::Success, system, monitor, x);
}

}  // namespace surpass

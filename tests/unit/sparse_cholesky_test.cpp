// The sparse decomposition against dense ones, and against what the signs of its pivots mean.
#include "interpolate/sparse_cholesky.hpp"

#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace surpass::test {
namespace {

using Dense = Eigen::MatrixXd;

Symmetric sparse(const Dense& dense) { return dense.sparseView(); }

Dense random_right(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return Dense::NullaryExpr(rows, columns, [&] { return number(random); });
}

// The stiffness of a grid of springs, each vertex held a little, in a random order.
Symmetric grid(int side, std::mt19937& random) {
  std::uniform_real_distribution<double> stiffness(0.1, 1);
  std::vector<int> number(static_cast<std::size_t>(side * side));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [&](int i, int j) { return number[static_cast<std::size_t>(i * side + j)]; };
  const auto spring = [&](int a, int b) {
    const double k = stiffness(random);
    for (const auto& [i, j, w] : {std::tuple(a, a, k), {b, b, k}, {a, b, -k}, {b, a, -k}}) {
      entries.emplace_back(i, j, w);
    }
  };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      entries.emplace_back(at(i, j), at(i, j), 1e-3);
      if (i + 1 < side) spring(at(i, j), at(i + 1, j));
      if (j + 1 < side) spring(at(i, j), at(i, j + 1));
    }
  }
  Symmetric matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void expect_solves(const Symmetric& matrix, const Dense& dense, std::mt19937& random) {
  SparseCholesky factor;
  ASSERT_TRUE(factor.compute(matrix, 0, {}));
  const Dense right = random_right(dense.rows(), 3, random);
  const Dense expected = dense.fullPivLu().solve(right);
  EXPECT_LE((factor.solve(right) - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LE((factor.solve(right.col(1)) - expected.col(1)).norm(), 1e-10 * expected.norm());
}

TEST(SparseCholesky, SolvesWhatADenseDecompositionSolves) {
  std::mt19937 random(1);
  for (const int side : {1, 2, 3, 7, 30}) {
    const Symmetric matrix = grid(side, random);
    expect_solves(matrix, Dense(matrix), random);
  }
}

// A full matrix is a single supernode, of more columns than are decomposed in a step.
TEST(SparseCholesky, SolvesFullMatrices) {
  std::mt19937 random(2);
  for (const Eigen::Index size : {1, 63, 64, 65, 200}) {
    const Dense root = random_right(size, size, random);
    const Dense dense = root * root.transpose() + Dense::Identity(size, size);
    expect_solves(sparse(dense), dense, random);
  }
}

TEST(SparseCholesky, SolvesPartsThatDoNotTouch) {
  std::mt19937 random(3);
  const Dense part(grid(6, random));
  Dense dense = Dense::Zero(2 * part.rows() + 5, 2 * part.rows() + 5);
  dense.topLeftCorner(part.rows(), part.rows()) = part;
  dense.bottomRightCorner(part.rows(), part.rows()) = part;
  for (Eigen::Index i = 0; i < 5; ++i) dense(part.rows() + i, part.rows() + i) = 2;
  expect_solves(sparse(dense), dense, random);
  SparseCholesky nothing;
  ASSERT_TRUE(nothing.compute(Symmetric(0, 0), 0, {}));
  EXPECT_EQ(nothing.solve(Dense(0, 1)).size(), 0);
}

// Sylvester's law of inertia: as many pivots are negative as eigenvalues. Their product is the
// determinant.
TEST(SparseCholesky, PivotsHaveTheSignsOfEigenvalues) {
  std::mt19937 random(4);
  for (const double shift : {0.0, -0.5, -1.2}) {
    const Symmetric matrix = grid(9, random);
    const Dense shifted = Dense(matrix) + shift * Dense::Identity(81, 81);
    SparseCholesky factor;
    ASSERT_TRUE(factor.compute(matrix, shift, {}));
    const Eigen::VectorXd pivots = factor.pivots();
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Dense>(shifted).eigenvalues();
    EXPECT_EQ((pivots.array() < 0).count(), (eigenvalues.array() < 0).count());
    EXPECT_NEAR(pivots.array().abs().log().sum(), eigenvalues.array().abs().log().sum(), 1e-9);
  }
}

// Two rows are the same, so the pivot of the later one is nothing; elsewhere rows are independent.
TEST(SparseCholesky, PivotsAreThoseOfTheRows) {
  std::mt19937 random(5);
  Dense rows = random_right(40, 60, random);
  rows.row(23) = rows.row(7);
  const Dense products = rows * rows.transpose();
  SparseCholesky factor;
  ASSERT_TRUE(factor.compute(sparse(products), 1e-14, {}));
  const Eigen::VectorXd pivots = factor.pivots();
  for (Eigen::Index i = 0; i < 40; ++i) {
    const bool small = pivots[i] < 1e-8 * products(i, i);
    EXPECT_TRUE(!small || i == 7 || i == 23) << i;
  }
  EXPECT_LT(std::min(pivots[7], pivots[23]), 1e-8 * products(7, 7));
}

TEST(SparseCholesky, SaysWhereItCannotGoOn) {
  const Symmetric zero = sparse(Dense{{0, 1}, {1, 0}});
  EXPECT_FALSE(SparseCholesky().compute(zero, 0, {}));
  SparseCholesky shifted;
  ASSERT_TRUE(shifted.compute(zero, 0.5, {}));  // [0.5 1; 1 0.5]
  EXPECT_NEAR(shifted.solve(Dense{{1.5}, {1.5}})(1), 1, 1e-15);
  EXPECT_FALSE(SparseCholesky().compute(sparse(Dense{{HUGE_VAL}}), 0, {}));
}

// Three rows in a plane, the third by shares of 1e4 and more: no pivot tells, a solution does.
TEST(SparseCholesky, KnowsWhereSolutionsHaveNoDigits) {
  std::mt19937 random(9);
  int pivots_that_tell_nothing = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Dense rows = random_right(3, 5, random).rowwise().normalized();
    rows.row(1) = (rows.row(0) + 1e-5 * rows.row(1)).normalized();
    const Dense apart = random_right(1, 5, random).normalized();
    for (const double distance : {0.0, 0.1}) {
      rows.row(2) = (1e5 * (rows.row(1) - rows.row(0)) + distance * apart).normalized();
      const Symmetric products = sparse(rows * rows.transpose());
      SparseCholesky factor;
      if (!factor.compute(products, 0, {})) continue;
      const bool tells = factor.pivots().minCoeff() < 1e-11;
      if (distance == 0 && !tells) ++pivots_that_tell_nothing;
      if (distance == 0) {
        EXPECT_FALSE(factor.is_accurate(products));
      }
    }
  }
  EXPECT_GT(pivots_that_tell_nothing, 0);
  const Symmetric matrix = grid(12, random);
  SparseCholesky factor;
  ASSERT_TRUE(factor.compute(matrix, 0, {}));
  EXPECT_TRUE(factor.is_accurate(matrix));
}

TEST(SparseCholesky, StopsHalfwayWhereItIsCancelled) {
  std::mt19937 random(6);
  std::atomic<bool> cancel = false;
  double last = 0;
  const Context context{.progress =
                            [&](const Progress& p) {
                              cancel = p.fraction > 0.5;
                              EXPECT_GE(p.fraction, last);
                              last = p.fraction;
                            },
                        .cancel = &cancel};
  EXPECT_FALSE(SparseCholesky().compute(grid(20, random), 0, context));
  EXPECT_GT(last, 0.5);
  EXPECT_LT(last, 1);
}

}  // namespace
}  // namespace surpass::test

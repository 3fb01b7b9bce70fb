// Which rows are independent, against dense decompositions.
#include "interpolate/independent_rows.hpp"

#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace surpass::test {
namespace {

using Dense = Eigen::MatrixXd;

const RowChoice kAll{[](const DependentRow&) { return false; }, [](int) { return false; }};

// Values of polynomials at places, in blocks that have no column in common; and of every third
// place the same once more. The shorter the part of [0, 1] where they are, the nearer to dependent.
Dense polynomials(int blocks, int places, int degree, double part, std::mt19937& random) {
  std::uniform_real_distribution<double> at(0, part);
  const int columns = degree + 1;
  Dense rows = Dense::Zero(static_cast<Eigen::Index>(blocks) * places, blocks * columns);
  for (int b = 0; b < blocks; ++b) {
    for (int i = 0; i < places; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i) * blocks + b;
      if (i % 3 == 2) {
        rows.row(row) = rows.row(row - blocks);
        continue;
      }
      const double t = at(random);
      for (int k = 0; k < columns; ++k) rows(row, b * columns + k) = std::cos(k * std::acos(t));
      rows.row(row).normalize();
    }
  }
  return rows;
}

// What is left of a row without its shares.
Eigen::RowVectorXd rest(const Dense& rows, const DependentRow& d) {
  Eigen::RowVectorXd left = rows.row(d.row);
  for (const auto& [row, share] : d.shares) left -= share * rows.row(row);
  return left;
}

TEST(IndependentRows, AreAsManyAsTheRank) {
  std::mt19937 random(3);
  for (const double part : {1.0, 0.3, 0.1}) {
    SCOPED_TRACE(part);
    const Dense rows = polynomials(5, 40, 6, part, random);
    const auto found = independent_rows(rows.sparseView(), kAll, {});
    ASSERT_TRUE(found);
    const Eigen::JacobiSVD<Dense> all(rows);
    ASSERT_GT(all.singularValues()[34], 10 * kDependent);
    EXPECT_EQ(found->independent.size() + found->near.size(), 35U);
    EXPECT_EQ(found->dependent.size(), 165U);
    for (const DependentRow& d : found->dependent) EXPECT_LT(rest(rows, d).norm(), 1e-12);
  }
}

// What the highest powers add is less than kDependent where the part is short enough.
TEST(IndependentRows, KeepWhatIsNotDependentAndNoMore) {
  std::mt19937 random(5);
  for (const double part : {0.3, 0.1, 0.03, 0.01}) {
    SCOPED_TRACE(part);
    const Dense rows = polynomials(1, 60, 9, part, random);
    const auto found = independent_rows(rows.sparseView(), kAll, {});
    ASSERT_TRUE(found);
    std::vector<Eigen::RowVectorXd> own;
    for (const int row : found->independent) own.push_back(rows.row(row));
    for (const DependentRow& d : found->near) {
      EXPECT_GT(d.distance, kDependent);
      EXPECT_NEAR(rest(rows, d).norm(), d.distance, 1e-14);
      own.push_back(rest(rows, d) / d.distance);
    }
    Dense kept(static_cast<Eigen::Index>(own.size()), rows.cols());
    for (std::size_t i = 0; i < own.size(); ++i) kept.row(static_cast<Eigen::Index>(i)) = own[i];
    // They span all rows but for what is too little, and their squares leave digits to solve by.
    const Eigen::JacobiSVD<Dense> of_kept(kept, Eigen::ComputeThinV);
    EXPECT_GT(of_kept.singularValues().minCoeff(), 1e-6);
    const Dense outside = rows - rows * of_kept.matrixV() * of_kept.matrixV().transpose();
    EXPECT_LT(outside.rowwise().norm().maxCoeff(), 2 * kDependent);
  }
}

TEST(IndependentRows, OfRepeatedOnesTheFirstIsKept) {
  std::mt19937 random(7);
  const Dense rows = polynomials(4, 9, 9, 1, random);
  const auto found = independent_rows(rows.sparseView(), kAll, {});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->dependent.size(), 12U);
  for (const DependentRow& d : found->dependent) {
    ASSERT_EQ(d.shares.size(), 1U) << d.row;
    EXPECT_EQ(d.shares[0].first, d.row - 4);
    EXPECT_NEAR(d.shares[0].second, 1, 1e-12);
  }
}

TEST(IndependentRows, LookNoFurtherThanTheFirstThatSuffices) {
  std::mt19937 random(9);
  const Dense rows = polynomials(4, 60, 6, 0.5, random);
  int asked = 0;
  const RowChoice choice{[&](const DependentRow&) { return ++asked == 2; },
                         [](int) { return false; }};
  EXPECT_FALSE(independent_rows(rows.sparseView(), choice, {}));
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace surpass::test

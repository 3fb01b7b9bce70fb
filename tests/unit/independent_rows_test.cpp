// Which rows are independent, against dense decompositions.
#include "interpolate/independent_rows.hpp"

#include <atomic>
#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "interpolate/balanced_values.hpp"
#include "interpolate/dispensable_rows.hpp"
#include "interpolate/fewest_rows.hpp"

namespace surpass::test {
namespace {

using Dense = Eigen::MatrixXd;

bool no_row_suffices(const DependentRow&) { return false; }

std::optional<IndependentRows> independent(const Dense& rows,
                                           const Suffices& suffices = no_row_suffices) {
  std::vector<int> all(static_cast<std::size_t>(rows.rows()));
  std::iota(all.begin(), all.end(), 0);
  return independent_rows(rows.sparseView(), all, suffices, {});
}

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
    const auto found = independent(rows);
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
    const auto found = independent(rows);
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
  const auto found = independent(rows);
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
  EXPECT_FALSE(independent(rows, [&](const DependentRow&) { return ++asked == 2; }));
  EXPECT_EQ(asked, 2);
}

TEST(FewestRows, SufficeAndWithoutAnyOneDoNot) {
  std::mt19937 random(13);
  const Suffices is_sum = [](const DependentRow& d) { return d.distance <= kDependent; };
  for (const double part : {1.0, 0.3, 0.1}) {
    SCOPED_TRACE(part);
    // A sum of rows 0, 3 and 6, which nearly all others are near to as well.
    Dense rows = polynomials(1, 24, 30, part, random);
    rows.row(23) = rows.row(0) + rows.row(3) - rows.row(6);
    rows.row(23).normalize();
    const RowMatrix sparse = rows.sparseView();
    const DependentRow by_all{
        23, 0, {{0, 1}, {1, 0.5}, {3, 0.4}, {4, 2}, {6, 1}, {7, 3}, {9, 0.1}}};
    const DependentRow few = by_fewest_rows(sparse, by_all, is_sum, {});
    ASSERT_EQ(few.shares.size(), 3U);
    EXPECT_EQ(few.shares[0].first, 0);
    EXPECT_EQ(few.shares[1].first, 3);
    EXPECT_EQ(few.shares[2].first, 6);
    EXPECT_LT(rest(rows, few).norm(), 1e-12);
  }
}

// A row 0.05 away from what is needed must not keep one out that is 1 away, whichever comes first.
TEST(DispensableRows, TheFarthestIsKeptInAnyOrder) {
  const Dense needed = Dense::Identity(1, 3);
  Dense far = Dense::Zero(1, 3);
  far(0, 1) = 1;
  Dense near = needed + 0.05 * far;
  near.normalize();
  for (const bool near_first : {false, true}) {
    Dense rows(3, 3);
    rows << needed, near_first ? near : far, near_first ? far : near;
    const RowMatrix sparse = rows.sparseView();
    auto found = independent_rows(sparse, {0}, no_row_suffices, {}).value();
    add_dispensable(sparse, {1, 2}, {}, found);
    EXPECT_EQ(found.independent, (std::vector{0, near_first ? 2 : 1}));
  }
}

// Rows that are met only where nothing is the worse for it: all that are kept lie far from the span
// of the others that are, and of those that are not, none lies far from it.
TEST(DispensableRows, AreKeptWhereTheyAreFar) {
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  for (const int needed : {0, 5, 12, 18}) {
    for (const double apart : {1e-1, 1e-3, 1e-6, 1e-9, 0.0}) {
      SCOPED_TRACE(testing::Message() << needed << " needed, apart " << apart);
      const int columns = 20;
      const int spare = 9;
      Dense rows(needed + spare, columns);
      for (double& x : rows.reshaped()) x = any(random);
      // Every third is nearly a sum of those before.
      for (int i = needed + 2; i < rows.rows(); i += 3) {
        rows.row(i) = rows.topRows(i).colwise().sum() + apart * rows.row(i);
      }
      rows.rowwise().normalize();
      std::vector<int> first(static_cast<std::size_t>(needed));
      std::iota(first.begin(), first.end(), 0);
      std::vector<int> dispensable(spare);
      std::iota(dispensable.begin(), dispensable.end(), needed);
      const RowMatrix sparse = rows.sparseView();
      auto found = independent_rows(sparse, first, no_row_suffices, {}).value();
      add_dispensable(sparse, dispensable, {}, found);
      const Dense kept = pick_of(found, rows.rows()) * rows;
      const Dense span =
          kept.transpose().householderQr().householderQ() * Dense::Identity(columns, kept.rows());
      ASSERT_EQ(found.independent.size() + found.dependent.size(),
                static_cast<std::size_t>(rows.rows()));
      EXPECT_GT(Eigen::JacobiSVD<Dense>(kept).singularValues().minCoeff(), 1e-3);
      for (const DependentRow& d : found.dependent) {
        const Eigen::RowVectorXd row = rows.row(d.row);
        EXPECT_LT((row - row * span * span.transpose()).norm(), 0.1) << d.row;
      }
    }
  }
}

std::vector<DependentRow> sums(const Dense& shares) {
  std::vector<DependentRow> dropped;
  for (Eigen::Index i = 0; i < shares.rows(); ++i) {
    DependentRow& d = dropped.emplace_back();
    d.row = static_cast<int>(shares.cols() + i);
    for (Eigen::Index k = 0; k < shares.cols(); ++k) {
      d.shares.emplace_back(static_cast<int>(k), shares(i, k));
    }
  }
  return dropped;
}

// Against a dense solution of the same least squares, with shares up to thousands.
TEST(BalancedValues, AreThoseOfLeastSquares) {
  std::mt19937 random(7);
  std::normal_distribution<double> number;
  const auto dense = [&](Eigen::Index rows, Eigen::Index columns, double size) {
    return Dense(Dense::NullaryExpr(rows, columns, [&] { return size * number(random); }));
  };
  for (const double size : {1.0, 100.0, 3000.0}) {
    SCOPED_TRACE(size);
    const Dense shares = dense(30, 12, size);
    const Eigen::VectorXd kept = dense(12, 1, 1);
    Eigen::VectorXd values(42);
    values << kept, shares * kept;
    EXPECT_LT((balanced_values(sums(shares), values, {}) - values).norm(), 1e-12);
    const Eigen::VectorXd rounding = dense(42, 1, 1e-6);
    Dense both(42, 12);
    both << Dense::Identity(12, 12), shares;
    Eigen::VectorXd right = rounding;
    const Eigen::VectorXd change = both.colPivHouseholderQr().solve(right);
    const Eigen::VectorXd balanced = balanced_values(sums(shares), values + rounding, {});
    EXPECT_LT((balanced.head(12) - kept - change).norm(), 1e-10);
    EXPECT_LT((shares * balanced.head(12) - values.tail(30)).norm(), 1e-4);
  }
}

TEST(BalancedValues, StayAsTheyWereIfCancelled) {
  const std::atomic<bool> stop = true;
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(3, 0, 1);
  const auto dropped = sums(Dense::Ones(1, 2));
  EXPECT_NE(balanced_values(dropped, values, {}), values);
  EXPECT_EQ(balanced_values(dropped, values, {.cancel = &stop}), values);
}

}  // namespace
}  // namespace surpass::test

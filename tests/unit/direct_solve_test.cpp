// The decision between "solvable" and "singular" on operators whose answer is known.
#include <gtest/gtest.h>

#include "interpolate/solvers.hpp"

namespace surpass {
namespace {

// Two vertices that see each other with the weight w, and themselves with 1 - w: eigenvalues 1, 1 -
// 2w.
LimitOperator pair(double w) {
  LimitOperator op;
  op.rows = SparseRows::build(
      {}, 2, [](Index) { return Index{2}; },
      [w](Index i, std::span<Index> columns, std::span<double> weights) {
        columns[0] = i;
        columns[1] = 1 - i;
        weights[0] = 1 - w;
        weights[1] = w;
      });
  op.symmetric_weight = {1, 1};
  op.lowest_eigenvalue = {0, 0};
  op.on_curve = {0, 0};
  return op;
}

Result<Verdict> solve(double w, std::vector<double>& x) {
  const LimitOperator op = pair(w);
  const Block block{.vertices = {0, 1}, .lowest = 0};
  const Context context;
  const std::vector<double> target = x;
  const LinearSystem system{op, block, 1, target, 1, context};
  Monitor monitor({.tolerance = 1e-14, .max_iterations = 10}, system);
  return direct_solve(system, monitor, x);
}

TEST(DirectSolve, SolvesWhatIsRegularEvenIfIndefinite) {
  for (const double w : {0.1, 0.4, 0.499, 0.6, 0.9}) {
    std::vector<double> x = {3, -1};
    const auto verdict = solve(w, x);
    ASSERT_TRUE(verdict) << describe(verdict.error());
    EXPECT_EQ(*verdict, Verdict::reached);
    // The mean 1 stays; the difference 4 is divided by its eigenvalue.
    EXPECT_NEAR(x[0], 1 + 2 / (1 - 2 * w), 1e-10);
    EXPECT_NEAR(x[1], 1 - 2 / (1 - 2 * w), 1e-10);
  }
}

TEST(DirectSolve, NamesAVertexOfTheNullVectorWhereItIsSingular) {
  std::vector<double> x = {3, -1};
  const auto verdict = solve(0.5, x);
  ASSERT_FALSE(verdict);
  EXPECT_EQ(verdict.error().code, ErrorCode::singular);
  EXPECT_TRUE(verdict.error().place.vertex.has_value());
}

}  // namespace
}  // namespace surpass

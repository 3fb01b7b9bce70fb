// Sweeps on ordered rows, against the plain ones: the same bits. And both against the iteration in
// double precision.
#include "interpolate/wavefront.hpp"

#include <surpass/io.hpp>

#include <algorithm>
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

#include "interpolate/chebyshev.hpp"
#include "interpolate/plain_sweeps.hpp"
#include "support/polygons.hpp"

namespace surpass::test {
namespace {

struct Problem {
  LimitOperator op;
  Blocks blocks;
};

// Of some vertices the points may be known, so that blocks read what is not theirs.
Problem problem_of(const Mesh& mesh, const Rules& rules, bool some_known) {
  const auto topology = Topology::build(mesh).value();
  Problem problem{limit_operator(mesh, topology, rules, {}).value(), {}};
  std::vector<unsigned char> listed(mesh.vertex_count(), 1);
  for (Index v = 0; v < mesh.vertex_count() && some_known; v += 17) listed[v] = 0;
  problem.blocks = find_blocks(problem.op, listed);
  return problem;
}

// Numbers without pattern, exact zeros and a negative zero among them.
std::vector<double> values(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> numbers(count);
  for (double& x : numbers) x = uniform(random);
  if (count > 5) numbers[1] = 0, numbers[5] = -0.0;
  return numbers;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The iteration that all sweeps stand for, every number in double precision.
class DoubleSweeps {
 public:
  DoubleSweeps(const LinearSystem& system, const std::vector<double>& start)
      : system_(system), newest_(start), measured_(start) {}

  ErrorNorms advance(std::span<const SweepStep> sweeps) {
    ErrorNorms norms;
    for (const SweepStep& sweep : sweeps) {
      norms = system_.sweep(newest_, measured_, sweep.momentum, sweep.step, true);
      std::swap(newest_, measured_);
    }
    return norms;
  }
  [[nodiscard]] const std::vector<double>& measured() const { return measured_; }

 private:
  const LinearSystem& system_;
  std::vector<double> newest_;
  std::vector<double> measured_;
};

constexpr double kScale = 0.25;

// How often it could be compared with double precision.
std::size_t check_rounds(const OrderedRows& rows, const LinearSystem& system, std::vector<double> x,
                         std::span<const unsigned> rounds) {
  Wavefront front(rows, system, x);
  PlainSweeps plain(system, x);
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  DoubleSweeps doubles(system, x);
  std::vector<double> found = x;
  std::vector<double> expected = x;
  std::vector<double> out = x;
  SemiIteration coefficients = SemiIteration::chebyshev(0.2);
  double largest = 0;
  std::size_t compared = 0;
  for (const unsigned count : rounds) {
    std::vector<SweepStep> sweeps;
    for (unsigned i = 0; i < count; ++i) {
      sweeps.push_back({coefficients.momentum(), coefficients.step()});
      coefficients.advance();
    }
    const auto reference = plain.advance(sweeps);
    const auto errors = front.advance(sweeps, {}, out);
    EXPECT_EQ(errors->start.max, reference->start.max);
    EXPECT_EQ(errors->last.max, reference->last.max);
    EXPECT_NEAR(errors->last.sum, reference->last.sum, 1e-12 * (1 + reference->last.sum));
    front.copy_measured(found);
    plain.copy_measured(expected);
    EXPECT_TRUE(same_bits(found, expected));
    EXPECT_TRUE(same_bits(out, expected));
    // What is rounded is a part of the errors that there were. Where the iteration diverges, as it
    // may where no bound is proven, that part grows, too.
    const ErrorNorms exact = doubles.advance(sweeps);
    largest = std::max(largest, errors->start.max);
    if (exact.max > largest) continue;
    const double tolerance = 1e-5 * largest / kScale;
    EXPECT_LE(largest_difference(found, doubles.measured()), tolerance);
    EXPECT_NEAR(errors->last.max, exact.max, tolerance);
    ++compared;
  }
  return compared;
}

// Whether the block could be ordered, and compared with double precision; or how many could.
struct Checked {
  double ordered = 0;
  double compared = 0;
  double blocks = 1;
};

using Rounds = std::vector<std::vector<unsigned>>;

// How much of it: all of it where meshes are small, so that every real mesh can have some of it.
struct Extent {
  std::vector<bool> some_known = {false, true};
  std::vector<std::size_t> widths = {1, 3, 4};
  Rounds rounds = {{1, 2, 5, 12}, {2, 1, 3, 1}, {9, 10, 1, 4}};

  static Extent of_large() { return {{true}, {3}, {{3, 1, 2}}}; }
};

Checked check_block(const LimitOperator& op, Block block, std::size_t width,
                    const Rounds& all_rounds = Extent().rounds) {
  if (block.vertices.empty()) return {1, 1};
  const auto rows = order_rows(op.rows, block.vertices);
  if (!rows) return {};
  block.spare = std::make_shared<SpareArrays>();
  const std::size_t count = op.rows.row_count() * width;
  const std::vector<double> target = values(count, 1);
  const Context context;
  const LinearSystem system{op, block, width, target, kScale, context};
  std::size_t compared = 0;
  for (const auto& rounds : all_rounds) {
    compared += check_rounds(*rows, system, values(count, 2), rounds);
  }
  return {1, compared > 0 ? 1.0 : 0.0};
}

void check_mesh(const Mesh& mesh, const Rules& rules, Checked& all, const Extent& extent = {}) {
  for (const bool some_known : extent.some_known) {
    const Problem problem = problem_of(mesh, rules, some_known);
    std::vector<const Block*> blocks = {&problem.blocks.curve};
    for (const Block& block : problem.blocks.surface) blocks.push_back(&block);
    for (const Block* block : blocks) {
      for (const std::size_t width : extent.widths) {
        const Checked one = check_block(problem.op, *block, width, extent.rounds);
        all.ordered += one.ordered;
        all.compared += one.compared;
        all.blocks += one.blocks;
      }
    }
  }
}

class WavefrontOf : public testing::TestWithParam<Scheme> {};

TEST_P(WavefrontOf, EverySweepHasTheBitsOfThePlainOne) {
  const Scheme scheme = GetParam();
  for (const double creases : {0.0, 0.1}) {
    Checked all{.blocks = 0};
    for (int kind = 0; kind < 5; ++kind) {
      const Mesh mesh =
          random_mesh_for(scheme, {.seed = 7, .kind = kind, .size = 9, .creases = creases});
      check_mesh(mesh, {scheme, Boundary::edge_and_corner}, all);
    }
    // Curves at the end of which a dart looks at the surface may not be orderable.
    EXPECT_GE(all.ordered, (creases > 0 ? 0.7 : 1) * all.blocks);
    EXPECT_GE(all.compared, 0.9 * all.ordered);
  }
}

TEST_P(WavefrontOf, RealMeshesAsWell) {
  const Scheme scheme = GetParam();
  std::vector<std::string> paths = committed_meshes();
  for (const char* folder : {"tri", "quad"}) {
    const auto real = real_meshes(folder);
    paths.insert(paths.end(), real.begin(), real.end());
  }
  Checked all{.blocks = 0};
  for (const std::string& path : paths) {
    const auto loaded = read_mesh(path);
    ASSERT_TRUE(loaded) << path;
    const Rules rules{scheme};
    if (!limit_positions(loaded->mesh, rules)) continue;  // not for this scheme
    SCOPED_TRACE(path);
    const bool large = loaded->mesh.vertex_count() > 1000;
    check_mesh(loaded->mesh, rules, all, large ? Extent::of_large() : Extent());
  }
  EXPECT_GT(all.ordered, 0.9 * all.blocks);
  EXPECT_GT(all.compared, 0.9 * all.ordered);
}

INSTANTIATE_TEST_SUITE_P(Schemes, WavefrontOf, testing::ValuesIn(all_schemes()),
                         [](const auto& scheme) {
                           std::string name = name_of(scheme.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Two pairs of vertices, of which the second has an eigenvalue of 1.9, where Chebyshev's iteration
// diverges. Its data is so small that the error falls at first.
struct Diverging {
  Diverging() : op(4) {
    op.rows = SparseRows::build(
        {}, 4, [](Index) -> Index { return 2; },
        [](Index i, std::span<Index> columns, std::span<double> weights) {
          columns[0] = i, columns[1] = i ^ 1U;
          weights[0] = i < 2 ? 0.7 : 1, weights[1] = i < 2 ? 0.3 : 0.9;
        });
    block.vertices = {0, 1, 2, 3};
  }

  // How it ended, and the point.
  std::pair<Monitor, std::vector<double>> solve(unsigned most) const {
    const LinearSystem system{op, block, 1, target, 1, context};
    Monitor monitor({.tolerance = 1e-10, .max_iterations = most}, system);
    std::vector<double> x = target;
    EXPECT_EQ(chebyshev_iteration(system, SemiIteration::chebyshev(0.2), monitor, x),
              Verdict::exhausted);
    return {monitor, x};
  }

  LimitOperator op;
  Block block;
  Context context;
  std::vector<double> target = {1, -0.5, 1e-12, 2e-12};
};

TEST(ChebyshevRounds, LeaveTheirBestPoint) {
  Diverging problem;
  const auto [plain, plain_point] = problem.solve(50);
  problem.block.ordered =
      std::make_shared<const OrderedRows>(*order_rows(problem.op.rows, problem.block.vertices));
  problem.block.spare = std::make_shared<SpareArrays>();
  const auto [ordered, point] = problem.solve(50);
  EXPECT_TRUE(same_bits(point, plain_point));
  EXPECT_EQ(ordered.best().iteration, plain.best().iteration);
  EXPECT_GT(ordered.best().iteration, 1U);
  EXPECT_LT(ordered.best().iteration, ordered.last().iteration);
  const auto [stopped, there] = problem.solve(ordered.best().iteration);
  EXPECT_EQ(stopped.last().max, ordered.best().max);
  EXPECT_TRUE(same_bits(point, there));
}

TEST(ChebyshevRounds, LeaveTheTargetWhereItIsTheBestPoint) {
  Diverging problem;
  problem.target[2] = 1;
  const auto [monitor, point] = problem.solve(50);
  EXPECT_EQ(monitor.best().iteration, 1U);
  EXPECT_TRUE(same_bits(point, problem.target));
}

// Row 0 reads row 2, which is two levels away, as row 2 does not answer.
TEST(OrderedRows, AreNotMadeWhereLevelsDoNotHold) {
  std::vector<std::vector<Index>> reads = {{0, 1}, {1, 0, 2}, {2, 1, 3}, {3, 2, 0}};
  const auto ordered = [&] {
    const SparseRows rows = SparseRows::build(
        {}, 4, [&](Index i) { return static_cast<Index>(reads[i].size()); },
        [&](Index i, std::span<Index> columns, std::span<double> weights) {
          std::copy(reads[i].begin(), reads[i].end(), columns.begin());
          std::fill(weights.begin(), weights.end(), 1.0 / static_cast<double>(columns.size()));
        });
    return order_rows(rows, {0, 1, 2, 3}).has_value();
  };
  EXPECT_FALSE(ordered());
  reads[3][2] = 3;
  EXPECT_TRUE(ordered());
}

TEST(OrderedRows, KeepEqualWeightsOnce) {
  const Problem problem = problem_of(triangle_grid(20, 20), {}, true);
  const auto rows = order_rows(problem.op.rows, problem.blocks.surface.front().vertices);
  ASSERT_TRUE(rows);
  for (const OrderedRows::Run& run : rows->runs) {  // every inner vertex has valence 6
    EXPECT_EQ(run.length, 7U);
    EXPECT_EQ(run.weights, rows->runs.front().weights);
  }
  EXPECT_EQ(rows->runs.size(), rows->level_count());
}

// Levels too wide for columns of 16 bits: hubs whose spokes are more than these can tell apart.
TEST(OrderedRows, TakeWiderColumnsWhereLevelsAreWide) {
  constexpr Index kSpokes = 30000;
  const SparseRows rows = SparseRows::build(
      {}, kSpokes + 1, [](Index i) -> Index { return i == 0 ? kSpokes + 1 : 2; },
      [](Index i, std::span<Index> columns, std::span<double> weights) {
        std::iota(columns.begin(), columns.end(), Index{0});
        if (i != 0) columns[0] = i, columns[1] = 0;
        std::fill(weights.begin(), weights.end(), 1.0 / static_cast<double>(columns.size()));
      });
  std::vector<Index> all(kSpokes + 1);
  std::iota(all.begin(), all.end(), Index{0});
  const auto ordered = order_rows(rows, all);
  ASSERT_TRUE(ordered);
  EXPECT_FALSE(ordered->is_near());
  EXPECT_EQ(ordered->far.size(), std::size_t{3} * kSpokes + 1);
  LimitOperator op(kSpokes + 1);
  op.rows = rows;
  Block block;
  block.vertices = all;
  EXPECT_EQ(check_block(op, block, 3).ordered, 1);
}

}  // namespace
}  // namespace surpass::test

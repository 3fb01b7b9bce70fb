// Sweeps on ordered rows, against the plain ones: the same bits.
#include "interpolate/wavefront.hpp"

#include <surpass/io.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

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

// `count` plain sweeps; the errors of the point before the last one.
ErrorNorms plain_sweeps(const LinearSystem& system, std::span<const Wavefront::Sweep> sweeps,
                        std::vector<double>& newest, std::vector<double>& older) {
  ErrorNorms norms;
  for (const Wavefront::Sweep& sweep : sweeps) {
    norms = system.sweep(newest, older, sweep.momentum, sweep.step, true);
    std::swap(newest, older);
  }
  return norms;
}

// True if the block could be ordered.
bool check_block(const LimitOperator& op, Block block, std::size_t width) {
  if (block.vertices.empty()) return true;
  const auto rows = order_rows(op.rows, block.vertices);
  if (!rows) return false;
  block.spare = std::make_shared<SpareArrays>();
  const std::size_t count = op.rows.row_count() * width;
  const std::vector<double> target = values(count, 1);
  std::vector<double> x = values(count, 2);
  const Context context;
  const LinearSystem system{op, block, width, target, 0.25, context};
  Wavefront front(*rows, system, x);
  for (const Index v : block.vertices) {
    for (std::size_t c = 0; c < width; ++c) x[v * width + c] = target[v * width + c];
  }
  std::vector<double> older = x;
  std::vector<double> found = x;
  SemiIteration coefficients = SemiIteration::chebyshev(0.2);
  for (const int k : {1, 2, 5, 12}) {
    std::vector<Wavefront::Sweep> sweeps;
    for (int i = 0; i < k; ++i) {
      sweeps.push_back({coefficients.momentum(), coefficients.step()});
      coefficients.advance();
    }
    const ErrorNorms expected = plain_sweeps(system, sweeps, x, older);
    const auto errors = front.advance(sweeps);
    EXPECT_EQ(errors->last.max, expected.max);
    EXPECT_NEAR(errors->last.sum, expected.sum, 1e-12 * (1 + expected.sum));
    front.copy_newest(found);
    EXPECT_TRUE(same_bits(found, x));
    front.copy_measured(found);
    EXPECT_TRUE(same_bits(found, older));
  }
  return true;
}

void check_mesh(const Mesh& mesh, const Rules& rules, std::size_t& ordered, std::size_t& blocks) {
  for (const bool some_known : {false, true}) {
    const Problem problem = problem_of(mesh, rules, some_known);
    std::vector<const Block*> all = {&problem.blocks.curve};
    for (const Block& block : problem.blocks.surface) all.push_back(&block);
    for (const Block* block : all) {
      for (const std::size_t width : std::array<std::size_t, 3>{1, 3, 4})
        ordered += check_block(problem.op, *block, width);
      blocks += 3;
    }
  }
}

class WavefrontOf : public testing::TestWithParam<Scheme> {};

TEST_P(WavefrontOf, EverySweepHasTheBitsOfThePlainOne) {
  const Scheme scheme = GetParam();
  for (const double creases : {0.0, 0.1}) {
    std::size_t ordered = 0;
    std::size_t blocks = 0;
    for (int kind = 0; kind < 5; ++kind) {
      const Mesh mesh =
          random_mesh_for(scheme, {.seed = 7, .kind = kind, .size = 9, .creases = creases});
      check_mesh(mesh, {scheme, Boundary::edge_and_corner}, ordered, blocks);
    }
    // Curves at the end of which a dart looks at the surface may not be orderable.
    EXPECT_GE(static_cast<double>(ordered), (creases > 0 ? 0.7 : 1) * static_cast<double>(blocks));
  }
}

TEST_P(WavefrontOf, RealMeshesAsWell) {
  const Scheme scheme = GetParam();
  std::vector<std::string> paths = committed_meshes();
  for (const char* folder : {"tri", "quad"}) {
    const auto real = real_meshes(folder);
    paths.insert(paths.end(), real.begin(), real.end());
  }
  std::size_t ordered = 0;
  std::size_t blocks = 0;
  for (const std::string& path : paths) {
    const auto loaded = read_mesh(path);
    ASSERT_TRUE(loaded) << path;
    if (loaded->mesh.vertex_count() > 20000) continue;
    const Rules rules{scheme};
    if (!limit_positions(loaded->mesh, rules)) continue;  // not for this scheme
    SCOPED_TRACE(path);
    check_mesh(loaded->mesh, rules, ordered, blocks);
  }
  EXPECT_GT(ordered, 0.9 * static_cast<double>(blocks));
}

INSTANTIATE_TEST_SUITE_P(Schemes, WavefrontOf, testing::ValuesIn(all_schemes()),
                         [](const auto& scheme) {
                           std::string name = name_of(scheme.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

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
  EXPECT_TRUE(check_block(op, block, 3));
}

}  // namespace
}  // namespace surpass::test

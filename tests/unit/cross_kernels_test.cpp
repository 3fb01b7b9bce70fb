// The fast ways of the similarity of directions against its rows, one after the other.
#include "interpolate/cross_kernels.hpp"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "interpolate/lane_points.hpp"
#include "scheme/patch_rows.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

// A closed grid of quads refined once, and polygons with all sorts of corners.
PatchRows rows_of(const Mesh& given, Sides sides, int level = 1) {
  const Rules rules = {Scheme::catmull_clark};
  const Mesh refined = refine(given, rules, 1).value();
  const auto topology = Topology::build(refined).value();
  return PatchRows::build(refined, topology, rules, level, {}, {}, sides).value();
}
std::vector<PatchKind> kinds_of(const Mesh& given, Sides sides = Sides::shared) {
  return rows_of(given, sides).kinds();
}

Mesh quad_torus(Index nu, Index nv) {
  Mesh mesh;
  mesh.points.resize(std::size_t{nu} * nv);
  for (Index i = 0; i < nu; ++i) {
    for (Index j = 0; j < nv; ++j) {
      const Index a = (i + 1) % nu;
      const Index b = (j + 1) % nv;
      mesh.add_face(std::array{i * nv + j, a * nv + j, a * nv + b, i * nv + b});
    }
  }
  return mesh;
}

// Such a torus with edges turned, so that vertices have three to six faces.
Mesh turned_torus() {
  constexpr Index kSide = 12;
  const Mesh grid = quad_torus(kSide, kSide);
  Mesh mesh;
  mesh.points.resize(grid.points.size());
  const auto vertex = [](Index i, Index j) { return i % kSide * kSide + j % kSide; };
  for (Index i = 0; i < kSide; ++i) {
    for (Index j = 0; j < kSide; j += 2) {
      const Index a = vertex(i, j);
      const Index b = vertex(i, j + 1);
      const Index c = vertex(i, j + 2);
      const Index d = vertex(i + 1, j + 2);
      const Index e = vertex(i + 1, j + 1);
      const Index f = vertex(i + 1, j);
      // The second one shares a corner with the first.
      const bool turned = (i == 3 && j == 4) || (i == 4 && j == 6) || (i == 8 && j == 8);
      mesh.add_face(turned ? std::array{a, b, c, d} : std::array{a, b, e, f});
      mesh.add_face(turned ? std::array{a, d, e, f} : std::array{b, c, d, e});
    }
  }
  return mesh;
}

using Vector3 = std::array<double, 3>;

Vector3 derivative(const PatchKind& kind, std::size_t row, const std::vector<Vector3>& points) {
  Vector3 sum = {};
  for (std::size_t c = 0; c < kind.columns; ++c) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += kind.row(row)[c] * points[c][k];
  }
  return sum;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The law of all rows here: count / (|g|^2 + 0.3).
std::vector<Vector3> plain_gradient(const PatchKind& kind, const std::vector<Vector3>& reference,
                                    const std::vector<Vector3>& x) {
  std::vector<Vector3> sums(kind.columns, Vector3{});
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    if (kind.derivative[r] == Derivative::mixed) continue;
    const Vector3 g = derivative(kind, r, reference);
    const Vector3 turned = cross(cross(g, derivative(kind, r, x)), g);  // g x q x g
    const double weight = kind.count[r] / (dot(g, g) + 0.3);
    for (std::size_t c = 0; c < kind.columns; ++c) {
      for (std::size_t k = 0; k < 3; ++k) sums[c][k] += weight * kind.row(r)[c] * turned[k];
    }
  }
  return sums;
}

// Eight patches' points at random, a chance of their own for each, and what lanes hold of them.
struct Patches {
  std::vector<std::vector<Vector3>> points;
  std::vector<LaneVectors<double>> lanes;
};
Patches random_patches(std::size_t columns, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Patches patches{{kLanes<double>, std::vector<Vector3>(columns)},
                  std::vector<LaneVectors<double>>(columns)};
  for (std::size_t l = 0; l < kLanes<double>; ++l) {
    for (std::size_t c = 0; c < columns; ++c) {
      patches.points[l][c] = {uniform(random), uniform(random), 0.5};
      for (std::size_t k = 0; k < 3; ++k) patches.lanes[c].of[k][l] = patches.points[l][c][k];
    }
  }
  return patches;
}

// The same in the first lanes of registers in single precision.
std::vector<LaneVectors<float>> rounded(const std::vector<LaneVectors<double>>& lanes) {
  std::vector<LaneVectors<float>> single(lanes.size());
  for (std::size_t c = 0; c < lanes.size(); ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::copy_n(lanes[c].of[k], kLanes<double>, single[c].of[k]);
    }
  }
  return single;
}

void expect_plain_sums(const PatchKind& kind) {
  const CrossKind cross_kind(kind);
  std::vector<RowLaw<double>> laws;
  for (const CrossKind::Row& row : cross_kind.rows) laws.push_back({row.count, 1, 0.3});
  laws = scaled_laws(cross_kind, laws);
  std::mt19937_64 random(7);
  const Patches reference = random_patches(kind.columns, random);
  const Patches x = random_patches(kind.columns, random);
  std::vector<LaneVectors<double>> sums(kind.columns);
  std::vector<LaneVectors<double>> work(cross_kind.work_size());
  gradient_of_patches(cross_kind, laws.data(), reference.lanes.data(), x.lanes.data(), sums.data(),
                      work.data());
  std::vector<RowLaw<float>> single_laws;
  for (const RowLaw<double>& law : laws) {
    single_laws.push_back({static_cast<float>(law.numerator), static_cast<float>(law.slope),
                           static_cast<float>(law.constant)});
  }
  std::vector<LaneVectors<float>> single_sums(kind.columns);
  std::vector<LaneVectors<float>> single_work(cross_kind.work_size());
  gradient_of_patches(cross_kind, single_laws.data(), rounded(reference.lanes).data(),
                      rounded(x.lanes).data(), single_sums.data(), single_work.data());
  std::vector<LaneBlock<double>> blocks(kind.columns);
  diagonal_of_patches(cross_kind, laws.data(), reference.lanes.data(), blocks.data(), work.data());
  std::vector<LaneBlock<float>> single_blocks(kind.columns);
  diagonal_of_patches(cross_kind, single_laws.data(), rounded(reference.lanes).data(),
                      single_blocks.data(), single_work.data());
  std::vector<LaneNumbers> squares(cross_kind.rows.size());
  squares_of_patches(cross_kind, reference.lanes.data(), squares.data(), work.data());
  for (std::size_t l = 0; l < kLanes<double>; ++l) {
    const auto expected = plain_gradient(kind, reference.points[l], x.points[l]);
    for (std::size_t c = 0; c < kind.columns; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(sums[c].of[k][l], expected[c][k], 1e-11);
        ASSERT_NEAR(single_sums[c].of[k][l], expected[c][k], 1e-3);
      }
      // The block is the gradient at unit vectors of this point, of its own numbers.
      for (std::size_t k = 0; k < 3; ++k) {
        std::vector<Vector3> unit(kind.columns, Vector3{});
        unit[c][k] = 1;
        const Vector3 column = plain_gradient(kind, reference.points[l], unit)[c];
        constexpr std::size_t kUpper[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_NEAR(blocks[c].of[kUpper[i][k]][l], column[i], 1e-11);
          ASSERT_NEAR(single_blocks[c].of[kUpper[i][k]][l], column[i], 1e-3);
        }
      }
    }
    double sum = 0;
    double plain = 0;
    for (std::size_t r = 0; r < squares.size(); ++r) {
      const CrossKind::Row& row = cross_kind.rows[r];
      sum += row.count * row.scale * row.scale * squares[r].value[l];
    }
    for (std::size_t r = 0; r < kind.row_count(); ++r) {
      const Vector3 g = derivative(kind, r, reference.points[l]);
      if (kind.derivative[r] != Derivative::mixed) plain += kind.count[r] * dot(g, g);
    }
    ASSERT_NEAR(sum, plain, 1e-11 * plain);
  }
}

TEST(CrossKernels, RegularPatchesAreRefined) {
  const auto kinds = kinds_of(quad_torus(6, 5));
  ASSERT_EQ(kinds.size(), 1U);
  EXPECT_TRUE(CrossKind(kinds[0]).is_regular);
  expect_plain_sums(kinds[0]);
}

TEST(CrossKernels, OtherPatchesHaveTheirRows) {
  for (const PatchKind& kind : kinds_of(test::prism(5))) {
    EXPECT_FALSE(CrossKind(kind).is_regular);
    expect_plain_sums(kind);
  }
}

TEST(CrossKernels, StarsAreRefined) {
  const auto kinds = kinds_of(turned_torus(), Sides::joined);
  ASSERT_EQ(kinds.size(), 4U);
  std::set<std::size_t> stars;
  for (const PatchKind& kind : kinds) {
    SCOPED_TRACE(kind.columns);
    const std::size_t faces = CrossKind(kind).star;
    EXPECT_EQ(1 + 6 * faces, kind.columns);
    stars.insert(faces);
    expect_plain_sums(kind);
  }
  EXPECT_EQ(stars, (std::set<std::size_t>{3, 4, 5, 6}));
}

// The sums of squares of the derivatives of random values, by order, and how many there are.
std::vector<double> squares_by_order(const PatchRows& rows) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> x(1000);
  for (double& value : x) value = uniform(random);
  std::vector<double> sums(8);
  for (std::size_t p = 0; p < rows.patch_count(); ++p) {
    const PatchKind& kind = rows.kind(p);
    for (std::size_t r = 0; r < kind.row_count(); ++r) {
      double q = 0;
      for (std::size_t c = 0; c < kind.columns; ++c) q += kind.row(r)[c] * x[rows.columns(p)[c]];
      const auto order = static_cast<std::size_t>(kind.derivative[r]);
      sums[order] += kind.count[r] * q * q;
      sums[4 + order] += kind.area[r];
    }
  }
  return sums;
}

TEST(JoinedPatches, HaveTheSameSums) {
  Mesh creased = turned_torus();
  creased.creases = {{{0, 1}}, {{1, 2}}};
  for (const Mesh& given : {turned_torus(), creased, test::cube(), test::prism(5)}) {
    for (const int level : {1, 2}) {
      const PatchRows joined = rows_of(given, Sides::joined, level);
      const PatchRows shared = rows_of(given, Sides::shared, level);
      const auto sums = squares_by_order(joined);
      const auto expected = squares_by_order(shared);
      for (std::size_t k = 0; k < sums.size(); ++k) {
        EXPECT_NEAR(sums[k], expected[k], 1e-12 * expected[k]);
      }
      std::vector<std::size_t> faces(joined.patch_count());
      for (const Index p : joined.patches_of_faces()) ++faces[p];
      for (std::size_t p = 0; p < faces.size(); ++p) {
        EXPECT_EQ(joined.kind(p).columns == 1 + 6 * faces[p], faces[p] > 1);
      }
    }
  }
}

// In single precision from the first point of each lane; there and back again without that.
template <class Real>
void expect_there_and_back() {
  constexpr std::size_t kColumns = 3;
  constexpr bool kRelative = std::is_same_v<Real, float>;
  std::vector<LocalIndex> local;
  for (unsigned k = 0; k < kLanes<Real> * kColumns; ++k) {
    local.push_back(static_cast<LocalIndex>((5 * k) % 11));
  }
  std::vector<double> x;
  for (int k = 0; k < 11 * 4; ++k) x.push_back(k % 4 == 3 ? 0 : k + 0.25);
  for (std::size_t lanes = 1; lanes <= kLanes<Real>; ++lanes) {
    std::vector<LaneVectors<Real>> points(kColumns);
    gather_points(local.data(), kColumns, lanes, x.data(), points.data());
    std::vector<Real> y(x.size());
    std::vector<Real> expected(x.size());
    scatter_points(local.data(), kColumns, lanes, points.data(), y.data());
    for (std::size_t l = 0; l < kLanes<Real>; ++l) {
      const std::size_t first = kPointStride * local[l * kColumns];
      for (std::size_t c = 0; c < kColumns; ++c) {
        const std::size_t at = kPointStride * local[l * kColumns + c];
        for (std::size_t k = 0; k < 3; ++k) {
          const auto wanted = static_cast<Real>(x[at + k] - (kRelative ? x[first + k] : 0));
          EXPECT_EQ(points[c].of[k][l], l < lanes ? wanted : 0);
          if (l < lanes) expected[at + k] += wanted;
        }
      }
    }
    EXPECT_EQ(y, expected) << lanes;
  }
}

TEST(LanePoints, GoThereAndBack) {
  expect_there_and_back<double>();
  expect_there_and_back<float>();
}

}  // namespace
}  // namespace surpass

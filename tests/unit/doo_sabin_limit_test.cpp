// Limit points of Doo-Sabin surfaces: against the scheme's own refinement, and the operator's
// facts.

#include "doo_sabin_samples.hpp"
#include "scheme/doo_sabin.hpp"
#include "support/dense.hpp"

namespace surpass::test {
namespace {

double spread(const std::vector<Point>& points) {
  double most = 0;
  for (const Point& p : points) most = std::max(most, distance(p, points.front()));
  return most;
}

// The centroid at a site never moves, and the refined vertices there close in on it; so it is the
// limit.
TEST(DooSabinLimit, IsWhereTheRefinedVerticesGo) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto limit = limit_positions(sample.mesh, rules);
    ASSERT_TRUE(limit) << describe(limit.error());
    const double side = bounding_box(sample.mesh.points).side();
    const int levels = affordable_levels(sample.mesh, 6);
    const auto coarse = refined_level(sample.mesh, rules, 2);
    const auto fine = refined_level(sample.mesh, rules, levels);
    for (Index v = 0; v < sample.mesh.vertex_count(); ++v) {
      const auto near = points_at(fine, fine.sites[v]);
      EXPECT_LT(distance(mean(near), (*limit)[v]), 1e-12 * side) << "vertex " << v;
      const double before = spread(points_at(coarse, coarse.sites[v]));
      EXPECT_LE(spread(near), before * std::pow(0.75, levels - 2)) << "vertex " << v;
    }
  });
}

TEST(DooSabinLimit, IsTestedOnEveryKindOfVertex) {
  std::array<int, 5> kinds = {};
  int lenses = 0;
  for (const Sample& sample : polygon_samples()) {
    const auto topology = Topology::build(sample.mesh).value();
    const auto layout =
        doo_sabin::Layout::build(sample.mesh, topology, Boundary::edge_only, {}).value();
    for (Index v = 0; v < topology.vertex_count(); ++v) {
      ++kinds[static_cast<std::size_t>(layout.kind(v))];
    }
    for (Index h = 0; h < topology.corner_count(); ++h) lenses += layout.is_lens(h) ? 1 : 0;
    if (sample.name == "doublets") {
      EXPECT_GT(kinds[static_cast<std::size_t>(doo_sabin::VertexKind::doublet)], 0);
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 0);
  EXPECT_GT(lenses, 0);
}

TEST(DooSabinLimit, HasRowsThatSumToOneCenterFirst) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto topology = Topology::build(sample.mesh).value();
    const auto op = limit_operator(sample.mesh, topology, rules, {}).value();
    for (Index v = 0; v < topology.vertex_count(); ++v) {
      const auto w = op.rows.row_weights(v);
      EXPECT_NEAR(std::accumulate(w.begin(), w.end(), 0.0), 1, 1e-14);
      EXPECT_EQ(op.rows.row_columns(v)[0], v);
      EXPECT_EQ(std::count(op.rows.row_columns(v).begin(), op.rows.row_columns(v).end(), v), 1);
    }
  });
}

// diag(d) L among the rows of one kind: symmetric, eigenvalues of L in [bound, 1].
void check_block(const LimitOperator& op, bool curve) {
  std::vector<Index> rows;
  double bound = 1;
  for (Index v = 0; v < op.rows.row_count(); ++v) {
    const bool fixed = curve && op.lowest_eigenvalue[v] == 1;
    if (fixed || (op.on_curve[v] != 0) != curve || op.symmetric_weight[v] == 0) continue;
    rows.push_back(v);
    bound = std::min(bound, op.lowest_eigenvalue[v]);
  }
  if (rows.empty()) return;
  test::Dense scaled(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Index v = rows[i];
    for (std::size_t k = 0; k < op.rows.row_columns(v).size(); ++k) {
      const Index u = op.rows.row_columns(v)[k];
      const auto at = std::lower_bound(rows.begin(), rows.end(), u);
      if (at == rows.end() || *at != u) continue;
      scaled(i, static_cast<std::size_t>(at - rows.begin())) +=
          std::sqrt(op.symmetric_weight[v] / op.symmetric_weight[u]) * op.rows.row_weights(v)[k];
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(scaled(i, j), scaled(j, i), 1e-13);
  }
  const std::vector<double> spectrum = test::symmetric_eigenvalues(scaled);
  EXPECT_GE(spectrum.front(), bound - 1e-12);
  EXPECT_LE(spectrum.back(), 1 + 1e-12);
}

TEST(DooSabinLimit, HasTheSpectrumThatTheOperatorClaims) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto topology = Topology::build(sample.mesh).value();
    const auto op = limit_operator(sample.mesh, topology, rules, {}).value();
    check_block(op, false);
    check_block(op, true);
  });
}

TEST(DooSabinLimit, AttainsItsBoundOnTheCube) {
  const auto topology = Topology::build(cube()).value();
  const auto op = limit_operator(cube(), topology, {.scheme = Scheme::doo_sabin}, {}).value();
  EXPECT_EQ(op.lowest_eigenvalue[0], 0.25);
  EXPECT_EQ(op.symmetric_weight[0], 3);
}

TEST(DooSabinLimit, CommutesWithAffineMaps) {
  const auto map = [](const Point& p) {
    return Point{2 * p[0] - p[1] + 3, p[0] + 0.5 * p[2] - 7, p[1] - 3 * p[2] + 0.25};
  };
  for_every_sample([&](const Sample& sample, const Rules& rules) {
    Mesh moved = sample.mesh;
    for (Point& p : moved.points) p = map(p);
    auto expected = limit_positions(sample.mesh, rules).value();
    for (Point& p : expected) p = map(p);
    EXPECT_LT(max_distance(limit_positions(moved, rules).value(), expected), 1e-12);
  });
}

// The first corner of a face has no meaning.
TEST(DooSabinLimit, DoesNotDependOnTheFirstCornersOfFaces) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    Mesh turned = sample.mesh;
    for (Index f = 0; f < turned.face_count(); ++f) {
      const auto begin = turned.face_vertices.begin() + turned.face_offsets[f];
      const auto size = turned.face_offsets[f + 1] - turned.face_offsets[f];
      std::rotate(begin, begin + 1 + f % (size - 1), begin + size);
    }
    EXPECT_LT(max_distance(limit_positions(turned, rules).value(),
                           limit_positions(sample.mesh, rules).value()),
              1e-13);
    if (!sample.has_normals) return;
    EXPECT_LT(max_distance(limit_normals(turned, rules).value(),
                           limit_normals(sample.mesh, rules).value()),
              1e-10);
  });
}

TEST(DooSabinLimit, IsInterpolatedByItsControlMesh) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto result = interpolate(sample.mesh, {.rules = rules, .tolerance = 1e-12});
    ASSERT_TRUE(result) << describe(result.error());
    const auto limit = limit_positions(result->control, rules).value();
    EXPECT_LT(max_distance(limit, sample.mesh.points),
              1e-11 * bounding_box(sample.mesh.points).side());
  });
}

TEST(DooSabinLimit, RefusesSemiSharpElementsAndNamesThem) {
  const Rules rules{.scheme = Scheme::doo_sabin};
  Mesh mesh = cube();
  mesh.creases.push_back({{4, 5}, 2.5F});
  const auto edge = limit_positions(mesh, rules);
  ASSERT_FALSE(edge);
  EXPECT_EQ(edge.error().code, ErrorCode::unsuitable_for_scheme);
  ASSERT_TRUE(edge.error().place.edge);
  EXPECT_EQ(*edge.error().place.edge, (std::array<Index, 2>{4, 5}));
  for (const auto& error : {refine(mesh, rules, 1).error(), limit_normals(mesh, rules).error(),
                            limit_mesh(mesh, rules, 2).error()}) {
    EXPECT_EQ(error.code, ErrorCode::unsuitable_for_scheme);
  }
  mesh.creases.clear();
  mesh.corners.push_back({6, 1.0F});
  const auto vertex = limit_positions(mesh, rules);
  ASSERT_FALSE(vertex);
  EXPECT_EQ(vertex.error().code, ErrorCode::unsuitable_for_scheme);
  EXPECT_EQ(vertex.error().place.vertex, 6U);
}

TEST(DooSabinLimit, RefusesTheBoundaryRulesOfLoop) {
  for (const Boundary boundary : {Boundary::hoppe, Boundary::interior}) {
    const Rules rules{.scheme = Scheme::doo_sabin, .boundary = boundary};
    EXPECT_FALSE(limit_positions(cube(), rules));
    EXPECT_FALSE(limit_mesh(cube(), rules, 1));
  }
}

}  // namespace
}  // namespace surpass::test

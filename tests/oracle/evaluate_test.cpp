// The surface between its vertices, against OpenSubdiv's evaluator.
#include <tuple>

#include <gtest/gtest.h>

#include "mesh/select.hpp"
#include "osd.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Inside, on edges, and close to corners.
constexpr std::array<std::array<double, 2>, 9> kParameters = {{{0.5, 0.25},
                                                               {0.3, 0.8},
                                                               {0.9, 0.6},
                                                               {0.4, 0.0},
                                                               {1.0, 0.7},
                                                               {0.02, 0.01},
                                                               {1e-3, 2e-3},
                                                               {1 - 2e-3, 1e-3},
                                                               {1 - 1e-3, 1 - 2e-3}}};

std::vector<SurfacePlace> places_on(const Mesh& mesh) {
  std::vector<SurfacePlace> places;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto m = static_cast<Index>(mesh.face(f).size());
    for (const auto& [u, v] : kParameters) {
      if (m == 4) places.push_back({f, u, v});
      for (Index corner = 0; m != 4 && corner < m; ++corner) places.push_back({f, u, v, corner});
    }
  }
  return places;
}

// The rounding of its refined points, which it does not avoid: second differences, of four points,
// at distance h from an irregular vertex divide it by h^2. That ours stay exact is shown by deep
// refinement below.
double their_rounding(double u, double v) {
  const double h = std::max(std::min(u, 1 - u), std::min(v, 1 - v));
  return 16 * std::numeric_limits<double>::epsilon() / (h * h);
}

// Relative to the mesh and to the largest derivative of the order: near irregular vertices second
// derivatives grow.
void expect_same_surface(const Mesh& mesh, const Rules& rules, double tolerance) {
  const test::OsdSurface theirs(mesh, rules);
  const auto places = places_on(mesh);
  const auto ours = LimitSurface::create(mesh, rules).value().evaluate(places).value();
  const double size = bounding_box(mesh.points).side();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto expected = theirs.evaluate(places[i]);
    if (!expected) continue;
    const auto [face, u, v, corner] = places[i];
    SCOPED_TRACE(testing::Message()
                 << "face " << face << " (" << u << ", " << v << ") corner " << corner);
    EXPECT_LT(distance(ours[i].position, expected->position), tolerance * size);
    const double first = std::max({size, norm(expected->du), norm(expected->dv)});
    EXPECT_LT(distance(ours[i].du, expected->du), tolerance * first);
    EXPECT_LT(distance(ours[i].dv, expected->dv), tolerance * first);
    ASSERT_TRUE(ours[i].second && expected->second);
    const auto& [uu, uv, vv] = *ours[i].second;
    const auto& s = *expected->second;
    const double second = tolerance * std::max({size, norm(s.uu), norm(s.uv), norm(s.vv)}) +
                          their_rounding(u, v) * size;
    EXPECT_LT(distance(uu, s.uu), second);
    EXPECT_LT(distance(uv, s.uv), second);
    EXPECT_LT(distance(vv, s.vv), second);
    if (testing::Test::HasFailure()) return;
  }
}

class EvaluateAgainstOpenSubdiv : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  void expect_same(double creases, bool semi_sharp, double tolerance) const {
    const auto [kind, seed] = GetParam();
    const Mesh mesh = test::random_polygons({.seed = static_cast<std::uint64_t>(seed),
                                             .kind = kind,
                                             .creases = creases,
                                             .semi_sharp = semi_sharp});
    expect_same_surface(mesh, Rules{Scheme::catmull_clark, Boundary::edge_only}, tolerance);
    expect_same_surface(mesh, Rules{Scheme::catmull_clark, Boundary::edge_and_corner}, tolerance);
  }
};

TEST_P(EvaluateAgainstOpenSubdiv, SmoothMeshes) { expect_same(0, false, 1e-12); }

TEST_P(EvaluateAgainstOpenSubdiv, SharpCreases) { expect_same(0.15, false, 1e-12); }

TEST_P(EvaluateAgainstOpenSubdiv, SemiSharpCreases) { expect_same(0.15, true, 1e-12); }

INSTANTIATE_TEST_SUITE_P(RandomMeshes, EvaluateAgainstOpenSubdiv,
                         testing::Combine(testing::Range(0, 5), testing::Range(0, 2)));

bool has_doublets(const Mesh& mesh) {
  const Topology topology = Topology::build(mesh).value();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!topology.is_boundary(v) && topology.faces_at(v) == 2) return true;
  }
  return false;
}

// OpenSubdiv's evaluator writes out of bounds at interior vertices of valence 2. The surface beside
// those is compared with refined meshes' limit points in tests/unit.
TEST(EvaluateAgainstOpenSubdiv, EveryKindOfVertexButDoublets) {
  for (const test::Sample& sample : test::polygon_samples()) {
    if (has_doublets(sample.mesh)) continue;
    SCOPED_TRACE(sample.name);
    for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
      expect_same_surface(sample.mesh, Rules{Scheme::catmull_clark, boundary}, 1e-12);
    }
  }
}

TEST(EvaluateAgainstOpenSubdiv, QuadsOfEveryValence) {
  for (const Index n : {3U, 5U, 6U, 9U, 17U}) {
    const Rules rules{Scheme::catmull_clark, Boundary::edge_only};
    std::mt19937_64 random(n);
    const Mesh mesh = test::jitter(refine(test::bipyramid(n), rules, 1).value(), random, 0.05);
    expect_same_surface(mesh, rules, 1e-12);
  }
}

// Deep refinement around vertex 0, corner 0 of face 0: the faces in two rings about it determine
// theirs after a step. With the vertex's limit at the origin, points keep all their digits however
// close they come.
Mesh two_rings(const Mesh& mesh) {
  std::vector<unsigned char> in_reach(mesh.vertex_count(), 0);
  in_reach[0] = 1;
  std::vector<Index> faces;
  for (int ring = 0; ring < 2; ++ring) {
    faces.clear();
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      if (std::any_of(face.begin(), face.end(), [&](Index v) { return in_reach[v] != 0; })) {
        faces.push_back(f);
      }
    }
    for (const Index f : faces) {
      for (const Index v : mesh.face(f)) in_reach[v] = 1;
    }
  }
  Selection selection = Selection::of_vertices(in_reach);
  for (const Index f : faces) selection.add_face(mesh, f);
  return select(mesh, std::move(selection));
}

void move_limit_to_origin(Mesh& mesh, const Rules& rules) {
  const Point origin = limit_positions(mesh, rules).value()[0];
  for (Point& p : mesh.points) {
    for (std::size_t c = 0; c < 3; ++c) p[c] -= origin[c];
  }
}

// First derivatives at (u, v) / 2^levels and second ones, from refined points by OpenSubdiv and
// directly. Positions are told by their distance from the vertex.
void expect_exact_at_any_distance(Mesh mesh, const Rules& rules) {
  constexpr std::array<double, 2> kFar = {0.8, 0.35};
  move_limit_to_origin(mesh, rules);
  const LimitSurface surface = LimitSurface::create(mesh, rules).value();
  Mesh fine = mesh;
  for (int level = 1; level <= 40; ++level) {
    fine = two_rings(refine(fine, rules, 1).value());
    move_limit_to_origin(fine, rules);
    if (level % 8 != 0) continue;
    SCOPED_TRACE(testing::Message() << "level " << level);
    const double shrink = std::ldexp(1.0, -level);
    const auto ours = surface.evaluate({0, kFar[0] * shrink, kFar[1] * shrink}).value();
    const auto theirs = test::OsdSurface(fine, rules).evaluate({0, kFar[0], kFar[1]}).value();
    EXPECT_LT(distance(ours.position, theirs.position), 1e-15 * bounding_box(mesh.points).side());
    const double first = std::max(norm(theirs.du), norm(theirs.dv));
    const auto& s = *theirs.second;
    // Where second derivatives stay bounded, the rounding of the first ones outgrows them.
    const double second = 1e-12 * std::max({norm(s.uu), norm(s.uv), norm(s.vv)}) +
                          16 * std::numeric_limits<double>::epsilon() * first;
    const auto scaled = [&](const Point& p, double factor) {
      return Point{p[0] * factor, p[1] * factor, p[2] * factor};
    };
    EXPECT_LT(distance(scaled(ours.du, shrink), theirs.du), 1e-13 * first);
    EXPECT_LT(distance(scaled(ours.dv, shrink), theirs.dv), 1e-13 * first);
    const double square = shrink * shrink;
    EXPECT_LT(distance(scaled(ours.second->uu, square), s.uu), second);
    EXPECT_LT(distance(scaled(ours.second->uv, square), s.uv), second);
    EXPECT_LT(distance(scaled(ours.second->vv, square), s.vv), second);
  }
}

// The last vertex of a bipyramid's upper half, refined once, as vertex 0.
Mesh around_apex(Index n, double creases) {
  Mesh mesh;
  mesh.points = {{0.2, -0.1, 0.9}};
  for (Index i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    mesh.points.push_back({std::cos(t), std::sin(t), 0.3 * std::sin(2.0 * i)});
  }
  for (Index i = 0; i < n; ++i) mesh.add_face(std::vector<Index>{0, 1 + i, 1 + (i + 1) % n});
  for (Index i = 0; i < static_cast<Index>(creases); ++i) mesh.creases.push_back({{0, 1 + 2 * i}});
  Mesh quads = refine(mesh, {Scheme::catmull_clark}, 1).value();
  return refine(quads, {Scheme::catmull_clark}, 1).value();
}

TEST(EvaluateDeep, SmoothVerticesOfEveryValence) {
  for (const Index n : {3U, 5U, 6U, 8U, 20U}) {
    SCOPED_TRACE(n);
    expect_exact_at_any_distance(around_apex(n, 0), {Scheme::catmull_clark});
  }
}

TEST(EvaluateDeep, DartsCreasesAndCorners) {
  for (const Index creases : {1U, 2U, 3U}) {
    SCOPED_TRACE(creases);
    expect_exact_at_any_distance(around_apex(7, creases), {Scheme::catmull_clark});
  }
}

TEST(EvaluateDeep, BoundaryVerticesOfManyFaces) {
  for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
    for (const Index faces : {1U, 3U, 5U}) {
      Mesh mesh;
      mesh.points.push_back({0, 0, 0});
      for (Index i = 0; i <= 2 * faces; ++i) {
        const double t = M_PI * i / (2 * faces + 1);
        const double r = i % 2 == 0 ? 1 : 1.4;
        mesh.points.push_back({r * std::cos(t), r * std::sin(t), 0.2 * std::sin(3.0 * i)});
      }
      for (Index i = 0; i < faces; ++i) {
        mesh.add_face(std::vector<Index>{0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
      }
      const Rules rules{Scheme::catmull_clark, boundary};
      expect_exact_at_any_distance(refine(mesh, rules, 1).value(), rules);
    }
  }
}

}  // namespace
}  // namespace surpass

// Boundaries, creases and corners of non-stationary Loop surfaces, and what is refused.
#include <algorithm>

#include <gtest/gtest.h>

#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

using test::largest_error;
using test::made;
using test::side;

/// Fans are of size 1 around the origin; the others have many ulps.
double close(const Mesh& mesh) { return (mesh.vertex_count() <= 10 ? 4e-16 : 1e-14) * side(mesh); }

std::vector<Mesh> open_meshes() {
  return {test::wavy_fan(6),
          test::wavy_fan(5, true),
          test::wavy_fan(9),
          test::wavy_fan(4, true),
          test::triangle_grid(5, 4),
          test::random_mesh({.seed = 2, .kind = 2, .size = 6}),
          test::random_mesh({.seed = 3, .kind = 3, .size = 7})};
}

TEST(NonstationaryCurves, PassThroughTheirVerticesTogetherWithTheSurface) {
  for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
    for (const Mesh& mesh : open_meshes()) {
      for (const double shape : {-3.0, 0.0}) {
        for (const int steps : {1, 2, 3, 5}) {
          const auto surface =
              made(mesh, {.shape = shape, .boundary = boundary, .steps = steps}, steps);
          EXPECT_LE(largest_error(surface.mesh().points, mesh.points), close(mesh));
        }
        auto surface = made(mesh, {.shape = shape, .boundary = boundary});
        for (int level = 0; level <= 3; ++level) {
          EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), close(mesh));
          ASSERT_TRUE(surface.refine());
        }
      }
    }
  }
}

// Among them are the vertices beside boundary vertices that have other than three faces.
TEST(NonstationaryCurves, LimitsAndNormalsAreTheSameAtEveryLevel) {
  // Corners of more than two faces have no normals.
  const NonstationaryOptions smooth{.shape = -2, .corners_at_folds = false};
  for (const Mesh& mesh : open_meshes()) {
    auto surface = made(mesh, smooth, 1);
    const auto limits = surface.limit_positions().value();
    const auto normals = surface.limit_normals().value();
    for (int level = 2; level <= 4; ++level) {
      ASSERT_TRUE(surface.refine());
      EXPECT_LE(largest_error(surface.limit_positions().value(), limits), 1e-14 * side(mesh));
      EXPECT_LE(largest_error(surface.limit_normals().value(), normals), 1e-11);
    }
    const auto given = made(mesh, smooth).limit_normals().value();
    EXPECT_LE(largest_error(normals, given), 0);
  }
}

TEST(NonstationaryCurves, HaveTheReferenceNormals) {
  const Mesh mesh = test::wavy_fan(6);
  const auto at = [&](int steps) {
    return made(mesh, {.steps = steps}, 1).limit_normals().value();
  };
  const Point limit = {0.495311716989647, 0, 0.868715317588431};
  const Point seven = {0.495346244145087, 0, 0.868695630477876};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(at(0)[1][c], limit[c], 1e-12);
    EXPECT_NEAR(at(7)[1][c], seven[c], 1e-12);
    EXPECT_NEAR(at(0)[0][c], c == 2 ? 1 : 0, 1e-12);
  }
}

TEST(NonstationaryCurves, DependOnTheirVerticesAlone) {
  Mesh one = test::wavy_fan(7);
  Mesh other = one;
  other.points[0] = {0.3, -0.2, 5};
  const auto a = made(one, {.shape = -2}, 3).mesh();
  const auto b = made(other, {.shape = 1}, 3).mesh();
  const auto topology = Topology::build(a).value();
  std::size_t compared = 0;
  for (Index v = 0; v < a.vertex_count(); ++v) {
    if (!topology.is_boundary(v)) continue;
    EXPECT_EQ(a.points[v], b.points[v]);
    ++compared;
  }
  EXPECT_EQ(compared, 7 * 8);
}

TEST(NonstationaryCurves, AreExactForCubics) {
  constexpr Index kLength = 12;
  const auto cubic = [](double x) { return 0.3 * x * x * x - 0.2 * x * x + x; };
  Mesh mesh;
  for (const double below : {20.0, 0.0}) {
    for (Index i = 0; i < kLength; ++i) {
      const double x = i - kLength / 2.0;
      mesh.points.push_back({x, cubic(x) - below, 0});
    }
  }
  for (Index i = 0; i + 1 < kLength; ++i) {
    mesh.add_face(std::vector<Index>{i, i + 1, kLength + i});
    mesh.add_face(std::vector<Index>{i + 1, kLength + i + 1, kLength + i});
  }
  const auto surface = made(mesh, {}, 4);
  const auto limits = surface.limit_positions().value();
  const auto topology = Topology::build(surface.mesh()).value();
  std::size_t compared = 0;
  for (Index v = 0; v < limits.size(); ++v) {
    const auto [x, y, z] = limits[v];
    if (!topology.is_boundary(v) || std::abs(x) > 2.5 || y < cubic(x) - 5) continue;
    EXPECT_NEAR(y, cubic(x), 4e-15);
    ++compared;
  }
  EXPECT_GE(compared, 5 * 16);
}

TEST(NonstationaryCurves, StayThePolygonWhereAllVerticesAreCorners) {
  Mesh mesh = test::wavy_fan(4);
  for (Index v = 1; v <= 4; ++v) mesh.corners.push_back({v});
  for (Index v = 1; v <= 4; ++v) mesh.points[v][2] = 0;
  const auto surface = made(mesh, {.shape = -2}, 4);
  const auto limits = surface.limit_positions().value();
  const auto topology = Topology::build(surface.mesh()).value();
  for (Index v = 0; v < limits.size(); ++v) {
    if (!topology.is_boundary(v)) continue;
    EXPECT_NEAR(std::abs(limits[v][0]) + std::abs(limits[v][1]), 1, 1e-15);
  }
  EXPECT_LE(largest_error(limits, mesh.points), 4e-16);
}

// The smallest radius on regular polygons, from the independent implementation.
TEST(NonstationaryCurves, AreRoundOnRegularPolygons) {
  for (const auto& [n, radius] :
       {std::pair(4, 0.9035), std::pair(6, 0.9803), std::pair(8, 0.9937), std::pair(12, 0.9988)}) {
    Mesh mesh = test::wavy_fan(static_cast<Index>(n));
    for (Point& p : mesh.points) p[2] = 0;
    const auto surface = made(mesh, {}, 5);
    const auto limits = surface.limit_positions().value();
    const auto topology = Topology::build(surface.mesh()).value();
    double smallest = 2;
    for (Index v = 0; v < limits.size(); ++v) {
      if (topology.is_boundary(v)) {
        smallest = std::min(smallest, std::hypot(limits[v][0], limits[v][1]));
      }
    }
    EXPECT_NEAR(smallest, radius, 5.1e-5);
  }
}

TEST(NonstationaryCurves, NormalsAreThoseThatFacesTendTo) {
  for (const Index faces : {1U, 2U, 3U, 4U, 5U}) {
    // Vertex 0 has so many faces on the boundary.
    Mesh mesh;
    mesh.points = {{0, 0, 0}};
    for (Index i = 0; i <= faces; ++i) {
      const double t = M_PI * (0.1 + 0.8 * i / faces);
      mesh.points.push_back({std::cos(t), std::sin(t), 0.2 * ((5 * i) % 3)});
    }
    for (Index i = 0; i < faces; ++i) mesh.add_face(std::vector<Index>{0, 1 + i, 2 + i});
    auto surface = made(mesh, {.shape = -2, .boundary = Boundary::edge_only}, 5);
    const std::vector<Point> normal = {surface.limit_normals().value()[0]};
    const double before = test::worst_angle(surface.mesh(), normal);
    for (int level = 6; level <= 8; ++level) ASSERT_TRUE(surface.refine());
    const double angle = test::worst_angle(surface.mesh(), normal);
    // With five faces the slowest mode beside the tangents has 0.9 of their eigenvalue.
    EXPECT_LE(angle, 0.75 * before + 1e-5) << faces;
    EXPECT_LE(angle, 4) << faces;
  }
}

TEST(NonstationaryCurves, CreasesAreCurves) {
  // The equator of a double pyramid: each half is the surface of that half alone.
  constexpr Index kRim = 8;
  Mesh whole = test::reference_bipyramid(kRim, 0.8, 0.7);
  for (Index i = 0; i < kRim; ++i) {
    whole.creases.push_back({{2 + i, 2 + (i + 1) % kRim}});
  }
  Mesh half = whole;
  half.creases.clear();
  half.face_vertices.clear();
  half.face_offsets = {0};
  for (Index f = 0; f < whole.face_count(); f += 2) half.add_face(whole.face(f));
  for (const int steps : {0, 3}) {
    const auto a = made(whole, {.steps = steps}, 3);
    const auto b = made(half, {.steps = steps}, 3);
    const auto points_of = [&](const NonstationaryLoop& s) {
      auto points = steps == 0 ? s.limit_positions().value() : s.mesh().points;
      std::sort(points.begin(), points.end());
      return points;
    };
    EXPECT_LE(
        largest_error(steps == 0 ? a.limit_positions().value() : a.mesh().points, whole.points),
        4e-16 * side(whole));
    const auto of_whole = points_of(a);
    for (const Point& p : points_of(b)) {
      const auto near =
          std::min_element(of_whole.begin(), of_whole.end(), [&](const Point& x, const Point& y) {
            const auto far = [&](const Point& q) {
              return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
            };
            return far(x) < far(y);
          });
      EXPECT_LE(std::hypot((*near)[0] - p[0], (*near)[1] - p[1], (*near)[2] - p[2]), 1e-15);
    }
  }
}

TEST(NonstationaryCurves, AnInteriorCornerStays) {
  Mesh mesh = test::icosahedron();
  mesh.corners = {{4}};
  auto surface = made(mesh, {}, 3);
  EXPECT_EQ(surface.mesh().points[4], mesh.points[4]);
  EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), 1e-15);
}

Error refused(const Mesh& mesh, const NonstationaryOptions& options = {}) {
  const auto found = NonstationaryLoop::create(mesh, options);
  EXPECT_FALSE(found);
  return found ? Error{} : found.error();
}

TEST(NonstationaryErrors, NameTheElement) {
  Mesh mesh = test::icosahedron();
  mesh.creases = {{{0, 11}}};
  EXPECT_EQ(refused(mesh).place.vertex, 0);
  EXPECT_EQ(refused(mesh).code, ErrorCode::unsuitable_for_scheme);
  mesh.creases[0].sharpness = 2;
  EXPECT_EQ(refused(mesh).place.edge, (std::array<Index, 2>{0, 11}));
  mesh.creases.clear();
  mesh.corners = {{3, 1.5F}};
  EXPECT_EQ(refused(mesh).place.vertex, 3);

  Mesh pillow = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(refused(pillow).place.vertex, 0);
  Mesh quad = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_EQ(refused(quad).place.face, 0);
  EXPECT_EQ(refused(test::wavy_fan(5), {.targets = {{2, 0.1}}}).place.vertex, 2);
  EXPECT_EQ(refused(test::wavy_fan(5), {.targets = {{0, 0.1}, {0, 0.2}}}).place.vertex, 0);
  EXPECT_EQ(refused(test::wavy_fan(5), {.targets = {{0, 0.5}}}).place.vertex, 0);
  EXPECT_EQ(refused(test::wavy_fan(5), {.targets = {{9, 0.1}}}).place.vertex, 9);
  EXPECT_EQ(refused(test::wavy_fan(5), {.rule = NonstationaryRule::mean}).place.vertex, 1);
  EXPECT_EQ(refused(test::tetrahedron(), {.vertex_parameters = {0, 0, NAN, 0}}).place.vertex, 2);
}

TEST(NonstationaryErrors, TellWhatOptionsMayBe) {
  const auto says = [](const NonstationaryOptions& options, const char* words) {
    const Error error = refused(test::tetrahedron(), options);
    EXPECT_EQ(error.code, ErrorCode::invalid_argument);
    EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
  };
  says({.shape = NAN}, "must be a number");
  says({.boundary = Boundary::hoppe}, "edge-only and edge-and-corner");
  says({.steps = -1}, "0 (the limit) or more");
  says({.rate = 0.5}, "above 1");
  says({.iteration = ParameterIteration::exponential}, "above -1");
  EXPECT_EQ(refused(test::tetrahedron(), {.vertex_parameters = {1}}).code, ErrorCode::mismatch);
}

TEST(NonstationaryErrors, ShapesOutsideAreMovedWithANote) {
  const auto tetrahedron = made(test::tetrahedron(), {.shape = 3});
  EXPECT_EQ(tetrahedron.shape(), kHighestShapeAtValence3);
  ASSERT_EQ(tetrahedron.notes().size(), 1);
  EXPECT_NE(tetrahedron.notes()[0].find("valence 3"), std::string::npos);
  EXPECT_EQ(made(test::icosahedron(), {.shape = 3}).shape(), 3);
  EXPECT_EQ(made(test::icosahedron(), {.shape = -7}).shape(), kLowestShape);
  EXPECT_TRUE(made(test::icosahedron(), {.shape = 3}).notes().empty());
}

}  // namespace
}  // namespace surpass

// Catmull-Clark operators that are singular or indefinite: found, named, and solved where the data
// allows it.
#include <algorithm>

#include <gtest/gtest.h>

#include "interpolate/singular_parts.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

const Rules kCatmullClark{Scheme::catmull_clark, Boundary::edge_and_corner};

Mesh moved_cube() {
  Mesh cube = test::cube();
  cube.points[0][2] += 0.1;
  return cube;
}

// Several meshes as one, in order.
Mesh together(const std::vector<Mesh>& parts) {
  Mesh all;
  for (const Mesh& part : parts) {
    const Index first = all.vertex_count();
    for (const Point& p : part.points) {
      all.points.push_back({p[0] + 5 * static_cast<double>(first), p[1], p[2]});
    }
    for (Index f = 0; f < part.face_count(); ++f) {
      std::vector<Index> face(part.face(f).begin(), part.face(f).end());
      for (Index& v : face) v += first;
      all.add_face(face);
    }
  }
  return all;
}

std::vector<SingularPart> singular_parts_of(const Mesh& mesh, const Rules& rules) {
  const auto topology = Topology::build(mesh).value();
  const auto op = limit_operator(mesh, topology, rules, {}).value();
  const Blocks blocks = find_blocks(op, std::vector<unsigned char>(mesh.points.size(), 1));
  return find_singular_parts(op, blocks, {});
}

TEST(Solvability, EvenPrismsAreSingularAndOddOnesAreNot) {
  for (Index n = 3; n <= 12; ++n) {
    EXPECT_EQ(singular_parts_of(test::prism(n), kCatmullClark).size(), n % 2 == 0 ? 1U : 0U) << n;
  }
}

// The prism's two rings are 0..n-1 and n..2n-1: signs alternate along and across.
TEST(Solvability, TheNullVectorOfAnEvenPrismAlternates) {
  constexpr Index n = 6;
  const auto parts = singular_parts_of(test::prism(n), kCatmullClark);
  ASSERT_EQ(parts.size(), 1U);
  const std::vector<double>& z = parts[0].null_vector;
  ASSERT_EQ(z.size(), 2 * n);
  for (Index i = 0; i < n; ++i) {
    EXPECT_NEAR(z[i], -z[(i + 1) % n], 1e-10);
    EXPECT_NEAR(z[i], -z[n + i], 1e-10);
  }
}

TEST(Solvability, IsDecidedOnTheOperatorWithItsCreases) {
  Mesh cube = test::cube();
  for (const float sharpness : {0.5F, 1.5F, 10.0F}) {
    cube.creases = {{{cube.face(0)[0], cube.face(0)[1]}, sharpness}};
    EXPECT_EQ(singular_parts_of(cube, kCatmullClark).size(), 1U) << sharpness;
  }
  cube.creases.clear();
  cube.corners = {{0, 10}};
  EXPECT_EQ(singular_parts_of(cube, kCatmullClark).size(), 0U);
}

TEST(Solvability, ComponentsWithoutInterpolantAreAllNamed) {
  const Mesh mesh = together({moved_cube(), test::icosahedron(), test::prism(5), moved_cube()});
  const auto result = interpolate(mesh, {.rules = kCatmullClark, .tolerance = 1e-12});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::singular);
  EXPECT_EQ(result.error().place.vertex, 0U);
  EXPECT_EQ(result.error().message.find("components 0,3:"), 0U) << result.error().message;
}

TEST(Solvability, SkippedComponentsStayAndTheOthersAreInterpolated) {
  const Mesh mesh = together({moved_cube(), test::icosahedron(), moved_cube()});
  const auto result =
      interpolate(mesh, {.rules = kCatmullClark, .tolerance = 1e-12, .skip_components = {0, 2}});
  ASSERT_TRUE(result) << describe(result.error());
  const auto limit = limit_positions(result->control, kCatmullClark).value();
  const double side = bounding_box(mesh.points).side();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const bool skipped = v < 8 || v >= 20;
    EXPECT_EQ(result->control.points[v] == mesh.points[v], skipped) << v;
    for (std::size_t k = 0; k < 3 && !skipped; ++k) {
      EXPECT_NEAR(limit[v][k], mesh.points[v][k], 1e-12 * side);
    }
  }
  EXPECT_FALSE(interpolate(mesh, {.rules = kCatmullClark, .skip_components = {3}}));
}

// The cube's own corners have no part along the null vector. By symmetry the nearest solution is
// the cube of twice the size (progressive.json's case).
TEST(Solvability, CompatibleDataGetsTheNearestSolution) {
  const auto result = interpolate(test::cube(), {.rules = kCatmullClark, .tolerance = 1e-14});
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_TRUE(result->report.converged);
  for (Index v = 0; v < 8; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(result->control.points[v][k], 2 * test::cube().points[v][k], 1e-12);
    }
  }
  const auto& notes = result->report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("not unique") != std::string::npos;
  }));
}

// An interior vertex of valence 2 on every edge of a cube brings the eigenvalue -1/14.
TEST(Solvability, IndefiniteOperatorsAreSolvedByMinres) {
  Mesh mesh = test::cube();
  const Topology topology = Topology::build(mesh).value();
  for (Index e = topology.edge_count(); e-- > 0;) {
    const auto [a, b] = topology.edge_vertices(e);
    const Point& p = mesh.points[a];
    const Point& q = mesh.points[b];
    mesh = test::split_edge(mesh, a, b, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
  }
  std::mt19937_64 random(3);
  mesh = test::jitter(mesh, random, 0.05);
  const auto result = interpolate(mesh, {.rules = kCatmullClark, .tolerance = 1e-12});
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_TRUE(result->report.converged);
  EXPECT_EQ(result->report.solver, "minres");
  EXPECT_LT(certify(result->control, mesh.points, kCatmullClark)->max, 2e-12);
  const auto by_cg =
      Interpolator::create(mesh, {.rules = kCatmullClark, .solver = Solver::conjugate_gradient});
  ASSERT_FALSE(by_cg);
  EXPECT_EQ(by_cg.error().code, ErrorCode::unsuitable_for_scheme);
}

// Duals of triangulations: valence 3 everywhere and eigenvalues of a hundredth. The paper's
// iteration needs some 1,900 sweeps for 1e-12.
TEST(Solvability, DualsOfTriangulationsTakeFewIterations) {
  const Mesh dual = test::dual(test::random_mesh({.seed = 5, .kind = 0, .size = 12}));
  const auto result = interpolate(dual, {.rules = kCatmullClark, .tolerance = 1e-10});
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_TRUE(result->report.converged);
  EXPECT_EQ(result->report.solver, "conjugate-gradient");
  EXPECT_LT(result->report.iterations, 150U);
}

TEST(Solvability, DooSabinNeedsNoneOfThis) {
  const Mesh mesh = together({moved_cube(), test::prism(6)});
  const Rules rules{Scheme::doo_sabin};
  const auto result = interpolate(mesh, {.rules = rules, .tolerance = 1e-12});
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_LT(certify(result->control, mesh.points, rules)->max, 2e-12);
}

}  // namespace
}  // namespace surpass

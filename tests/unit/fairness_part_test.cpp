// What fairness leaves out, what it refuses, and angles to a reference.
#include <surpass/similarity.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "fairness_samples.hpp"
#include "quality/sampled_surface.hpp"

namespace surpass {
namespace {

using test::Torus;

// 9 by 9 points in a plane, 8 by 8 faces of unit area, and so is every surface of them: at level 2
// 32 by 32 faces. The outermost faces are left out, a share of 1 - (30 / 32)^2.
Mesh flat_grid() {
  Mesh mesh = test::quad_grid(9, 9);
  for (Point& p : mesh.points) p[2] = 0;
  return mesh;
}

TEST(FairnessPart, BoundariesAreLeftOutByOnePatch) {
  const auto found = fairness(flat_grid(), {Scheme::catmull_clark}, {.levels = 2}).value();
  EXPECT_EQ(found.coverage.patches, 32U * 32);
  EXPECT_EQ(found.coverage.measured_patches, 30U * 30);
  EXPECT_EQ(found.coverage.samples, 31U * 31);
  EXPECT_NEAR(found.coverage.measured_area, 900.0 / 16, 1e-12);
  // Along the boundary faces are a little uneven, but the whole is the square.
  EXPECT_NEAR(found.coverage.area, 64, 1e-12);
  EXPECT_NEAR(found.coverage.left_out, 1 - 900.0 / 1024, 1e-12);
  EXPECT_NEAR(found.bending, 0, 1e-20);
  EXPECT_EQ(found.largest_curvature, 0);
}

TEST(FairnessPart, CreasesAndHolesAreLeftOut) {
  Mesh mesh = flat_grid();
  for (Index i = 0; i < 8; ++i) mesh.creases.push_back({{4 * 9 + i, 4 * 9 + i + 1}, 10});
  const Rules rules{Scheme::catmull_clark};
  auto found = fairness(mesh, rules, {.levels = 2, .rings = 0}).value();
  EXPECT_EQ(found.coverage.measured_patches, 30U * 30 - 2 * 30) << "two rows along the crease";
  mesh = flat_grid();
  mesh.hole_faces = {27};  // in the middle: 16 patches go, and none beside them
  found = fairness(mesh, rules, {.levels = 2}).value();
  EXPECT_EQ(found.coverage.patches, 32U * 32 - 16);
  EXPECT_EQ(found.coverage.measured_patches, 30U * 30 - 16);
  EXPECT_NEAR(found.coverage.area, 63, 1e-12);
}

// On the cube's 6 * 4^3 faces of level 3, around each of 8 corners: 3 faces at the corner, 9 in the
// next ring, 15, 21.
TEST(FairnessPart, RingsAroundExtraordinaryVertices) {
  const Rules rules{Scheme::catmull_clark};
  for (const int rings : {0, 1, 2}) {
    const auto found = fairness(test::cube(), rules, {.levels = 4, .rings = rings}).value();
    const auto around = static_cast<std::size_t>(3 * (rings + 1) * (rings + 1));
    EXPECT_EQ(found.coverage.patches, 6U * 256);
    EXPECT_EQ(found.coverage.measured_patches, 6U * 256 - 8 * around) << rings;
    EXPECT_GT(found.coverage.left_out, 0);
    EXPECT_LT(found.coverage.left_out, 8.0 * static_cast<double>(around) / (6 * 256))
        << "corners are the densest";
  }
  const auto nothing = fairness(test::cube(), rules, {.levels = 1});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::unsuitable_for_scheme);
  EXPECT_NE(nothing.error().message.find("24 patches"), std::string::npos);
}

double drawn_area(const Mesh& mesh, const Rules& rules, int levels) {
  const Mesh drawn = triangulate(limit_mesh(mesh, rules, levels).value()).mesh;
  double sum = 0;
  for (Index f = 0; f < drawn.face_count(); ++f) sum += polygon_area(drawn.points, drawn.face(f));
  return sum;
}

// Doo-Sabin faces shrink to points, so there a hole is what lies between hole faces.
TEST(FairnessPart, HolesAreNoPartOfAnySchemesSurface) {
  for (const Scheme scheme : all_schemes()) {
    const Rules rules{scheme};
    Mesh mesh = scheme == Scheme::loop ? test::triangle_grid(9, 9) : flat_grid();
    for (Point& p : mesh.points) p[2] = 0;
    const auto whole = fairness(mesh, rules, {.levels = 3}).value();
    const Index row = scheme == Scheme::loop ? 16 : 8;
    for (Index j = 2; j < 5; ++j) {
      for (Index i = row / 4; i < row * 5 / 8; ++i) mesh.hole_faces.push_back(j * row + i);
    }
    const auto found = fairness(mesh, rules, {.levels = 3}).value();
    const double drawn = drawn_area(mesh, rules, 3);
    // Near the border of a grid of triangles the area element is not constant.
    EXPECT_NEAR(found.coverage.area, drawn, 2e-3) << name_of(scheme);
    EXPECT_LT(drawn, 61) << name_of(scheme);
    EXPECT_LT(found.coverage.measured_patches, whole.coverage.measured_patches - 100);
    EXPECT_NEAR(found.total_variation, 0, 1e-9);
  }
}

// The patches' polygons are those of the mesh that others draw, and what is integrated over them
// tends to the same area.
TEST(FairnessPart, AreasAddUpOnEveryKindOfMesh) {
  for (const test::Sample& sample : test::polygon_samples()) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::doo_sabin}) {
      const Rules rules{scheme};
      const std::string name = sample.name + ", " + name_of(scheme);
      const auto surface = sample_surface(sample.mesh, rules, 4, 0, {});
      ASSERT_TRUE(surface) << name << describe(surface.error());
      double sum = 0;
      for (const double a : surface->samples.patch_areas) sum += a;
      sum *= surface->unit * surface->unit;
      const double drawn = drawn_area(sample.mesh, rules, 4);
      EXPECT_NEAR(sum, drawn, 0.01 * drawn) << name;
      double before = 0;
      for (const int levels : {3, 4, 5}) {
        const auto found = fairness(sample.mesh, rules, {.levels = levels, .rings = 0});
        if (!found) continue;  // where all is boundary
        const double expected = drawn_area(sample.mesh, rules, levels);
        const double error = std::abs(found->coverage.area - expected);
        if (levels == 5) {
          EXPECT_LT(error, std::max(0.5 * before, 2e-3 * expected)) << name;
        }
        before = error;
      }
    }
  }
}

TEST(FairnessPart, TheSharpestHundredthIsSetAside) {
  const Torus torus{.R = 3, .r = 2};  // 1/r = 1/2 all around; 1 along the inner circle
  const Mesh mesh = torus.mesh(Scheme::catmull_clark, 96, 96);
  const auto found = fairness(mesh, {Scheme::catmull_clark}, {.levels = 2}).value();
  EXPECT_NEAR(found.largest_curvature, 1, 0.01);
  // Inside of the angle a on both sides of the inner circle lies the share
  // (R a - r sin a) / (pi R) of the area; the curvature there is cos a / (R - r cos a).
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = (low + high) / 2;
    ((torus.R * a - torus.r * std::sin(a)) / (M_PI * torus.R) < 0.01 ? low : high) = a;
  }
  const double expected = std::cos(low) / (torus.R - torus.r * std::cos(low));
  EXPECT_NEAR(found.high_curvature, expected, 0.01);
  EXPECT_LT(found.high_curvature, found.largest_curvature);
  // Without its sharpest hundredth, that is without twice the angle `low`.
  constexpr int kSteps = 100000;
  double rest = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = low + (M_PI - low) * (i + 0.5) / kSteps;
    const double k = std::cos(a) / (torus.R - torus.r * std::cos(a));
    const double w = torus.R - torus.r * std::cos(a);
    rest += (k * k + 1 / (torus.r * torus.r)) * torus.r * w;
  }
  rest *= 2 * M_PI * 2 * (M_PI - low) / kSteps;
  EXPECT_NEAR(found.trimmed_bending / rest, 1, 0.01);
  EXPECT_GT(found.bending, rest * 1.02);
  const Point& p = found.largest_at;
  EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 0.01) << "on the inner circle";
}

TEST(FairnessPart, DefaultLevelsGiveEnoughPatches) {
  EXPECT_EQ(fairness_levels(test::cube()), 8);  // 24 * 4^7 = 393 216
  Mesh large = Torus{}.mesh(Scheme::catmull_clark, 1000, 500);
  EXPECT_EQ(fairness_levels(large), 2);  // 500 000 faces, 8 million patches
  const auto found = fairness(Torus{}.mesh(Scheme::catmull_clark, 24, 12), {Scheme::catmull_clark});
  EXPECT_EQ(found->levels, 5);
  EXPECT_EQ(found->coverage.patches, 24U * 12 * 1024);
}

TEST(FairnessPart, Refusals) {
  const Rules rules{Scheme::catmull_clark};
  const auto code = [&](const Mesh& mesh, const FairnessOptions& options, const Rules& r) {
    const auto found = fairness(mesh, r, options);
    return found ? std::string("none") : name_of(found.error().code);
  };
  EXPECT_EQ(code({}, {}, rules), "empty-mesh");
  EXPECT_EQ(code(test::cube(), {.levels = -1}, rules), "invalid-argument");
  EXPECT_EQ(code(test::cube(), {.levels = 13}, rules), "invalid-argument");
  EXPECT_EQ(code(test::cube(), {.levels = 3, .rings = -1}, rules), "invalid-argument");
  EXPECT_EQ(code(test::cube(), {}, {Scheme::loop}), "unsuitable-for-scheme");
  EXPECT_EQ(code(Torus{}.mesh(Scheme::catmull_clark, 300, 300), {.levels = 12}, rules),
            "too-large");
  Mesh huge = test::cube();
  for (Point& p : huge.points) {
    for (double& x : p) x *= 1e200;
  }
  EXPECT_EQ(code(huge, {}, rules), "too-large");
  Mesh point = test::cube();
  for (Point& p : point.points) p = {1, 2, 3};
  EXPECT_EQ(code(point, {.levels = 4}, rules), "unsuitable-for-scheme");
  std::atomic<bool> stop{true};
  Context context;
  context.cancel = &stop;
  EXPECT_EQ(fairness(test::cube(), rules, {}, context).error().code, ErrorCode::cancelled);
}

// A plane turned by 10 degrees, a plane with one part folded.
TEST(NormalDeviation, AnglesBetweenPlanes) {
  const Rules rules{Scheme::catmull_clark};
  const Mesh flat = flat_grid();
  const double angle = M_PI / 18;
  Mesh turned = flat;
  for (Point& p : turned.points) {
    p = {p[0] * std::cos(angle), p[1], p[0] * std::sin(angle)};
  }
  const auto found = normal_deviation(flat, turned, rules, {.levels = 2}).value();
  EXPECT_NEAR(found.mean, 10, 1e-11);
  EXPECT_NEAR(found.rms, 10, 1e-11);
  EXPECT_NEAR(found.max, 10, 1e-11);
  EXPECT_NEAR(found.coverage.measured_area, 900.0 / 16, 1e-12);
  const auto itself = normal_deviation(flat, flat, rules, {.levels = 2}).value();
  EXPECT_EQ(itself.max, 0);
}

// Where z = c x^2 / 2 + (a constant), the normal is off by atan(c x), whatever y.
TEST(NormalDeviation, OfAParabolicCylinderFromItsPlane) {
  const Rules rules{Scheme::catmull_clark};
  Mesh bent = flat_grid();
  const Mesh flat = bent;
  const double c = 0.1;
  for (Point& p : bent.points) p[2] = c / 2 * (p[0] - 4) * (p[0] - 4);
  const auto found = normal_deviation(flat, bent, rules, {.levels = 4}).value();
  // Without the outermost sixteenths of faces, where the boundary's rule flattens the surface.
  double sum = 0;
  double squares = 0;
  constexpr int kSteps = 6 * 16;
  const auto degrees = [&](double x) { return std::abs(std::atan(c * (x - 4))) * 180 / M_PI; };
  const auto surface = sample_surface(bent, rules, 4, 2, {}).value();
  double worst = 0;
  for (std::size_t v = 0; v < surface.usable.size(); ++v) {
    if (surface.usable[v] == 0) continue;
    const double x = surface.place_of(static_cast<Index>(v))[0];
    if (x < 1 || x > 7) continue;
    const double n = surface.curvature[v].normal[2];
    worst = std::max(worst, std::abs(std::acos(n) * 180 / M_PI - degrees(x)));
  }
  EXPECT_LT(worst, 1e-10);
  for (int i = 0; i < kSteps; ++i) {
    const double x = 1 + (i + 0.5) * 6 / kSteps;
    sum += degrees(x) * 6 / kSteps;
    squares += degrees(x) * degrees(x) * 6 / kSteps;
  }
  // The two outer faces on each side have angles between the cylinder's at 1 and at 0.
  const double width = 8 - 2.0 / 16;
  EXPECT_GT(found.mean, sum / 8);
  EXPECT_LT(found.mean, (sum + 2 * degrees(0)) / width);
  EXPECT_GT(found.rms, std::sqrt(squares / 8));
  EXPECT_LT(found.rms, std::sqrt((squares + 2 * degrees(0) * degrees(0)) / width));
  EXPECT_LE(found.max, degrees(0));
  EXPECT_GT(found.max, degrees(1));
}

TEST(NormalDeviation, TakesAReferenceThatIsRefinedMoreOrLess) {
  for (const Scheme scheme : all_schemes()) {
    const Rules rules{scheme};
    const Mesh mesh = test::random_mesh_for(scheme, {.seed = 6, .kind = 0});
    const Mesh refined = refine(mesh, rules, 1).value();
    EXPECT_LT(normal_deviation(mesh, refined, rules, {.levels = 4})->max, 1e-9);
    EXPECT_LT(normal_deviation(refined, mesh, rules, {.levels = 3})->max, 1e-9);
    const auto few = normal_deviation(mesh, refined, rules, {.levels = 1});
    ASSERT_FALSE(few);
    EXPECT_EQ(few.error().code, ErrorCode::invalid_argument);
  }
}

// A dome, whose normals turn by some 70 degrees from side to side.
Mesh dome() {
  Mesh mesh = flat_grid();
  for (Point& p : mesh.points) {
    const double x = p[0] - 4;
    const double y = p[1] - 4;
    p[2] = -(x * x + y * y) / 12;
  }
  return mesh;
}

Mesh similar(const Mesh& given, OpenMeshes open) {
  SimilarityOptions options;
  options.open = open;
  return interpolate_similar(given, options)->control;
}

TEST(FairnessPart, ARingOfHolesIsNoFinerMesh) {
  const Rules rules{Scheme::catmull_clark};
  Mesh given = test::quad_grid(3, 3);
  const Mesh plain = similar(given, OpenMeshes::boundary_rules);
  const Mesh ring = similar(given, OpenMeshes::dummy_ring);
  ASSERT_EQ(ring.hole_faces.size(), ring.corner_count() / 4 - plain.corner_count() / 4);
  EXPECT_EQ(level_difference(ring, plain), 0);
  EXPECT_EQ(level_difference(ring, given), 1);
  EXPECT_EQ(level_difference(given, ring), -1);
  EXPECT_EQ(fairness_levels(ring), fairness_levels(plain));
  EXPECT_EQ(fairness(ring, rules, {.levels = 3})->coverage.patches,
            fairness(plain, rules, {.levels = 3})->coverage.patches);
  // They cost what other faces cost, though.
  Mesh hidden = Torus{}.mesh(Scheme::catmull_clark, 1000, 500);
  for (Index f = 1; f < hidden.face_count(); ++f) hidden.hole_faces.push_back(f);
  EXPECT_EQ(fairness_levels(hidden), 2);
}

TEST(NormalDeviation, HoleFacesDoNotCount) {
  const Rules rules{Scheme::catmull_clark};
  const Mesh given = dome();
  const Mesh plain = similar(given, OpenMeshes::boundary_rules);
  const Mesh ring = similar(given, OpenMeshes::dummy_ring);
  ASSERT_NE(ring.face_count(), plain.face_count());
  for (const Mesh* reference : {&plain, &given}) {
    const int further = reference == &given ? 1 : 0;
    const auto there = normal_deviation(ring, *reference, rules, {.levels = 3});
    ASSERT_TRUE(there) << describe(there.error());
    const auto back = normal_deviation(*reference, ring, rules, {.levels = 3 + further}).value();
    EXPECT_EQ(there->coverage.measured_patches, back.coverage.measured_patches);
    EXPECT_GT(there->max, 0);
    EXPECT_EQ(there->max, back.max);
    // Between samples that are no partners there are up to 70 degrees.
    EXPECT_LT(there->mean, 1);
    EXPECT_LT(there->max, 10);
  }
  const Mesh finer = refine(ring, rules, 1).value();
  EXPECT_LT(normal_deviation(ring, finer, rules, {.levels = 3})->max, 1e-9);
  // Where all faces are the same it does not matter which of them are hidden in the reference.
  Mesh shown = ring;
  shown.hole_faces.clear();
  EXPECT_LT(normal_deviation(ring, shown, rules, {.levels = 3})->max, 1e-9);
}

TEST(NormalDeviation, RefusesOtherFaces) {
  const Rules rules{Scheme::catmull_clark};
  const auto other = normal_deviation(flat_grid(), test::quad_grid(9, 8), rules, {.levels = 2});
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::mismatch);
  Mesh turned = test::cube();
  std::swap(turned.points[0], turned.points[7]);
  for (Index& v : turned.face_vertices) v = v == 0 ? 7 : v == 7 ? 0 : v;
  const auto order = normal_deviation(test::cube(), turned, rules, {.levels = 4});
  ASSERT_FALSE(order);
  EXPECT_NE(order.error().message.find("another order"), std::string::npos);
}

}  // namespace
}  // namespace surpass

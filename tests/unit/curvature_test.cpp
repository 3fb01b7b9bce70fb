// Curvature at vertices: exact on spheres, of second order on tori, refused without normals.
#include <surpass/curvature.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "fairness_samples.hpp"
#include "support/meshes.hpp"

namespace surpass::test {
namespace {

void set_normals(Mesh& mesh, std::vector<double> normals) {
  mesh.channels.push_back({"normal", {"x", "y", "z"}, std::move(normals)});
}

/// A torus with its own normals; errors relative to the largest curvature.
double worst_error(Scheme scheme, Index n) {
  const Torus torus{3, 1};
  Mesh mesh = torus.mesh(scheme, n, n / 2);
  std::vector<double> normals;
  for (const Point& p : mesh.points) {
    const double w = std::hypot(p[0], p[1]);
    const double c = (w - torus.R) / torus.r;
    normals.insert(normals.end(), {c * p[0] / w, c * p[1] / w, p[2] / torus.r});
  }
  set_normals(mesh, normals);
  const auto found = vertex_curvatures(mesh);
  EXPECT_TRUE(found);
  double worst = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Point& p = mesh.points[v];
    const double w = std::hypot(p[0], p[1]);
    const double k1 = 1 / torus.r;
    const double k2 = (w - torus.R) / torus.r / w;
    worst = std::max(
        {worst, std::abs(found->mean[v] - (k1 + k2) / 2), std::abs(found->gauss[v] - k1 * k2)});
  }
  return worst;
}

TEST(VertexCurvatures, FallToTheTorusWithTheSquareOfTheEdges) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    const double coarse = worst_error(scheme, 64);
    const double fine = worst_error(scheme, 128);
    EXPECT_LT(coarse, 0.02) << name_of(scheme);
    EXPECT_GT(coarse / fine, 3.5) << name_of(scheme);
  }
}

TEST(VertexCurvatures, AreExactOnSpheresFromBothSides) {
  for (Mesh mesh : {icosahedron(), octahedron()}) {
    std::vector<double> outward;
    for (Point& p : mesh.points) {
      const double length = std::hypot(p[0], p[1], p[2]);
      for (double& x : p) {
        outward.push_back(x / length);
        x *= 2.5 / length;
      }
    }
    for (const double side : {1.0, -1.0}) {
      Mesh sphere = mesh;
      std::vector<double> normals = outward;
      for (double& x : normals) x *= side;
      set_normals(sphere, normals);
      const auto found = vertex_curvatures(sphere);
      ASSERT_TRUE(found);
      for (Index v = 0; v < sphere.vertex_count(); ++v) {
        EXPECT_NEAR(found->mean[v], side / 2.5, 1e-13);
        EXPECT_NEAR(found->gauss[v], 1 / 2.5 / 2.5, 1e-13);
      }
    }
  }
}

TEST(VertexCurvatures, AreThoseOfLimitSurfaces) {
  // A finely given torus, interpolated and refined, is a torus for all that one sees.
  const Torus torus{3, 1};
  const auto found = interpolate(torus.mesh(Scheme::loop, 64, 32));
  ASSERT_TRUE(found);
  const auto limit = limit_mesh(found->control, {}, 2);
  ASSERT_TRUE(limit);
  const auto curvatures = vertex_curvatures(*limit);
  ASSERT_TRUE(curvatures);
  for (Index v = 0; v < 64 * 32; ++v) {
    const Point& p = limit->points[v];
    const double w = std::hypot(p[0], p[1]);
    EXPECT_NEAR(curvatures->mean[v], (1 + (w - 3) / w) / 2, 0.03);
  }
}

TEST(VertexCurvatures, AreNoneWhereTheMeshSaysNothing) {
  Mesh mesh = octahedron();
  const auto without = vertex_curvatures(mesh);
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().code, ErrorCode::invalid_argument);
  set_normals(mesh, std::vector<double>(18, 0.0));
  const auto zero = vertex_curvatures(mesh);
  ASSERT_TRUE(zero);
  EXPECT_EQ(zero->mean, std::vector<double>(6, 0.0));
  EXPECT_EQ(zero->gauss, std::vector<double>(6, 0.0));
}

}  // namespace
}  // namespace surpass::test

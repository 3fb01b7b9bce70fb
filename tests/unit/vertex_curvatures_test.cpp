// Curvatures at vertices beside the closed forms of spheres, planes and tori.
#include <surpass/surpass.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "fairness_samples.hpp"
#include "support/meshes.hpp"
#include "support/polygons.hpp"

namespace surpass::test {
namespace {

// Exact normals of a surface, as a channel; positions from `place`, quads around both parameters.
template <class Place, class Normal>
Mesh sampled(Index n, Index m, const Place& place, const Normal& normal) {
  Mesh mesh = Torus{}.mesh(Scheme::catmull_clark, n, m);
  Channel channel{"normal", {"x", "y", "z"}, {}};
  for (Index j = 0; j < m; ++j) {
    for (Index i = 0; i < n; ++i) {
      const double t = 2 * M_PI * i / n;
      const double p = 2 * M_PI * j / m;
      mesh.points[j * n + i] = place(t, p);
      const Point k = normal(t, p);
      channel.values.insert(channel.values.end(), k.begin(), k.end());
    }
  }
  mesh.channels = {channel};
  return mesh;
}

Mesh torus(const Torus& shape, Index n, Index m) {
  return sampled(
      n, m,
      [&](double t, double p) {
        const double w = shape.R + shape.r * std::cos(p);
        return Point{w * std::cos(t), w * std::sin(t), shape.r * std::sin(p)};
      },
      [](double t, double p) {
        return Point{std::cos(p) * std::cos(t), std::cos(p) * std::sin(t), std::sin(p)};
      });
}

// Largest differences from the closed forms.
VertexCurvature off_torus(const Torus& shape, Index n, Index m) {
  const auto found = vertex_curvatures(torus(shape, n, m));
  EXPECT_TRUE(found);
  VertexCurvature most;
  for (Index j = 0; j < m; ++j) {
    const double c = std::cos(2 * M_PI * j / m);
    const double w = shape.R + shape.r * c;
    for (Index i = 0; i < n; ++i) {
      const VertexCurvature& k = (*found)[j * n + i];
      most.mean = std::max(most.mean, std::abs(k.mean - (1 / shape.r + c / w) / 2));
      most.gauss = std::max(most.gauss, std::abs(k.gauss - c / w / shape.r));
    }
  }
  return most;
}

Mesh with_normals_of_a_sphere(Mesh mesh, double radius, double side) {
  Channel channel{"normal", {"x", "y", "z"}, {}};
  for (Point& p : mesh.points) {
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p) {
      channel.values.push_back(side * x / length);
      x *= radius / length;
    }
  }
  mesh.channels = {channel};
  return mesh;
}

TEST(VertexCurvatures, OfASphereAreExact) {
  for (const double radius : {2.5, 1e-3, 0x1p300}) {
    for (const double side : {1.0, -1.0}) {
      Mesh mesh = with_normals_of_a_sphere(refine(icosahedron(), {}, 2).value(), radius, side);
      if (side < 0) {
        for (Index c = 0; c < mesh.corner_count(); c += 3) {
          std::swap(mesh.face_vertices[c], mesh.face_vertices[c + 1]);
        }
      }
      const auto found = vertex_curvatures(mesh);
      ASSERT_TRUE(found);
      ASSERT_EQ(found->size(), mesh.points.size());
      for (const VertexCurvature& k : *found) {
        EXPECT_NEAR(k.mean * radius, side, 1e-12);
        EXPECT_NEAR(k.gauss * radius * radius, 1, 1e-12);
      }
    }
  }
}

TEST(VertexCurvatures, OfATorusConverge) {
  const Torus shape;
  const VertexCurvature coarse = off_torus(shape, 60, 24);
  const VertexCurvature fine = off_torus(shape, 120, 48);
  EXPECT_LT(coarse.mean, 0.05);
  EXPECT_LT(coarse.gauss, 0.05);
  EXPECT_LT(fine.mean, coarse.mean / 3.5);  // with the square of the edges' length
  EXPECT_LT(fine.gauss, coarse.gauss / 3.5);
}

TEST(VertexCurvatures, AreThoseOfLimitSurfaces) {
  // A finely given torus, interpolated and refined, is a torus for all that one sees.
  const Torus shape{3, 1};
  const auto found = interpolate(shape.mesh(Scheme::loop, 64, 32));
  ASSERT_TRUE(found);
  const auto limit = limit_mesh(found->control, {}, 2);
  ASSERT_TRUE(limit);
  const auto curvatures = vertex_curvatures(*limit);
  ASSERT_TRUE(curvatures);
  for (Index v = 0; v < 64 * 32; ++v) {
    const double w = std::hypot(limit->points[v][0], limit->points[v][1]);
    EXPECT_NEAR((*curvatures)[v].mean, (1 + (w - 3) / w) / 2, 0.03);
  }
}

TEST(VertexCurvatures, WithoutNormalsThoseOfTheFacesServe) {
  const Torus shape;
  Mesh mesh = torus(shape, 120, 48);
  const auto exact = vertex_curvatures(mesh);
  mesh.channels.clear();
  const auto found = vertex_curvatures(mesh);
  ASSERT_TRUE(found);
  for (std::size_t v = 0; v < found->size(); ++v) {
    EXPECT_NEAR((*found)[v].mean, (*exact)[v].mean, 0.01);
    EXPECT_NEAR((*found)[v].gauss, (*exact)[v].gauss, 0.02);
  }
}

TEST(VertexCurvatures, OfAPlaneAreZero) {
  Mesh mesh = quad_grid(4, 4);
  for (Point& p : mesh.points) p[2] = 0;
  mesh.points.push_back({9, 9, 9});  // isolated
  const auto found = vertex_curvatures(mesh);
  ASSERT_TRUE(found);
  for (const VertexCurvature& k : *found) {
    EXPECT_NEAR(k.mean, 0, 1e-15);
    EXPECT_NEAR(k.gauss, 0, 1e-15);
  }
}

TEST(VertexCurvatures, SameBitsForAnyNumberOfThreads) {
  const Mesh mesh = torus({}, 90, 60);
  Context one;
  one.threads = 1;
  const auto expected = vertex_curvatures(mesh, one);
  for (const int threads : {2, 3, 8}) {
    Context several;
    several.threads = threads;
    const auto found = vertex_curvatures(mesh, several);
    for (std::size_t v = 0; v < found->size(); ++v) {
      ASSERT_EQ((*found)[v].mean, (*expected)[v].mean);
      ASSERT_EQ((*found)[v].gauss, (*expected)[v].gauss);
    }
  }
}

TEST(VertexCurvatures, RefuseWhatIsNoSurface) {
  EXPECT_EQ(vertex_curvatures({}).error().code, ErrorCode::empty_mesh);
  Mesh outside = icosahedron();
  outside.face_vertices[0] = 99;
  EXPECT_EQ(vertex_curvatures(outside).error().code, ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace surpass::test

// Points without faces, and edges without shade.
#include <algorithm>

#include "render/camera.hpp"
#include "render/cloud.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using picture::Camera;
using picture::Vec3;
using samples::draw;
using samples::from_front;
using samples::pixel;

// Nearly evenly spread over the unit sphere.
Mesh sphere_of_points(int n) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    const double y = 1 - (2 * i + 1.0) / n;
    const double r = std::sqrt(1 - y * y);
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    mesh.points.push_back({r * std::cos(turn), y, r * std::sin(turn)});
  }
  return mesh;
}

TEST(RenderCloud, NormalsAreThoseOfTheSurfaceThatThePointsLieOn) {
  const Mesh mesh = sphere_of_points(3000);
  std::vector<Vec3> points;
  for (const Point& p : mesh.points) points.push_back(picture::to_vector(p).cast<float>());
  Context one;
  one.threads = 1;
  const picture::Cloud cloud = picture::look_at_cloud(points, {});
  EXPECT_EQ(cloud.normals, picture::look_at_cloud(points, one).normals);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GT(std::abs(cloud.normals[i].dot(points[i])), 0.995F);
  }
  // A point has a square of 4 pi / 3000 to itself, and the nearest is about a side away.
  EXPECT_NEAR(cloud.spacing, std::sqrt(4 * std::numbers::pi / 3000), 0.01);
}

TEST(RenderCloud, PointsOnALineHaveNoNormal) {
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}};
  for (const Vec3& n : picture::look_at_cloud(line, {}).normals) EXPECT_TRUE(n.isZero());
  EXPECT_EQ(picture::look_at_cloud(line, {}).spacing, 1);
}

TEST(RenderCloud, ASphereOfPointsIsShadedAsTheSphere) {
  const Mesh cloud = sphere_of_points(4000);
  const Mesh surface = samples::sphere(96, 48);
  RenderOptions options = from_front(400, 400);
  options.frame = surface.points;
  const Image points = draw(cloud, options);
  const Image solid = draw(surface, options);
  std::vector<int> differences;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      if (std::hypot(x - 199.5, y - 199.5) > 150) continue;
      differences.push_back(
          std::abs(samples::brightness(points, x, y) - samples::brightness(solid, x, y)));
    }
  }
  // Through the gaps the far side is seen, so only the smaller half of the differences counts.
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  EXPECT_LT(*middle, 3 * 6);
  EXPECT_FALSE(samples::is_drawn(points, 20, 20));
}

TEST(RenderCloud, OnePointIsDrawn) {
  Mesh one;
  one.points = {{3, 4, 5}};
  EXPECT_GT(samples::count_drawn(draw(one, from_front(100, 100))), 0);
}

TEST(RenderCloud, SameBitsForAnyNumberOfThreads) {
  const Mesh cloud = sphere_of_points(2000);
  const Image one = draw(cloud, from_front(201, 157), 1);
  for (const int threads : {2, 5}) {
    EXPECT_EQ(draw(cloud, from_front(201, 157), threads).pixels, one.pixels);
  }
}

TEST(RenderWireframe, ShowsEdgesAndNoneThatAreHidden) {
  Mesh mesh = samples::square(true);
  mesh.points.insert(mesh.points.end(), {{-1, -0.2, -2}, {1, -0.2, -2}, {0, 0.6, -2}});
  mesh.add_face(std::array<Index, 3>{4, 5, 6});  // behind the square
  RenderOptions options = from_front(400, 400);
  options.shading = Shading::wireframe;
  const Image image = draw(mesh, options);
  const Camera camera(mesh.points, 0, options);
  const auto shade = [&](const Point& p) {
    const picture::Vec2 place = camera.project(camera.to_unit(p));
    int darkest = 765;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        darkest = std::min(darkest, samples::brightness(image, static_cast<int>(place.x()) + dx,
                                                        static_cast<int>(place.y()) + dy));
      }
    }
    return darkest;
  };
  EXPECT_LT(shade({0, 0, 0}), 450);  // the diagonal
  EXPECT_LT(shade({0.5, 0.5, 0}), 450);
  EXPECT_GT(shade({-0.5, 0.5, 0}), 640);   // paper
  EXPECT_GT(shade({0.5, -0.25, 0}), 640);  // over an edge of the triangle behind
}

TEST(RenderZoom, EnlargesTheMiddle) {
  const std::vector<Point> points = {{-1, -1, -1}, {1, 1, 1}};
  RenderOptions options = from_front(300, 200);
  const Camera near(points, 0, options);
  options.zoom = 2.5;
  const Camera nearer(points, 0, options);
  const picture::Vec2 middle(150, 100);
  for (const Vec3& p : {Vec3(0.1F, 0.2F, 0.3F), Vec3(-0.4F, 0.1F, -0.2F)}) {
    EXPECT_LT((nearer.project(p) - middle - 2.5F * (near.project(p) - middle)).norm(), 1e-3F);
  }
  options.zoom = 0;
  EXPECT_EQ(render(samples::square(true), options).error().code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace surpass

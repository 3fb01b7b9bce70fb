#include "render/camera.hpp"
#include "render/edges.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using picture::Camera;
using picture::Vec2;
using picture::Vec3;

constexpr float kBorder = 0.06F;

// Extent of the projected points, as parts of the half picture: -1 to 1.
struct Extent {
  Vec2 low = {2, 2};
  Vec2 high = {-2, -2};
};

Extent extent(const Camera& camera, const std::vector<Point>& points,
              const RenderOptions& options) {
  const Vec2 half(static_cast<float>(options.width) / 2, static_cast<float>(options.height) / 2);
  Extent e;
  for (const Point& p : points) {
    const Vec2 place = (camera.project(camera.to_unit(p)) - half).cwiseQuotient(half);
    e.low = e.low.cwiseMin(place);
    e.high = e.high.cwiseMax(place);
  }
  return e;
}

TEST(RenderCamera, FitsTightlyFromEveryDirection) {
  const std::vector<Point> points = {{0, 0, 0}, {5, 1, 0}, {2, 3, -1}, {-1, 0.5, 4}, {1, -2, 1}};
  for (const char up : {'x', 'y', 'z'}) {
    for (const double azimuth : {-170.0, -35.0, 0.0, 60.0, 120.0}) {
      for (const double elevation : {-90.0, -20.0, 0.0, 45.0, 90.0}) {
        RenderOptions options;
        options.up = up;
        options.azimuth = azimuth;
        options.elevation = elevation;
        const Extent e = extent(Camera(points, 0, options), points, options);
        // Centred both ways, and up to the border along the tighter one.
        EXPECT_NEAR(e.low.x(), -e.high.x(), 1e-4);
        EXPECT_NEAR(e.low.y(), -e.high.y(), 1e-4);
        EXPECT_NEAR(e.high.maxCoeff(), 1 - kBorder, 1e-5);
      }
    }
  }
}

TEST(RenderCamera, LooksWhereItsAnglesSay) {
  const std::vector<Point> points = {{-1, -1, -1}, {1, 1, 1}};
  RenderOptions options;
  const auto back = [&](char up, double azimuth, double elevation) {
    options.up = up;
    options.azimuth = azimuth;
    options.elevation = elevation;
    return Camera(points, 0, options).back();
  };
  EXPECT_LT((back('y', 0, 0) - Vec3(0, 0, 1)).norm(), 1e-6);
  EXPECT_LT((back('y', 90, 0) - Vec3(1, 0, 0)).norm(), 1e-6);
  EXPECT_LT((back('y', 0, 90) - Vec3(0, 1, 0)).norm(), 1e-6);
  EXPECT_LT((back('z', 0, 0) - Vec3(0, -1, 0)).norm(), 1e-6);
  EXPECT_LT((back('z', 90, 0) - Vec3(1, 0, 0)).norm(), 1e-6);
  EXPECT_LT((back('x', 0, 0) - Vec3(0, 1, 0)).norm(), 1e-6);
  EXPECT_LT((back('x', 90, 0) - Vec3(0, 0, 1)).norm(), 1e-6);
}

TEST(RenderCamera, RaysAndProjectionAgree) {
  const RenderOptions options;
  const Camera camera(std::vector<Point>{{0, 0, 0}, {3, 1, 2}}, 0.02, options);
  for (const Vec2& place : {Vec2(0, 0), Vec2(512, 384), Vec2(1000, 3), Vec2(17, 700)}) {
    const Vec3 seen = camera.eye() + 2.5F * camera.ray(place.x(), place.y());
    EXPECT_LT((camera.project(seen) - place).norm(), 2e-3);
  }
}

TEST(RenderCamera, MarginKeepsBallsInside) {
  const std::vector<Point> one = {{7, 7, 7}, {8, 7, 7}};
  RenderOptions options;
  const Camera camera(one, 0.3, options);
  const double radius = 0.3 * static_cast<double>(camera.unit_side());
  std::vector<Point> around;
  for (const Point& p : samples::sphere(64, 32, 0.3).points) {
    for (const Point& c : one) around.push_back({c[0] + p[0], c[1] + p[1], c[2] + p[2]});
  }
  EXPECT_NEAR(radius, 0.3 * 2, 1e-6);  // the box's half diagonal is half of its only side
  const Extent e = extent(camera, around, options);
  EXPECT_LE(e.high.maxCoeff(), 1 - kBorder + 1e-5);
  EXPECT_GT(e.high.maxCoeff(), 1 - kBorder - 5e-3);
}

TEST(RenderEdges, LinesHaveTheSameWidthEverywhere) {
  const RenderOptions options = samples::from_front(800, 600);
  for (const double depth : {0.0, -3.0}) {
    const std::vector<Point> points = {{-1, -1, depth}, {1, -1, depth}, {0, 1, depth}};
    const Camera camera(std::vector<Point>{{-1, -1, -3}, {1, 1, 0}}, 0, options);
    std::vector<Vec3> unit(points.size());
    for (std::size_t k = 0; k < 3; ++k) unit[k] = camera.to_unit(points[k]);
    const picture::EdgeLines lines(unit, camera);
    const picture::Triangle whole{{0, 1, 2}, {0, 1, 2}, {true, true, true}};
    const picture::Triangle cut{{0, 1, 2}, {0, 1, 2}, {false, true, true}};
    const Vec2 middle = (camera.project(unit[0]) + camera.project(unit[1])) / 2;
    double width = 0;
    for (int k = -400; k < 400; ++k) {
      const Vec2 place = middle + Vec2(0, (static_cast<float>(k) + 0.5F) / 100);
      width += static_cast<double>(lines.coverage(whole, place, 1)) / 100;
      EXPECT_EQ(lines.coverage(cut, place, 1), 0);
    }
    EXPECT_NEAR(width, 1.3, 1e-3);
  }
}

}  // namespace
}  // namespace surpass

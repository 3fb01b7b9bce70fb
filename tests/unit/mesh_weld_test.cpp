#include <surpass/repair.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

Mesh points_only(std::vector<Point> points) {
  Mesh mesh;
  mesh.points = std::move(points);
  return mesh;
}

TEST(Weld, JoinsTheFacesOfAnUnweldedCube) {
  const Mesh cube = samples::cube();
  Mesh apart;
  for (Index c = 0; c < 24; ++c) apart.points.push_back(cube.points[cube.face_vertices[c]]);
  for (Index f = 0; f < 6; ++f) apart.add_face(Face{4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3});
  const auto welded = weld(apart, 0);
  ASSERT_TRUE(welded);
  EXPECT_EQ(welded->mesh.points.size(), 8U);
  for (Index c = 0; c < 24; ++c) {
    EXPECT_EQ(welded->mesh.points[welded->mesh.face_vertices[c]], apart.points[c]);
  }
  EXPECT_EQ(welded->done,
            (std::vector<std::string>{"merged 16 vertices into others at most 0 away"}));
}

TEST(Weld, ZeroMergesEqualCoordinatesOnly) {
  const double next = std::nextafter(1.0, 2.0);
  const auto welded = weld(points_only({{1, 0, 0}, {next, 0, 0}, {1, -0.0, 0}}), 0);
  EXPECT_EQ(welded->mesh.points, (std::vector<Point>{{1, 0, 0}, {next, 0, 0}}));
}

TEST(Weld, GoesByOrderNotByChains) {
  // Each is 0.6 from the next: 1 goes to 0, and 2 stays as it is too far from 0.
  const auto welded = weld(points_only({{0, 0, 0}, {0.6, 0, 0}, {1.2, 0, 0}, {1.8, 0, 0}}), 1);
  EXPECT_EQ(welded->mesh.points, (std::vector<Point>{{0, 0, 0}, {1.2, 0, 0}}));
}

TEST(Weld, DistanceIsInclusive) {
  EXPECT_EQ(weld(points_only({{0, 0, 0}, {0, 0.5, 0}}), 0.5)->mesh.points.size(), 1U);
  EXPECT_EQ(weld(points_only({{0, 0, 0}, {0, 0.5, 0}}), 0.4999)->mesh.points.size(), 2U);
}

TEST(Weld, AgreesWithComparingAllPairs) {
  std::mt19937 random(3);
  for (const double scale : {1.0, 1e-300, 1e200, 1e-3}) {
    for (const double distance : {0.05 * scale, 0.3 * scale, 1e-12 * scale}) {
      std::vector<Point> points;
      for (int i = 0; i < 400; ++i) {
        Point p;
        for (double& x : p) {
          x = scale * (static_cast<double>(random()) / 4294967295.0 - 0.5);
          if (random() % 3 == 0) x = std::round(x / distance) * distance;
        }
        points.push_back(p);
      }
      std::vector<Point> kept;
      for (const Point& p : points) {
        bool merged = false;
        for (const Point& q : kept) {
          merged = merged || std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance;
        }
        if (!merged) kept.push_back(p);
      }
      EXPECT_EQ(weld(points_only(points), distance)->mesh.points, kept);
    }
  }
}

TEST(Weld, RefusesWhatIsNoDistance) {
  for (const double distance : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto welded = weld(samples::cube(), distance);
    ASSERT_FALSE(welded);
    EXPECT_EQ(welded.error().code, ErrorCode::invalid_argument);
  }
}

TEST(Weld, PointsThatAreNotFiniteStayApart) {
  const double nan = std::nan("");
  EXPECT_EQ(weld(points_only(std::vector<Point>(50000, {nan, 0, 0})), 1)->mesh.points.size(),
            50000U);
}

}  // namespace
}  // namespace surpass

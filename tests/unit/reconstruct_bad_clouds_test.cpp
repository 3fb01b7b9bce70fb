// Clouds that have no surface, or that need cleaning first: a good mesh or a clear error.
#include <cmath>
#include <limits>

#include "reconstruct_clouds.hpp"

namespace surpass::test {
namespace {

Error refusal(const Cloud& cloud, const ReconstructOptions& options = {}) {
  const auto found = reconstruct(cloud, {}, options);
  EXPECT_FALSE(found);
  return found ? Error{} : found.error();
}

TEST(BadCloud, NoOneTwoAndThreePoints) {
  const Cloud three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t n = 0; n <= 3; ++n) {
    const Error error = refusal({three.begin(), three.begin() + static_cast<std::ptrdiff_t>(n)});
    EXPECT_EQ(error.code, ErrorCode::empty_mesh);
    EXPECT_NE(error.message.find("at least four"), std::string::npos) << error.message;
  }
}

TEST(BadCloud, OnePointOften) {
  EXPECT_EQ(refusal(Cloud(100, Point{1, 2, 3})).code, ErrorCode::empty_mesh);
}

TEST(BadCloud, PointsOnALine) {
  Cloud line;
  for (int i = 0; i < 60; ++i) line.push_back({0.1 * i, 0.2 * i, -0.3 * i});
  const Error error = refusal(line);
  EXPECT_EQ(error.code, ErrorCode::unsuitable_for_scheme);
  EXPECT_NE(error.message.find("line"), std::string::npos);
}

TEST(BadCloud, FourPointsAreATetrahedron) {
  const Reconstruction found = reconstructed({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_closed(found, 0);
  EXPECT_EQ(found.mesh.face_count(), 4U);
}

TEST(BadCloud, PointsInAPlaneAreASheet) {
  Cloud grid;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) grid.push_back({double(i), double(j), 0});
  }
  const Reconstruction found = reconstructed(grid);
  EXPECT_EQ(found.mesh.face_count(), 162U);  // two for each of 81 squares
  EXPECT_EQ(found.report.open_loops, 1U);
  expect_input_points(found, grid);
}

TEST(BadCloud, CornersOfACube) {
  const Reconstruction found = reconstructed(cube_cloud(2));  // all on one sphere
  expect_closed(found, 0);
  EXPECT_EQ(found.mesh.vertex_count(), 8U);
  EXPECT_NEAR(volume(found.mesh), 1, 1e-12);
}

TEST(BadCloud, DuplicatesAndNumbersThatAreNone) {
  Cloud cloud = sphere_cloud(600);
  const std::size_t clean = cloud.size();
  cloud.insert(cloud.end(), cloud.begin(), cloud.begin() + 200);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  cloud.insert(cloud.begin() + 50, {{nan, 0, 0}, {0, inf, 0}, {0, 0, -inf}, {nan, nan, nan}});
  const Reconstruction found = reconstructed(cloud);
  expect_closed(found, 0);
  expect_input_points(found, cloud);
  EXPECT_EQ(found.mesh.vertex_count(), clean);
  EXPECT_EQ(found.report.not_finite, 4U);
  EXPECT_EQ(found.report.duplicates, 200U);
  EXPECT_EQ(found.report.unused, 0U);
}

TEST(BadCloud, OnlyNumbersThatAreNone) {
  const double nan = std::nan("");
  const Error error = refusal(Cloud(10, Point{nan, nan, nan}));
  EXPECT_EQ(error.code, ErrorCode::empty_mesh);
  EXPECT_NE(error.message.find("10 not finite"), std::string::npos) << error.message;
}

TEST(BadCloud, FarFromTheOriginAndOfAnyScale) {
  const Cloud unit = sphere_cloud(500);
  // Powers of two, so that the points keep every bit: others move points that lie on one sphere.
  for (const double scale : {0x1p-660, 0x1p-100, 0x1p100, 0x1p660}) {
    Cloud scaled = unit;
    for (Point& p : scaled) {
      for (double& x : p) x *= scale;
    }
    SCOPED_TRACE(scale);
    const Reconstruction found = reconstructed(scaled);
    expect_input_points(found, scaled);
    EXPECT_EQ(found.report.open_loops, 0U);
    EXPECT_EQ(found.mesh.face_vertices, reconstructed(unit).mesh.face_vertices);
  }
  Cloud far = unit;
  for (Point& p : far) p[0] += 1e6;
  const Reconstruction moved = reconstructed(far);
  expect_input_points(moved, far);
  EXPECT_EQ(moved.report.genus, 0U);
}

TEST(BadCloud, BoxesThatOverflowAreRefused) {
  Cloud cloud = sphere_cloud(50);
  for (Point& p : cloud) {
    for (double& x : p) x *= 1.7e308;
  }
  EXPECT_EQ(refusal(cloud).code, ErrorCode::too_large);
}

Cloud two_spheres(double gap, double noise = 0) {
  constexpr double kSide = 0.0793;  // 2000 points: one in a square of this side
  Cloud cloud = sphere_cloud(2000);
  for (Point p : sphere_cloud(2000)) {
    for (double& x : p) x *= 1 - kSide * gap;
    cloud.push_back(p);
  }
  return with_noise(cloud, kSide * noise, 4);
}

TEST(BadCloud, SheetsCloserThanThePointsAreAreNamed) {
  const auto warns = [](const Reconstruction& found) {
    for (const std::string& warning : found.report.warnings) {
      if (warning.find("second sheet") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(warns(reconstructed(two_spheres(1.0))));
  const Reconstruction apart = reconstructed(two_spheres(2.5));
  EXPECT_FALSE(warns(apart));
  EXPECT_EQ(apart.report.pieces, 2U);
  EXPECT_EQ(apart.report.genus, 0U);
  EXPECT_EQ(apart.report.open_loops, 0U);
}

TEST(BadCloud, SheetsAreMeasuredAndAreNoNoise) {
  for (const double gap : {1.0, 1.2, 1.4, 1.6, 2.0}) {
    for (const double noise : {0.0, 0.1}) {
      SCOPED_TRACE(gap);
      const ReconstructReport report = reconstructed(two_spheres(gap, noise)).report;
      const double unit = report.spacing * report.box_side / 0.0793;  // spacings in sides
      ASSERT_TRUE(report.sheet_gap);
      EXPECT_NEAR(*report.sheet_gap * unit, gap, noise == 0 ? 0.01 * gap : 0.05 * gap);
      ASSERT_TRUE(report.noise);
      EXPECT_NEAR(*report.noise * unit, noise, noise == 0 ? 0.001 : 0.03);
    }
  }
}

TEST(BadCloud, BehindAnEdgeThereIsNoSecondSheet) {
  for (const int n : {8, 12, 20}) {
    const ReconstructReport report = reconstructed(cube_cloud(n)).report;
    EXPECT_FALSE(report.sheet_gap) << n;
    EXPECT_NEAR(report.noise.value_or(1), 0, 1e-9) << n;
  }
}

TEST(BadCloud, OptionsOutOfRange) {
  const Cloud cloud = sphere_cloud(50);
  for (const ReconstructOptions& options :
       {ReconstructOptions{.perimeter = -1.0}, ReconstructOptions{.tolerance = 0.0},
        ReconstructOptions{.tolerance = std::nan("")}, ReconstructOptions{.vertices = Index{3}},
        ReconstructOptions{.feature_angle = 180.0}}) {
    EXPECT_EQ(refusal(cloud, options).code, ErrorCode::invalid_argument);
  }
  const std::vector<Channel> short_channel = {{"color", {"red"}, {1, 2, 3}}};
  EXPECT_EQ(reconstruct(cloud, short_channel).error().code, ErrorCode::mismatch);
}

TEST(BadCloud, ABoundThatNoTriangleKeeps) {
  EXPECT_EQ(refusal(sphere_cloud(200), {.perimeter = 0.1}).code, ErrorCode::unsuitable_for_scheme);
}

}  // namespace
}  // namespace surpass::test

#include "render/camera.hpp"
#include "render_samples.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

using picture::Camera;
using samples::brightness;
using samples::count_drawn;
using samples::draw;
using samples::from_front;
using samples::is_drawn;
using samples::pixel;
using samples::sphere;
using samples::square;

// Area in pixels of the disc that a sphere around the origin covers, by elementary geometry: its
// outline is seen under the angle asin(r / d). `camera` was fitted to the unit sphere.
double disc_area(const Camera& camera, const RenderOptions& options, double radius) {
  const double unit = camera.to_unit({radius, 0, 0}).norm();
  const double sine = unit / static_cast<double>(camera.eye().norm());
  const double focal =
      (options.width / 2.0) / static_cast<double>(camera.ray(0, 0).dot(-camera.right()));
  const double disc = focal * sine / std::sqrt(1 - sine * sine);
  return std::numbers::pi * disc * disc;
}

TEST(RenderPicture, SphereCoversItsDisc) {
  const Mesh mesh = sphere(128, 64);
  RenderOptions options = from_front(500, 450);
  options.samples = 1;  // so that pixels count whose centre is covered
  const Camera camera(mesh.points, 0, options);
  const double expected = disc_area(camera, options, 1);
  EXPECT_NEAR(count_drawn(draw(mesh, options)) / expected, 1, 0.003);
}

TEST(RenderPicture, FrameIsSharedByMeshesOfDifferentSize) {
  RenderOptions options = from_front(500, 450);
  options.samples = 1;
  options.frame = sphere(128, 64).points;
  const Camera camera(options.frame, 0, options);
  for (const double radius : {1.0, 0.5, 0.25}) {
    const double expected = disc_area(camera, options, radius);
    const int drawn = count_drawn(draw(sphere(128, 64, radius), options));
    EXPECT_NEAR(drawn / expected, 1, 0.01) << radius;
  }
}

TEST(RenderPicture, IsBrighterTowardsTheKeyLight) {
  const Image image = draw(sphere(128, 64), from_front(400, 400));
  const int toward = brightness(image, 200 - 70, 200 - 85);
  const int centre = brightness(image, 200, 200);
  const int opposite = brightness(image, 200 + 70, 200 + 85);
  EXPECT_GT(toward, centre + 30);
  EXPECT_GT(centre, opposite + 60);
}

TEST(RenderPicture, BacksAreCool) {
  Mesh mesh = square(true);
  const RenderOptions options = from_front(200, 200);
  const auto front = pixel(draw(mesh, options), 120, 110);
  EXPECT_GT(front[0], front[2] + 10);
  std::reverse(mesh.face_vertices.begin(), mesh.face_vertices.end());
  const auto back = pixel(draw(mesh, options), 120, 110);
  EXPECT_GT(back[2], back[0] + 10);
}

TEST(RenderPicture, BallsAreWhereTheyProjectAndHiddenBehindTheSurface) {
  const Mesh mesh = sphere(64, 32);
  RenderOptions options = from_front(600, 500);
  options.point_radius = 0.02;
  const Point seen = {0.36, 0.48, 0.8};
  const Point hidden = {0.36, 0.48, -0.8};
  options.points = {seen, hidden};
  std::vector<Point> fitted = mesh.points;
  fitted.insert(fitted.end(), options.points.begin(), options.points.end());
  const Camera camera(fitted, options.point_radius, options);
  const Image image = draw(mesh, options);
  const auto is_red = [&](int x, int y) {
    const auto [r, g, b] = pixel(image, x, y);
    return r > 2 * g && r > 2 * b;
  };
  const picture::Vec2 place = camera.project(camera.to_unit(seen));
  double red = 0;
  picture::Vec2 mean(0, 0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!is_red(x, y)) continue;
      mean += picture::Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      red += 1;
    }
  }
  ASSERT_GT(red, 0);
  // One ball only: the other is behind. It is half sunk and seen from the side, so nearly a disc.
  EXPECT_LT((mean / static_cast<float>(red) - place).norm(), 2);
  const double radius =
      0.02 * static_cast<double>(camera.unit_side() / camera.pixel_size(camera.to_unit(seen)));
  EXPECT_LT(red, 1.1 * std::numbers::pi * radius * radius);
  EXPECT_GT(red, 0.75 * std::numbers::pi * radius * radius);
}

TEST(RenderPicture, MirroredSceneGivesMirroredOutline) {
  Mesh mesh;  // nothing about it is symmetric
  mesh.points = {{0, 0, 0}, {3, 0.5, 0}, {0.3, 2, 0.4}, {0.2, 0.1, 1.7}};
  mesh.face_offsets = {0, 3, 6, 9, 12};
  mesh.face_vertices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  Mesh mirrored = mesh;
  for (Point& p : mirrored.points) p[0] = -p[0];
  std::reverse(mirrored.face_vertices.begin(), mirrored.face_vertices.end());
  RenderOptions options;
  options.width = 400;
  options.height = 300;
  options.samples = 1;  // at pixel centres, which mirror onto each other
  const Image image = draw(mesh, options);
  options.azimuth = -options.azimuth;
  const Image other = draw(mirrored, options);
  int different = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      different += is_drawn(image, x, y) != is_drawn(other, image.width - 1 - x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(count_drawn(image), 20000);
  EXPECT_LE(different, 3);  // outlines that pass a pixel's centre by less than rounding
}

TEST(RenderPicture, HoleFacesAreNotDrawn) {
  Mesh mesh = test::quad_grid(4, 4);
  for (Point& p : mesh.points) p[2] = 0;
  mesh.hole_faces = {4};
  const Image image = draw(mesh, from_front(300, 300));
  EXPECT_FALSE(is_drawn(image, 150, 150));
  EXPECT_TRUE(is_drawn(image, 60, 150));
  EXPECT_TRUE(is_drawn(image, 150, 240));
}

TEST(RenderPicture, EdgesArePolygonsOwn) {
  RenderOptions options = from_front(300, 300);
  const auto on_diagonal = [&](bool cut, bool edges) {
    options.edges = edges;
    return brightness(draw(square(cut), options), 150, 149);
  };
  EXPECT_EQ(on_diagonal(false, true), on_diagonal(false, false));
  EXPECT_LT(on_diagonal(true, true), on_diagonal(true, false) - 100);
}

TEST(RenderPicture, FlatFacetsHaveOneShadeEach) {
  const Mesh mesh = sphere(12, 6);
  RenderOptions options = from_front(400, 400);
  options.crease_angle = 180;
  const auto spread = [&](bool smooth) {  // along a row inside one quad
    options.smooth = smooth;
    const Image image = draw(mesh, options);
    return std::abs(brightness(image, 210, 180) - brightness(image, 270, 180));
  };
  EXPECT_LE(spread(false), 8);  // what the gloss changes
  EXPECT_GT(spread(true), 20);
}

TEST(RenderPicture, FoldsAreDarker) {
  Mesh mesh;  // a floor and a wall, and the floor alone
  mesh.points = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 2}, {-1, 0, 2}, {1, 1.5, 0}, {-1, 1.5, 0}};
  mesh.add_face(std::array<Index, 4>{0, 3, 2, 1});
  Mesh both = mesh;
  both.add_face(std::array<Index, 4>{0, 1, 4, 5});
  RenderOptions options;
  options.frame = mesh.points;
  options.azimuth = 0;
  options.width = 400;
  options.height = 300;
  options.elevation = 40;
  const Camera camera(options.frame, 0, options);
  const picture::Vec2 near_wall = camera.project(camera.to_unit({0, 0, 0.1}));
  const picture::Vec2 far_away = camera.project(camera.to_unit({0, 0, 1.9}));
  const auto darkening = [&](const picture::Vec2& at) {
    const int x = static_cast<int>(at.x());
    const int y = static_cast<int>(at.y());
    return brightness(draw(mesh, options), x, y) - brightness(draw(both, options), x, y);
  };
  EXPECT_GT(darkening(near_wall), 20);
  EXPECT_LE(std::abs(darkening(far_away)), 2);
}

// Only every second pixel sends rays into the sky: it may not show.
TEST(RenderPicture, ShadesOfFoldsAreEven) {
  Mesh bowl = sphere(128, 64);
  for (Index f = 0; f < bowl.face_count(); ++f) {
    double front = 0;
    for (const Index v : bowl.face(f)) front += bowl.points[v][2];
    if (front > 0) bowl.hole_faces.push_back(f);
  }
  const Image image = draw(bowl, from_front(400, 400));
  const auto in_disc = [](int x, int y) { return std::hypot(x - 199.5, y - 199.5) < 150; };
  int darkest = 765;
  int brightest = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!in_disc(x, y)) continue;
      const int here = brightness(image, x, y);
      const int around = brightness(image, x - 1, y) + brightness(image, x + 1, y) +
                         brightness(image, x, y - 1) + brightness(image, x, y + 1);
      EXPECT_LE(std::abs(4 * here - around), 4 * 3) << x << ", " << y;
      darkest = std::min(darkest, here);
      brightest = std::max(brightest, here);
    }
  }
  EXPECT_GT(brightest, darkest + 100);
}

TEST(RenderPicture, SameBitsForAnyNumberOfThreads) {
  Mesh mesh = sphere(60, 30);
  RenderOptions options;
  options.width = 333;
  options.height = 257;  // more than one band of rows
  options.edges = true;
  options.points = {mesh.points[5], mesh.points[400]};
  const Image one = draw(mesh, options, 1);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(draw(mesh, options, threads).pixels, one.pixels) << threads;
  }
}

TEST(RenderPicture, DuplicateFacesAreDecidedByNumber) {
  Mesh mesh = square(true);  // both sides: front faces have the smaller numbers
  mesh.add_face(std::array<Index, 3>{2, 1, 0});
  mesh.add_face(std::array<Index, 3>{3, 2, 0});
  const auto seen = pixel(draw(mesh, from_front(200, 200)), 120, 110);
  EXPECT_GT(seen[0], seen[2] + 10);
}

TEST(RenderPicture, SizeAndPlaceOfTheMeshDoNotMatter) {
  const Mesh mesh = sphere(24, 12);
  RenderOptions options;
  options.width = 200;
  options.height = 150;
  const Image image = draw(mesh, options);
  for (const double scale : {std::ldexp(1.0, -300), std::ldexp(1.0, 300)}) {
    Mesh scaled = mesh;
    for (Point& p : scaled.points) {
      for (double& x : p) x *= scale;
    }
    EXPECT_EQ(draw(scaled, options).pixels, image.pixels);
  }
}

}  // namespace
}  // namespace surpass

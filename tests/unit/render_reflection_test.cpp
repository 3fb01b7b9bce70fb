// Reflection lines of a sphere, where the law of reflection tells each of them.
#include "render/camera.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using picture::Camera;
using samples::brightness;
using samples::draw;
using samples::from_front;
using samples::sphere;

TEST(RenderReflection, ASphereShowsTheLampsWhereTheLawOfReflectionSays) {
  const Mesh mesh = sphere(256, 128);
  RenderOptions options = from_front(600, 600);
  options.shading = Shading::reflection;
  const Image image = draw(mesh, options);
  const Camera camera(mesh.points, 0, options);
  const double radius = camera.to_unit({1, 0, 0}).norm();
  const double distance = static_cast<double>(camera.eye().norm());
  int bright = 0;
  int dark = 0;
  // Up the middle of the picture: the normal stands at the angle a over the horizon, the eye is
  // seen from there at e, and the reflected ray leaves at 2 a - e.
  for (double a = -1.1; a < 1.1; a += 0.002) {
    const double y = radius * std::sin(a);
    const double z = radius * std::cos(a);
    const double e = std::atan2(-y, distance - z);
    const double wave = std::cos(12 * (2 * a - e));
    if (std::abs(wave) < 0.75) continue;
    const auto place =
        camera.project(picture::Vec3(0, static_cast<float>(y), static_cast<float>(z)));
    const int seen = brightness(image, static_cast<int>(place.x()), static_cast<int>(place.y()));
    if (wave > 0) {
      EXPECT_GT(seen, 650) << a;
      ++bright;
    } else {
      EXPECT_LT(seen, 250) << a;
      ++dark;
    }
  }
  EXPECT_GT(bright, 200);
  EXPECT_GT(dark, 200);
}

TEST(RenderReflection, BallsStayMatte) {
  RenderOptions options = from_front(200, 200);
  options.points = {{0, 0, 1.5}};
  options.point_radius = 0.1;
  const Image matte = draw(sphere(32, 16), options);
  options.shading = Shading::reflection;
  const Image lines = draw(sphere(32, 16), options);
  EXPECT_EQ(samples::pixel(lines, 100, 100), samples::pixel(matte, 100, 100));
  EXPECT_NE(lines.pixels, matte.pixels);
}

}  // namespace
}  // namespace surpass

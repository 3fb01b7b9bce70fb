#include "render/display_mesh.hpp"
#include "render/scene.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using picture::Hit;
using picture::Probe;
using picture::Scene;
using picture::Vec3;

// The parts that a scene refers to.
struct Parts {
  explicit Parts(const Mesh& mesh, const std::vector<Vec3>& marks = {})
      : triangles(picture::make_display_mesh(mesh, {})->triangles) {
    for (const Vec3& p : marks) balls.push_back({p, 0.1F});
    for (const Point& p : mesh.points) points.push_back(picture::to_vector(p).cast<float>());
  }
  [[nodiscard]] Scene scene() const { return *Scene::build(points, triangles, balls, 1); }

  std::vector<Vec3> points;
  std::vector<picture::Triangle> triangles;
  std::vector<picture::Ball> balls;
};

TEST(RenderScene, RaysDoNotDependOnThoseBesideThem) {
  const Parts parts(samples::sphere(40, 20), {{0.5F, 0.5F, 1}, {-0.4F, 0.1F, 1.2F}});
  const Scene scene = parts.scene();
  const Vec3 eye(0.1F, 0.2F, 4);
  std::vector<Vec3> directions;
  for (int k = 0; k < 1003; ++k) {  // some meet nothing, and the last packet is not full
    const auto turn = static_cast<float>(k);
    directions.emplace_back(turn * 3e-4F * std::cos(turn), turn * 3e-4F * std::sin(turn), -1.0F);
  }
  std::vector<std::optional<Hit>> together(directions.size());
  scene.first_hits(eye, directions, together);
  int balls = 0;
  int nothing = 0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    std::optional<Hit> alone;
    scene.first_hits(eye, {&directions[k], 1}, {&alone, 1});
    ASSERT_EQ(together[k].has_value(), alone.has_value()) << k;
    nothing += alone ? 0 : 1;
    if (!alone) continue;
    EXPECT_EQ(together[k]->triangle, alone->triangle) << k;
    EXPECT_EQ(together[k]->position, alone->position) << k;
    EXPECT_EQ(together[k]->normal, alone->normal) << k;
    balls += alone->triangle == kNone ? 1 : 0;
  }
  EXPECT_GT(balls, 0);
  EXPECT_GT(nothing, 0);
}

TEST(RenderScene, OnlyTheSurfaceWithinReachBlocks) {
  const Parts parts(samples::square(true), {{0, 0, 0.5F}});
  const Scene scene = parts.scene();
  const auto down = [](float x, float length) { return Probe{{x, 0.1F, 1}, {0, 0, -1}, length}; };
  std::vector<Probe> probes;
  for (int k = 0; k < 13; ++k) {
    probes.push_back(down(0, 1.5F));  // through the ball, into the square
    probes.push_back(down(0, 0.9F));  // through the ball only
    probes.push_back(down(3, 1.5F));  // beside everything
  }
  EXPECT_EQ(scene.count_blocked(probes), 13U);
  EXPECT_EQ(scene.count_blocked({}), 0U);
}

}  // namespace
}  // namespace surpass

// For a fixed direction the closest perspective view that shows every point is exact and direct:
// each side of the viewing pyramid gives one linear bound on the eye's offset and distance.
#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace surpass::picture {
namespace {

// A long lens: half of the field of view along the shorter side of the picture, as a tangent.
constexpr double kHalfField = 0.24;
// Free part of the picture around the fitted points.
constexpr double kBorder = 0.06;

struct Axes {
  Eigen::Vector3d right, up, front;
};

// Where azimuth 0 looks from, and what lies to its right.
Axes scene_axes(char up) {
  using V = Eigen::Vector3d;
  if (up == 'z') return {V::UnitX(), V::UnitZ(), -V::UnitY()};
  if (up == 'x') return {V::UnitZ(), V::UnitX(), V::UnitY()};
  return {V::UnitX(), V::UnitY(), V::UnitZ()};
}

}  // namespace

Camera::Camera(std::span<const Point> points, double margin, const RenderOptions& options)
    : half_size_(static_cast<float>(options.width) / 2, static_cast<float>(options.height) / 2),
      focal_(half_size_.minCoeff() / static_cast<float>(kHalfField)) {
  const Box box = bounding_box(points);
  const Eigen::Vector3d low = to_vector(box.low);
  const Eigen::Vector3d high = to_vector(box.high);
  centre_ = low + (high - low) / 2;
  const double half_diagonal = (high - low).norm() / 2;
  if (half_diagonal > 0) {
    scale_ = 1 / half_diagonal;
    unit_side_ = static_cast<float>(box.side() * scale_);
  }
  turn(options);
  fit(points, margin * static_cast<double>(unit_side_));
}

void Camera::turn(const RenderOptions& options) {
  const Axes axes = scene_axes(options.up);
  const double a = options.azimuth * std::numbers::pi / 180;
  const double e = options.elevation * std::numbers::pi / 180;
  const Eigen::Vector3d ahead = std::sin(a) * axes.right + std::cos(a) * axes.front;
  right_ = (std::cos(a) * axes.right - std::sin(a) * axes.front).cast<float>();
  up_ = (std::cos(e) * axes.up - std::sin(e) * ahead).cast<float>();
  back_ = (std::cos(e) * ahead + std::sin(e) * axes.up).cast<float>();
  zenith_ = axes.up.cast<float>();
}

void Camera::fit(std::span<const Point> points, double margin) {
  const Vec2 slope = half_size_ / focal_ * static_cast<float>(1 - kBorder);
  // A ball of radius m touches the side of the pyramid where its centre is m * sqrt(1 + slope^2)
  // inside, measured along the picture plane.
  const float none = -std::numeric_limits<float>::infinity();
  std::array<std::array<float, 2>, 2> bound = {{{none, none}, {none, none}}};
  for (const Point& p : points) {
    const Vec3 u = to_unit(p);
    const Vec2 place(u.dot(right_), u.dot(up_));
    for (int k = 0; k < 2; ++k) {
      const float pad = static_cast<float>(margin) * std::sqrt(1 + slope[k] * slope[k]);
      auto& [low, high] = bound[static_cast<std::size_t>(k)];
      const float depth = slope[k] * u.dot(back_) + pad;
      high = std::max(high, depth + place[k]);
      low = std::max(low, depth - place[k]);
    }
  }
  const auto middle = [&](std::size_t k) { return (bound[k][1] - bound[k][0]) / 2; };
  const auto distance = [&](std::size_t k) {
    return (bound[k][1] + bound[k][0]) / (2 * slope[static_cast<int>(k)]);
  };
  // A single point without a margin is seen from one unit away.
  const float away = std::max(distance(0), distance(1));
  eye_ = right_ * middle(0) + up_ * middle(1) + back_ * (away > 0 ? away : 1);
}

Vec3 Camera::to_unit(const Point& p) const {
  return ((to_vector(p) - centre_) * scale_).cast<float>();
}

Vec3 Camera::ray(float x, float y) const {
  return (right_ * (x - half_size_.x()) + up_ * (half_size_.y() - y)) / focal_ - back_;
}

Vec2 Camera::project(const Vec3& unit) const {
  const Vec3 seen = unit - eye_;
  const float depth = -seen.dot(back_);
  const float zoom = depth > 0 ? focal_ / depth : std::numeric_limits<float>::quiet_NaN();
  return half_size_ + zoom * Vec2(seen.dot(right_), -seen.dot(up_));
}

}  // namespace surpass::picture

// For a fixed direction the closest perspective view that shows every point is exact and direct:
// each side of the viewing pyramid gives one linear bound on the eye's offset and distance.
#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace surpass::picture {
namespace {

// A long lens: half of the field of view along the shorter side of the picture, as a tangent.
constexpr double kHalfField = 0.24;
// Free part of the picture around the fitted points.
constexpr double kBorder = 0.06;
// The eye stays out of the ball around the fitted points, whose radius is 1.
constexpr float kNearest = 1.2F;

struct Axes {
  Eigen::Vector3d right, up, front;
};

struct Fit {
  float middle;
  float distance;
};

// The nearest eye from which balls around the points lie between two sides of the pyramid.
Fit fit_axis(std::span<const Vec3> seen, int axis, float slope, float radius) {
  // A ball touches a side where its centre is this far inside, measured along the picture plane.
  const float pad = radius * std::sqrt(1 + slope * slope);
  float low = -std::numeric_limits<float>::infinity();
  float high = low;
  for (const Vec3& p : seen) {
    low = std::max(low, slope * p.z() + pad - p[axis]);
    high = std::max(high, slope * p.z() + pad + p[axis]);
  }
  return {(high - low) / 2, (high + low) / (2 * slope)};
}

// Where this axis leaves room to spare: the place from which both sides have the same. A step
// takes away all of the difference but for the points' unequal depths.
float centre_axis(std::span<const Vec3> seen, int axis, const Fit& fit, float distance) {
  constexpr int kMostSteps = 8;
  float middle = fit.middle;
  for (int step = 0; step < kMostSteps && fit.distance < distance; ++step) {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (const Vec3& p : seen) {
      const float place = (p[axis] - middle) / (distance - p.z());
      low = std::min(low, place);
      high = std::max(high, place);
    }
    middle += distance * (low + high) / 2;
  }
  return middle;
}

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
  focal_ *= static_cast<float>(options.zoom);
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
  std::vector<Vec3> seen;  // right, up, towards the viewer
  seen.reserve(points.size());
  for (const Point& p : points) {
    const Vec3 u = to_unit(p);
    seen.emplace_back(u.dot(right_), u.dot(up_), u.dot(back_));
  }
  const auto radius = static_cast<float>(margin);
  const Vec2 slope = half_size_ / focal_ * static_cast<float>(1 - kBorder);
  const Fit x = fit_axis(seen, 0, slope.x(), radius);
  const Fit y = fit_axis(seen, 1, slope.y(), radius);
  const float away = std::max({x.distance, y.distance, kNearest});
  const Vec3 eye(centre_axis(seen, 0, x, away), centre_axis(seen, 1, y, away), away);
  eye_ = right_ * eye.x() + up_ * eye.y() + back_ * eye.z();
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

// A perspective camera that looks along a given direction and fits given points into the picture.
#pragma once

#include <surpass/render.hpp>

#include <span>

#include "render/vector.hpp"

namespace surpass::picture {

/// Positions are given in the mesh's own coordinates and drawn in the unit frame: the fitted
/// points' box has its centre at the origin and a half diagonal of 1. So single precision is enough
/// wherever the mesh lies and however large it is.
class Camera {
 public:
  /// Fits `points` (at least one) and, around each, a ball of `margin` box sides.
  Camera(std::span<const Point> points, double margin, const RenderOptions& options);

  [[nodiscard]] Vec3 to_unit(const Point& p) const;
  /// Length of the fitted points' largest box side in the unit frame; 2 for a single point.
  [[nodiscard]] float unit_side() const { return unit_side_; }

  [[nodiscard]] const Vec3& eye() const { return eye_; }
  [[nodiscard]] const Vec3& right() const { return right_; }
  [[nodiscard]] const Vec3& up() const { return up_; }
  /// Towards the viewer.
  [[nodiscard]] const Vec3& back() const { return back_; }
  /// The up axis of the scene.
  [[nodiscard]] const Vec3& zenith() const { return zenith_; }

  /// Direction of the ray through a place in the picture, in pixels from the upper left corner.
  /// Not a unit vector: its component along the view direction is 1.
  [[nodiscard]] Vec3 ray(float x, float y) const;
  /// Place in the picture of a position in the unit frame, in pixels; not finite behind the eye.
  [[nodiscard]] Vec2 project(const Vec3& unit) const;
  /// Width of a pixel at a position in the unit frame, seen from the front.
  [[nodiscard]] float pixel_size(const Vec3& unit) const {
    return (eye_ - unit).dot(back_) / focal_;
  }

 private:
  void turn(const RenderOptions& options);
  void fit(std::span<const Point> points, double margin);

  Eigen::Vector3d centre_ = {0, 0, 0};
  double scale_ = 1;
  float unit_side_ = 2;
  Vec3 eye_, right_, up_, back_, zenith_;
  Vec2 half_size_;  // of the picture, in pixels
  float focal_;     // distance of the picture plane, in pixels
};

}  // namespace surpass::picture

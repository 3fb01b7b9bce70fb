// What rays meet: the triangles and the balls of a picture, in Embree.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <embree3/rtcore.h>

#include "render/display_mesh.hpp"

namespace surpass::picture {

/// Where a ray met something first.
struct Hit {
  Vec3 position;
  Index triangle = kNone;       ///< or kNone for a ball
  Vec3 weights = Vec3::Zero();  ///< of the triangle's three corners
  Vec3 normal = Vec3::Zero();   ///< of the triangle's plane or the ball, of unit length
};

class Scene {
 public:
  /// `points` and `balls` are in the unit frame. Keeps the spans. While a scene exists Embree
  /// limits TBB to `threads`.
  static Result<Scene> build(std::span<const Vec3> points, std::span<const Triangle> triangles,
                             std::span<const Vec3> balls, float ball_radius, int threads);

  /// The first hit in front of `origin`. `direction` need not be of unit length.
  [[nodiscard]] std::optional<Hit> first_hit(const Vec3& origin, const Vec3& direction) const;
  /// Whether the surface (not a ball) lies within `length` times `direction`.
  [[nodiscard]] bool is_blocked(const Vec3& origin, const Vec3& direction, float length) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  void add_triangles(std::span<const Vec3> points, std::span<const Triangle> triangles);
  void add_balls(std::span<const Vec3> balls, float radius);
  [[nodiscard]] Hit describe_hit(const RTCRayHit& found) const;

  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  std::span<const Vec3> balls_;
};

}  // namespace surpass::picture

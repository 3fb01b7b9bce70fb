// What rays meet: the triangles and the balls of a picture, in Embree.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <embree3/rtcore.h>

#include "render/display_mesh.hpp"

namespace surpass::picture {

struct Ball {
  Vec3 centre;
  float radius;
};

/// Where a ray met something first.
struct Hit {
  Vec3 position;
  Index triangle = kNone;  ///< or kNone for a ball
  Index ball = kNone;
  Vec3 weights = Vec3::Zero();  ///< of the triangle's three corners
  Vec3 normal = Vec3::Zero();   ///< of the triangle's plane or the ball, of unit length
};

/// A ray that something may block.
struct Probe {
  Vec3 origin;
  Vec3 direction;
  float length;  ///< in lengths of `direction`
};

/// Rays are followed many at a time, which takes a fraction of the time of one by one.
class Scene {
 public:
  /// `points` and `balls` are in the unit frame. Keeps the spans. While a scene exists Embree
  /// limits TBB to `threads`.
  static Result<Scene> build(std::span<const Vec3> points, std::span<const Triangle> triangles,
                             std::span<const Ball> balls, int threads);

  /// The first hit in front of `origin` along each direction, which need not be of unit length.
  void first_hits(const Vec3& origin, std::span<const Vec3> directions,
                  std::span<std::optional<Hit>> hits) const;
  /// How many of the probes the surface (not a ball) blocks.
  [[nodiscard]] std::size_t count_blocked(std::span<const Probe> probes) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  void add_triangles(std::span<const Vec3> points, std::span<const Triangle> triangles);
  void add_balls(std::span<const Ball> balls);
  [[nodiscard]] std::optional<Hit> describe_hit(const RTCRayHit8& found, std::size_t i) const;

  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  std::span<const Ball> balls_;
};

}  // namespace surpass::picture

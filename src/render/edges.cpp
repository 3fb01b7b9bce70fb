#include "render/edges.hpp"

#include <algorithm>

namespace surpass::picture {
namespace {

constexpr float kWidth = 1.3F;  // pixels, both faces together

float distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const float length2 = along.squaredNorm();
  const float t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
  return (a + t * along - p).norm();
}

}  // namespace

EdgeLines::EdgeLines(std::span<const Vec3> points, const Camera& camera) {
  places_.reserve(points.size());
  for (const Vec3& p : points) places_.push_back(camera.project(p));
}

float EdgeLines::coverage(const Triangle& triangle, const Vec2& place, float spacing) const {
  float most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!triangle.own_side[k]) continue;
    const Vec2& a = places_[triangle.vertices[k]];
    const Vec2& b = places_[triangle.vertices[(k + 1) % 3]];
    if (!a.allFinite() || !b.allFinite()) continue;  // reaches behind the eye
    const float inside = kWidth / 2 - distance_to_segment(place, a, b);
    most = std::max(most, std::clamp(0.5F + inside / spacing, 0.0F, 1.0F));
  }
  return most;
}

}  // namespace surpass::picture

// Reflection lines: a mirror in a hall of parallel lamps. A line breaks where the normal jumps, has
// a corner where the curvature jumps, and wiggles where the surface does. R. Klass, Correction of
// local surface irregularities using reflection lines, Computer-Aided Design 12 (1980).
#include <cmath>

#include "render/style.hpp"

namespace surpass::picture {
namespace {

const Colour kLamp = {0.93F, 0.93F, 0.91F};
const Colour kHall = {0.045F, 0.060F, 0.085F};
const Colour kHallBehind = {0.160F, 0.045F, 0.035F};  // in the backs of faces

constexpr float kLamps = 12;        // around the axis
constexpr float kSharpness = 3.0F;  // of a lamp's edge, so that few samples show it smooth

}  // namespace

Light reflection(const SurfacePlace& place, const Camera& camera) {
  if (place.ball) return matte(place, camera);
  const Vec3 mirrored = 2 * place.normal.dot(place.to_eye) * place.normal - place.to_eye;
  // Lamps are infinitely long and far, parallel to the picture's horizontal.
  const float angle = std::atan2(mirrored.dot(camera.up()), mirrored.dot(camera.back()));
  const float wave = kSharpness * std::cos(kLamps * angle);
  const float lit = 0.5F + 0.5F * std::max(-1.0F, std::min(1.0F, wave));
  const Colour dark = place.back ? kHallBehind : kHall;
  Light light;
  light.direct = dark + lit * (kLamp - dark);
  return light;
}

}  // namespace surpass::picture

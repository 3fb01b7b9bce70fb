// Colours that stand for numbers must not be mistaken for light: only as much shade as the eye
// needs to see the form, and none where the surface faces the viewer.
#include "render/style.hpp"

namespace surpass::picture {
namespace {

constexpr float kFromViewer = 0.30F;  // the light that comes with the view
constexpr float kFromSky = 0.20F;     // what folds get less of

}  // namespace

Light painted(const SurfacePlace& place, const Camera& camera) {
  if (place.ball) return matte(place, camera);
  Light light;
  light.direct =
      place.paint * (1 - kFromViewer - kFromSky + kFromViewer * place.normal.dot(place.to_eye));
  light.sky = place.paint * kFromSky;
  return light;
}

Light paper(const SurfacePlace& place, const Camera& camera) {
  SurfacePlace pale = place;
  pale.paint = place.back ? Colour(0.52F, 0.58F, 0.64F) : Colour(0.90F, 0.90F, 0.88F);
  return painted(pale, camera);
}

}  // namespace surpass::picture

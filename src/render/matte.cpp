#include <algorithm>
#include <cmath>

#include "render/style.hpp"

namespace surpass::picture {
namespace {

struct Lamp {
  Vec3 direction;  // right, up, towards the viewer
  Colour colour;
  float wrap;  // how far round the edge its light reaches, as if it were large
};

const Lamp kKey = {{-0.50F, 0.62F, 0.60F}, {1.36F, 1.30F, 1.21F}, 0.15F};
const Lamp kFill = {{0.80F, 0.05F, 0.55F}, {0.19F, 0.21F, 0.24F}, 0.40F};

const Colour kZenith = {0.46F, 0.47F, 0.49F};
const Colour kGround = {0.19F, 0.17F, 0.15F};

const Colour kFront = {0.455F, 0.392F, 0.322F};
const Colour kBack = {0.130F, 0.215F, 0.300F};
const Colour kBall = {0.560F, 0.022F, 0.020F};

constexpr float kGloss = 0.10F;
constexpr float kGlossPower = 32;

Vec3 direction_of(const Lamp& lamp, const Camera& camera) {
  return (lamp.direction.x() * camera.right() + lamp.direction.y() * camera.up() +
          lamp.direction.z() * camera.back())
      .normalized();
}

Colour diffuse(const Lamp& lamp, const Vec3& towards, const Vec3& normal) {
  return lamp.colour * (std::max(0.0F, normal.dot(towards) + lamp.wrap) / (1 + lamp.wrap));
}

}  // namespace

Light matte(const SurfacePlace& place, const Camera& camera) {
  const Colour base = place.ball ? kBall : place.back ? kBack : kFront;
  const Vec3 key = direction_of(kKey, camera);
  const Vec3 half = (key + place.to_eye).normalized();
  const float gloss = kGloss * std::pow(std::max(0.0F, place.normal.dot(half)), kGlossPower);
  const float height = (1 + place.normal.dot(camera.zenith())) / 2;
  Light light;
  light.direct = base * diffuse(kKey, key, place.normal) + kKey.colour * gloss;
  light.sky = base * (diffuse(kFill, direction_of(kFill, camera), place.normal) + kGround +
                      (kZenith - kGround) * height);
  return light;
}

}  // namespace surpass::picture

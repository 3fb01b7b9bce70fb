// Embree (Wald et al., Embree: a kernel framework for efficient CPU ray tracing, 2014).
#include "render/scene.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace surpass::picture {
namespace {

constexpr unsigned kTriangles = 0;
constexpr unsigned kBalls = 1;

// Ray masks: balls mark places and do not darken the surface around them.
constexpr unsigned kAll = ~0U;
constexpr unsigned kSurface = 1U << kTriangles;

template <class T>
T* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), count));
}

// Of two hits at the same distance (on a common edge, of duplicate faces) Embree keeps the one that
// it meets first, which depends on how its hierarchy was built. Here the smaller number wins.
struct NearestHit {
  RTCIntersectContext context;  // first: Embree hands back its address
  float distance = std::numeric_limits<float>::infinity();
  std::pair<unsigned, unsigned> number = {};  // geometry and primitive
};

void keep_nearest(const RTCFilterFunctionNArguments* arguments) {
  auto& nearest = *reinterpret_cast<NearestHit*>(arguments->context);
  const float distance = reinterpret_cast<const RTCRay*>(arguments->ray)->tfar;
  const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
  const std::pair number(hit.geomID, hit.primID);
  if (std::pair(distance, number) < std::pair(nearest.distance, nearest.number)) {
    nearest.distance = distance;
    nearest.number = number;
  } else {
    arguments->valid[0] = 0;
  }
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcSetGeometryMask(geometry, 1U << id);
  rtcSetGeometryIntersectFilterFunction(geometry, keep_nearest);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCRay make_ray(const Vec3& origin, const Vec3& direction, float length, unsigned mask) {
  RTCRay ray = {};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tfar = length;
  ray.mask = mask;
  return ray;
}

}  // namespace

Result<Scene> Scene::build(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           std::span<const Vec3> balls, float ball_radius, int threads) {
  Scene scene;
  scene.device_.reset(rtcNewDevice(fmt::format("threads={}", threads).c_str()));
  scene.scene_.reset(rtcNewScene(scene.device_.get()));
  if (scene.scene_ == nullptr) {
    return fail(ErrorCode::not_built_in, "Embree cannot run on this processor");
  }
  rtcSetSceneFlags(scene.scene_.get(), RTC_SCENE_FLAG_ROBUST);
  scene.points_ = points;
  scene.triangles_ = triangles;
  scene.balls_ = balls;
  scene.add_triangles(points, triangles);
  if (!balls.empty()) scene.add_balls(balls, ball_radius);
  rtcCommitScene(scene.scene_.get());
  if (rtcGetDeviceError(scene.device_.get()) != RTC_ERROR_NONE) {
    return fail(ErrorCode::too_large, "Embree could not hold the mesh in memory");
  }
  return scene;
}

void Scene::add_triangles(std::span<const Vec3> points, std::span<const Triangle> triangles) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = new_buffer<std::array<float, 3>>(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                    RTC_FORMAT_FLOAT3, points.size());
  auto* indices = new_buffer<std::array<unsigned, 3>>(geometry, RTC_BUFFER_TYPE_INDEX,
                                                      RTC_FORMAT_UINT3, triangles.size());
  if (vertices != nullptr && indices != nullptr) {
    std::transform(points.begin(), points.end(), vertices, [](const Vec3& p) {
      return std::array{p.x(), p.y(), p.z()};
    });
    std::transform(triangles.begin(), triangles.end(), indices,
                   [](const Triangle& t) { return t.vertices; });
  }
  attach(scene_.get(), geometry, kTriangles);
}

void Scene::add_balls(std::span<const Vec3> balls, float radius) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* spheres = new_buffer<std::array<float, 4>>(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                   RTC_FORMAT_FLOAT4, balls.size());
  if (spheres != nullptr) {
    std::transform(balls.begin(), balls.end(), spheres, [radius](const Vec3& p) {
      return std::array{p.x(), p.y(), p.z(), radius};
    });
  }
  attach(scene_.get(), geometry, kBalls);
}

std::optional<Hit> Scene::first_hit(const Vec3& origin, const Vec3& direction) const {
  NearestHit nearest;
  rtcInitIntersectContext(&nearest.context);
  nearest.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit found = {};
  found.ray = make_ray(origin, direction, std::numeric_limits<float>::infinity(), kAll);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &nearest.context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return describe_hit(found);
}

Hit Scene::describe_hit(const RTCRayHit& found) const {
  const RTCRay& ray = found.ray;
  const Vec3 origin(ray.org_x, ray.org_y, ray.org_z);
  const Vec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  Hit hit;
  if (found.hit.geomID == kBalls) {
    hit.position = origin + ray.tfar * direction;
    hit.normal = (hit.position - balls_[found.hit.primID]).normalized();
    return hit;
  }
  // From the corners rather than along the ray: exact to a few units in the last place.
  hit.triangle = found.hit.primID;
  const auto& [a, b, c] = triangles_[hit.triangle].vertices;
  hit.weights = {1 - found.hit.u - found.hit.v, found.hit.u, found.hit.v};
  hit.position =
      hit.weights[0] * points_[a] + hit.weights[1] * points_[b] + hit.weights[2] * points_[c];
  hit.normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]).stableNormalized();
  return hit;
}

bool Scene::is_blocked(const Vec3& origin, const Vec3& direction, float length) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = make_ray(origin, direction, length, kSurface);
  rtcOccluded1(scene_.get(), &context, &ray);
  return ray.tfar < 0;
}

}  // namespace surpass::picture

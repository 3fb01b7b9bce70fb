// Embree (Wald et al., Embree: a kernel framework for efficient CPU ray tracing, 2014).
#include "render/scene.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

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

// Rays that Embree follows together.
constexpr std::size_t kPacket = 8;
using Valid = std::array<int, kPacket>;  // -1 for rays to follow, 0 for others

// Of two hits at the same distance (on a common edge, of duplicate faces) Embree keeps the one that
// it meets first, which depends on how its hierarchy was built. Here the smaller number wins.
struct NearestHits {
  using Rank = std::tuple<float, unsigned, unsigned>;  // distance, geometry and primitive

  RTCIntersectContext context;  // first: Embree hands back its address
  std::array<Rank, kPacket> ranks;
};

void keep_nearest(const RTCFilterFunctionNArguments* arguments) {
  auto& nearest = *reinterpret_cast<NearestHits*>(arguments->context);
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; ++i) {
    if (arguments->valid[i] == 0) continue;
    const NearestHits::Rank rank(RTCRayN_tfar(arguments->ray, n, i),
                                 RTCHitN_geomID(arguments->hit, n, i),
                                 RTCHitN_primID(arguments->hit, n, i));
    NearestHits::Rank& least = nearest.ranks[RTCRayN_id(arguments->ray, n, i)];
    if (rank < least) {
      least = rank;
    } else {
      arguments->valid[i] = 0;
    }
  }
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcSetGeometryMask(geometry, 1U << id);
  rtcSetGeometryIntersectFilterFunction(geometry, keep_nearest);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

void set_ray(RTCRay8& rays, std::size_t i, const Probe& probe, unsigned mask) {
  rays.org_x[i] = probe.origin.x();
  rays.org_y[i] = probe.origin.y();
  rays.org_z[i] = probe.origin.z();
  rays.dir_x[i] = probe.direction.x();
  rays.dir_y[i] = probe.direction.y();
  rays.dir_z[i] = probe.direction.z();
  rays.tfar[i] = probe.length;
  rays.mask[i] = mask;
  rays.id[i] = static_cast<unsigned>(i);
}

// Calls follow(first, count, valid) for the consecutive packets of `n` rays.
template <class Follow>
void for_packets(std::size_t n, const Follow& follow) {
  for (std::size_t first = 0; first < n; first += kPacket) {
    const std::size_t count = std::min(kPacket, n - first);
    alignas(32) Valid valid = {};
    std::fill_n(valid.begin(), count, -1);
    follow(first, count, valid);
  }
}

}  // namespace

Result<Scene> Scene::build(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           std::span<const Ball> balls, int threads) {
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
  if (!triangles.empty()) scene.add_triangles(points, triangles);
  if (!balls.empty()) scene.add_balls(balls);
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

void Scene::add_balls(std::span<const Ball> balls) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* spheres = new_buffer<std::array<float, 4>>(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                   RTC_FORMAT_FLOAT4, balls.size());
  if (spheres != nullptr) {
    std::transform(balls.begin(), balls.end(), spheres, [](const Ball& ball) {
      return std::array{ball.centre.x(), ball.centre.y(), ball.centre.z(), ball.radius};
    });
  }
  attach(scene_.get(), geometry, kBalls);
}

void Scene::first_hits(const Vec3& origin, std::span<const Vec3> directions,
                       std::span<std::optional<Hit>> hits) const {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  for_packets(directions.size(), [&](std::size_t first, std::size_t count, const Valid& valid) {
    NearestHits nearest;
    nearest.ranks.fill({kFar, 0, 0});
    rtcInitIntersectContext(&nearest.context);
    nearest.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit8 found = {};
    for (std::size_t i = 0; i < count; ++i) {
      set_ray(found.ray, i, {origin, directions[first + i], kFar}, kAll);
      found.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid.data(), scene_.get(), &nearest.context, &found);
    for (std::size_t i = 0; i < count; ++i) hits[first + i] = describe_hit(found, i);
  });
}

std::optional<Hit> Scene::describe_hit(const RTCRayHit8& found, std::size_t i) const {
  if (found.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const RTCRay8& ray = found.ray;
  Hit hit;
  if (found.hit.geomID[i] == kBalls) {
    const Vec3 origin(ray.org_x[i], ray.org_y[i], ray.org_z[i]);
    const Vec3 direction(ray.dir_x[i], ray.dir_y[i], ray.dir_z[i]);
    hit.position = origin + ray.tfar[i] * direction;
    hit.ball = found.hit.primID[i];
    hit.normal = (hit.position - balls_[hit.ball].centre).normalized();
    return hit;
  }
  // From the corners rather than along the ray: exact to a few units in the last place.
  hit.triangle = found.hit.primID[i];
  const auto& [a, b, c] = triangles_[hit.triangle].vertices;
  const float u = found.hit.u[i];
  const float v = found.hit.v[i];
  hit.weights = {1 - u - v, u, v};
  hit.position = hit.weights[0] * points_[a] + u * points_[b] + v * points_[c];
  hit.normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]).stableNormalized();
  return hit;
}

std::size_t Scene::count_blocked(std::span<const Probe> probes) const {
  std::size_t blocked = 0;
  for_packets(probes.size(), [&](std::size_t first, std::size_t count, const Valid& valid) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay8 rays = {};
    for (std::size_t i = 0; i < count; ++i) set_ray(rays, i, probes[first + i], kSurface);
    rtcOccluded8(valid.data(), scene_.get(), &context, &rays);
    for (std::size_t i = 0; i < count; ++i) blocked += rays.tfar[i] < 0 ? 1 : 0;
  });
  return blocked;
}

}  // namespace surpass::picture

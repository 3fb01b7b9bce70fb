#include "reconstruct_clouds.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "support/meshes.hpp"

namespace surpass::test {
namespace {

using Eigen::Vector3d;

double distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

// Solves for the foot in the plane of the triangle; outside, the nearest edge counts.
double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                            const Vector3d& c) {
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d uv = edges.colPivHouseholderQr().solve(p - a);
  if (uv[0] >= 0 && uv[1] >= 0 && uv.sum() <= 1) return (p - a - edges * uv).norm();
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

}  // namespace

Cloud sphere_cloud(std::size_t n) {
  Cloud cloud;
  const double golden = M_PI * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double r = std::sqrt(1 - z * z);
    const double angle = golden * static_cast<double>(i);
    cloud.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return cloud;
}

Cloud torus_cloud(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Cloud cloud;
  while (cloud.size() < n) {
    const double u = 2 * M_PI * unit(random);
    const double v = 2 * M_PI * unit(random);
    const double radius = 1 + 0.4 * std::cos(v);
    if (1.4 * unit(random) > radius) continue;
    cloud.push_back({radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v)});
  }
  return cloud;
}

Cloud double_torus_cloud() {
  const auto given = read_mesh(SURPASS_DATA_DIR "/double_torus.obj");
  EXPECT_TRUE(given);
  return limit_mesh(given->mesh, {}, 2)->points;
}

Cloud cube_cloud(int n) {
  Cloud cloud;
  const double last = n - 1;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        const bool inside = x > 0 && x < n - 1 && y > 0 && y < n - 1 && z > 0 && z < n - 1;
        if (!inside) cloud.push_back({x / last, y / last, z / last});
      }
    }
  }
  return cloud;
}

Cloud wave_cloud(int n) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  Cloud cloud;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (i + shift(random)) / (n - 1);
      const double y = (j + shift(random)) / (n - 1);
      cloud.push_back({x, y, 0.3 * std::sin(3 * x) * std::cos(2 * y)});
    }
  }
  return cloud;
}

Cloud with_noise(Cloud cloud, double sigma, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, sigma);
  for (Point& p : cloud) {
    for (double& x : p) x += noise(random);
  }
  return cloud;
}

Cloud with_outliers(Cloud cloud, std::size_t count, std::uint64_t seed) {
  const Box box = bounding_box(cloud);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  for (std::size_t i = 0; i < count; ++i) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = box.low[k] + box.side() * place(random);
    cloud.push_back(p);
  }
  return cloud;
}

Cloud shuffled(Cloud cloud, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(cloud.begin(), cloud.end(), random);
  return cloud;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    sum +=
        vec(mesh.points[face[0]]).dot(vec(mesh.points[face[1]]).cross(vec(mesh.points[face[2]])));
  }
  return sum / 6;
}

void expect_input_points(const Reconstruction& found, const Cloud& given) {
  ASSERT_EQ(found.source.size(), found.mesh.points.size());
  for (std::size_t v = 0; v < found.source.size(); ++v) {
    ASSERT_LT(found.source[v], given.size());
    ASSERT_EQ(found.mesh.points[v], given[found.source[v]]);
  }
}

void expect_closed(const Reconstruction& found, std::size_t genus) {
  const auto topology = Topology::build(found.mesh);
  ASSERT_TRUE(topology) << describe(topology.error());
  EXPECT_EQ(topology->boundary_edge_count(), 0U);
  EXPECT_EQ(find_components(*topology).count, 1U);
  EXPECT_EQ(found.report.open_loops, 0U);
  // V - E + F = 2 - 2 g, counted here from the faces.
  const auto faces = static_cast<std::int64_t>(found.mesh.face_count());
  const auto vertices = static_cast<std::int64_t>(found.mesh.vertex_count());
  EXPECT_EQ(vertices - faces / 2, 2 - 2 * static_cast<std::int64_t>(genus));
  EXPECT_EQ(found.report.genus, genus);
  EXPECT_GT(volume(found.mesh), 0);
}

Reconstruction reconstructed(const Cloud& cloud, const ReconstructOptions& options) {
  auto found = reconstruct(cloud, {}, options);
  EXPECT_TRUE(found) << (found ? "" : describe(found.error()));
  return found ? std::move(*found) : Reconstruction{};
}

double slow_distance(const Point& p, const Mesh& mesh) {
  double nearest = INFINITY;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    nearest = std::min(
        nearest, distance_to_triangle(vec(p), vec(mesh.points[face[0]]), vec(mesh.points[face[1]]),
                                      vec(mesh.points[face[2]])));
  }
  return nearest;
}

}  // namespace surpass::test

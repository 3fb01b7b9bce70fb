// The measures and the parts, against slow or closed forms.
#include <cmath>

#include "reconstruct/clean_up.hpp"
#include "reconstruct/neighbours.hpp"
#include "reconstruct/quadric.hpp"
#include "reconstruct_clouds.hpp"
#include "support/meshes.hpp"

namespace surpass::test {
namespace {

TEST(PointDistances, AreThoseOfEveryTriangle) {
  const Mesh mesh = icosahedron();
  const Cloud points = with_outliers({{-1, -1, -1}, {1, 1, 1}}, 400, 3);
  double largest = 0;
  double sum = 0;
  std::vector<double> all;
  for (const Point& p : points) {
    all.push_back(slow_distance(p, mesh));
    largest = std::max(largest, all.back());
    sum += all.back();
  }
  std::sort(all.begin(), all.end());
  const auto found = point_distances(points, mesh);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, points.size());
  EXPECT_NEAR(found->max, largest, 1e-13);
  EXPECT_NEAR(found->mean, sum / static_cast<double>(points.size()), 1e-13);
  EXPECT_NEAR(slow_distance(points[found->farthest], mesh), largest, 1e-13);
  EXPECT_NEAR(found->percentile99, all[397], 1e-13);  // 402 points: rank 398
}

TEST(PointDistances, OfPolygonsAndOfPointsThatAreNone) {
  const Mesh square = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const Cloud points = {{0.5, 0.5, 2}, {std::nan(""), 0, 0}, {4, 1, 4}};
  const auto found = point_distances(points, square);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, 2U);
  EXPECT_DOUBLE_EQ(found->max, 5);
  EXPECT_EQ(found->farthest, 2U);
  EXPECT_FALSE(point_distances(Cloud{}, square));
  EXPECT_EQ(point_distances(points, Mesh{}).error().code, ErrorCode::empty_mesh);
}

TEST(LimitDistances, OfASphereThroughItsPoints) {
  const Cloud cloud = sphere_cloud(3000);
  const Reconstruction found = reconstructed(cloud, {.vertices = Index{600}});
  const Rules rules{.scheme = Scheme::doo_sabin};
  const auto control = interpolate(found.mesh, {.rules = rules, .tolerance = 1e-12});
  ASSERT_TRUE(control);
  const auto all = limit_distances(cloud, found.source, {}, control->control, rules);
  ASSERT_TRUE(all);
  // A point listed as unused counts among all only.
  const std::vector<Index> unused = {all->all.farthest};
  const auto fewer = limit_distances(cloud, found.source, unused, control->control, rules);
  EXPECT_EQ(fewer->all.max, all->all.max);
  EXPECT_LT(fewer->used.max, all->all.max);
  EXPECT_EQ(fewer->used.count + 1, fewer->all.count);
  // The estimate of the sampling covers what a finer surface changes.
  const auto finer = limit_mesh(control->control, rules, all->levels + 1);
  ASSERT_TRUE(finer);
  EXPECT_NEAR(point_distances(cloud, *finer)->max, all->all.max, 2 * *all->sampling);
}

TEST(Neighbours, AreTheNearest) {
  const Cloud cloud = torus_cloud(300, 2);
  const reconstruction::Neighbours neighbours(cloud);
  std::vector<Index> found;
  for (const Index i : {Index{0}, Index{17}, Index{299}}) {
    std::vector<std::pair<double, Index>> all;
    for (Index j = 0; j < cloud.size(); ++j) {
      const double d = std::hypot(cloud[i][0] - cloud[j][0], cloud[i][1] - cloud[j][1],
                                  cloud[i][2] - cloud[j][2]);
      if (j != i) all.emplace_back(d, j);
    }
    std::sort(all.begin(), all.end());
    neighbours.nearest(i, 12, found);
    ASSERT_EQ(found.size(), 12U);
    for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(found[k], all[k].second);
  }
  neighbours.nearest(0, 1000, found);
  EXPECT_EQ(found.size(), 299U);
}

TEST(Quadric, IsTheSumOfSquaredDistances) {
  reconstruction::Quadric quadric;
  const Eigen::Vector3d tilted = Eigen::Vector3d(1, 2, -2) / 3;
  quadric.add_plane({0, 0, 1}, {5, 6, 1});
  quadric.add_plane(tilted, {1, 0, 0});
  const Eigen::Vector3d p(0.3, -0.7, 2);
  const double expected = 1 + std::pow(tilted.dot(p - Eigen::Vector3d(1, 0, 0)), 2);
  EXPECT_NEAR(quadric.at(p), expected, 1e-14);
}

Mesh punched(Mesh mesh, std::size_t faces) {
  mesh.face_vertices.resize(mesh.face_vertices.size() - 3 * faces);
  mesh.face_offsets.resize(mesh.face_offsets.size() - faces);
  return mesh;
}

TEST(FillHoles, TheDomeOfAnIcosahedronComesBack) {
  Mesh mesh = punched(icosahedron(), 1);
  const auto holes = reconstruction::fill_holes(mesh, Closing::all, {});
  ASSERT_TRUE(holes);
  EXPECT_EQ(holes->filled, 1U);
  EXPECT_EQ(mesh.face_count(), 20U);
  EXPECT_NEAR(volume(mesh), volume(icosahedron()), 1e-12);
}

TEST(FillHoles, LongLoopsAreCutFirst) {
  // A tube of 400 edges around, open at both ends.
  Mesh tube;
  constexpr Index kAround = 400;
  for (Index ring = 0; ring < 2; ++ring) {
    for (Index i = 0; i < kAround; ++i) {
      const double t = 2 * M_PI * i / kAround;
      tube.points.push_back({std::cos(t), std::sin(t), 0.1 * ring});
    }
  }
  for (Index i = 0; i < kAround; ++i) {
    const Index j = (i + 1) % kAround;
    tube.add_face(std::array{i, j, kAround + j});
    tube.add_face(std::array{i, kAround + j, kAround + i});
  }
  EXPECT_EQ(reconstruction::fill_holes(tube, Closing::small, {})->left, 2U);
  const auto holes = reconstruction::fill_holes(tube, Closing::all, {});
  ASSERT_TRUE(holes);
  EXPECT_EQ(holes->left, 0U);
  const auto topology = Topology::build(tube);
  ASSERT_TRUE(topology) << describe(topology.error());
  EXPECT_EQ(topology->boundary_edge_count(), 0U);
  const double area = kAround / 2.0 * std::sin(2 * M_PI / kAround);
  EXPECT_NEAR(volume(tube), 0.1 * area, 1e-12);
}

TEST(FillHoles, NoEdgeIsMadeTwice) {
  // Two triangles on one edge: across the hole that their outline is, the diagonal is taken.
  Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  ASSERT_TRUE(reconstruction::fill_holes(mesh, Closing::all, {}));
  EXPECT_TRUE(Topology::build(mesh));
}

TEST(OrientPieces, EachForItself) {
  Mesh mesh = icosahedron();
  const Mesh second = octahedron();
  for (const Point& p : second.points) mesh.points.push_back({p[0] + 10, p[1], p[2]});
  for (Index f = 0; f < second.face_count(); ++f) {
    const auto face = second.face(f);  // inward
    mesh.add_face(std::array{face[0] + 12, face[2] + 12, face[1] + 12});
  }
  const double outward = volume(icosahedron()) + volume(octahedron());
  ASSERT_LT(volume(mesh), outward - 1);
  reconstruction::orient_pieces(mesh, {});
  EXPECT_NEAR(volume(mesh), outward, 1e-12);
}

TEST(DropSmallPieces, ButNeverTheLargest) {
  Mesh mesh = icosahedron();
  mesh.points.insert(mesh.points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  mesh.add_face(std::array<Index, 3>{12, 13, 14});
  EXPECT_EQ(reconstruction::drop_small_pieces(mesh, 0.1), 1U);
  EXPECT_EQ(mesh.face_count(), 20U);
  EXPECT_EQ(reconstruction::drop_small_pieces(mesh, 2), 0U);
}

}  // namespace
}  // namespace surpass::test

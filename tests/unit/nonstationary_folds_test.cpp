// Curves that would turn a non-stationary Loop surface over.
#include <algorithm>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

using test::largest_error;
using test::made;
using test::side;

// Sums of the faces' area vectors.
std::vector<Point> area_vectors(const Mesh& mesh) {
  std::vector<Point> sums(mesh.points.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto from_first = [&](Index w, std::size_t c) {
      return mesh.points[w][c] - mesh.points[face[0]][c];
    };
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3;
      const std::size_t e = (c + 2) % 3;
      const double area = from_first(face[1], d) * from_first(face[2], e) -
                          from_first(face[1], e) * from_first(face[2], d);
      for (const Index v : face) sums[v][c] += area;
    }
  }
  return sums;
}

// Vertices whose normal is on the other side than their faces.
std::vector<Index> turned(const NonstationaryLoop& surface) {
  const auto normals = surface.limit_normals().value();
  const auto areas = area_vectors(surface.mesh());
  std::vector<Index> found;
  for (Index v = 0; v < normals.size(); ++v) {
    double cosine = 0;
    for (std::size_t c = 0; c < 3; ++c) cosine += normals[v][c] * areas[v][c];
    if (cosine < 0) found.push_back(v);
  }
  return found;
}

std::vector<Index> corners_of(const Mesh& mesh) {
  std::vector<Index> corners;
  for (const Corner& corner : mesh.corners) corners.push_back(corner.vertex);
  std::sort(corners.begin(), corners.end());
  return corners;
}

Mesh crumpled(unsigned seed) {
  std::mt19937_64 random(seed);
  return test::jitter(test::triangle_grid(5, 4), random, 1);
}

TEST(NonstationaryFolds, BecomeCorners) {
  std::size_t folds = 0;
  for (unsigned seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = crumpled(seed);
    const NonstationaryOptions smooth{.boundary = Boundary::edge_only, .corners_at_folds = false};
    const auto kept = made(mesh, smooth);
    EXPECT_TRUE(kept.notes().empty());
    EXPECT_TRUE(kept.mesh().corners.empty());
    const auto on_curves = [&](const std::vector<Index>& vertices) {
      const auto topology = Topology::build(mesh).value();
      std::vector<Index> found;
      std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(found),
                   [&](Index v) { return topology.is_boundary(v); });
      return found;
    };
    const std::vector<Index> before = on_curves(turned(kept));
    folds += before.size();

    const auto surface = made(mesh, {.boundary = Boundary::edge_only});
    const std::vector<Index> corners = corners_of(surface.mesh());
    // A corner has no tangent plane: its normal is the mean of its faces', whatever their area.
    const std::vector<Index> after = on_curves(turned(surface));
    EXPECT_TRUE(std::includes(corners.begin(), corners.end(), after.begin(), after.end()));
    EXPECT_TRUE(std::includes(corners.begin(), corners.end(), before.begin(), before.end()));
    EXPECT_EQ(corners.empty(), before.empty());
    EXPECT_EQ(surface.notes().size(), before.empty() ? 0U : 1U);
    EXPECT_LE(largest_error(surface.limit_positions().value(), mesh.points), 1e-14 * side(mesh));
  }
  EXPECT_GE(folds, 20U);
}

}  // namespace
}  // namespace surpass

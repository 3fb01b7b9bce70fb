// Every committed mesh, and every mesh of a folder given from outside, as a non-stationary Loop
// surface: it interpolates, in the limit and after exact steps, and its normals are not turned
// over; or it is refused for a reason that is checked.
#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace surpass {
namespace {

struct NonstationaryTally {
  int interpolated = 0;
  int refused = 0;
  int on_boundaries = 0;  ///< normals of boundary vertices that were compared
};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Sums of the faces' area vectors around each vertex.
std::vector<Point> area_normals(const Mesh& mesh) {
  std::vector<Point> sums(mesh.points.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Point u = {};
    Point w = {};
    for (std::size_t c = 0; c < 3; ++c) {
      u[c] = mesh.points[face[1]][c] - mesh.points[face[0]][c];
      w[c] = mesh.points[face[2]][c] - mesh.points[face[0]][c];
    }
    const Point n = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                     u[0] * w[1] - u[1] * w[0]};
    for (const Index v : face) {
      for (std::size_t c = 0; c < 3; ++c) sums[v][c] += n[c];
    }
  }
  return sums;
}

void expect_finite(const std::vector<Point>& points) {
  for (const Point& p : points) {
    ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
  }
}

void expect_met(std::vector<Point> found, const Mesh& given) {
  expect_finite(found);
  found.resize(given.points.size());
  const auto certificate = compare_points(found, given.points, "test");
  const double tolerance =
      floored_tolerance(1e-14, flat(given.points), bounding_box(given.points).side());
  EXPECT_LE(certificate->max, tolerance) << "vertex " << certificate->worst_vertex;
}

/// Normals are on the side of the faces wherever Loop's are.
void expect_outward(const Mesh& given, const std::vector<Point>& normals, const Rules& rules,
                    NonstationaryTally& tally) {
  const auto topology = Topology::build(given).value();
  const auto loop = limit_normals(given, rules).value();
  const auto areas = area_normals(given);
  const double least = 1e-9 * std::pow(bounding_box(given.points).side(), 2);
  for (Index v = 0; v < given.vertex_count(); ++v) {
    // Where Loop's normal is nearly perpendicular to the area's, there is no side.
    const double side = dot(loop[v], areas[v]);
    if (side <= std::max(least, 1e-6 * std::sqrt(dot(areas[v], areas[v])))) continue;
    EXPECT_GT(dot(normals[v], areas[v]), 0) << "vertex " << v;
    tally.on_boundaries += topology.is_boundary(v) ? 1 : 0;
  }
}

void check_surface(const Mesh& given, Boundary boundary, NonstationaryTally& tally) {
  const int levels = given.vertex_count() > 3000 ? 1 : 2;  // time
  for (const double shape : {kDefaultShape, kRoundShape}) {
    NonstationaryOptions options{.shape = shape, .boundary = boundary};
    auto surface = NonstationaryLoop::create(given, options).value();
    expect_outward(given, surface.limit_normals().value(), {Scheme::loop, boundary}, tally);
    for (int level = 0; level <= levels; ++level) {
      expect_met(surface.limit_positions().value(), given);
      expect_finite(surface.limit_normals().value());
      if (level < levels) {
        ASSERT_TRUE(surface.refine());
      }
    }
    options.steps = levels;
    auto exact = NonstationaryLoop::create(given, options).value();
    for (int step = 0; step < levels; ++step) ASSERT_TRUE(exact.refine());
    expect_met(exact.mesh().points, given);
  }
}

/// A reason that stands in the mesh.
void check_refusal(const Mesh& given, const Error& error) {
  const auto topology = Topology::build(given);
  if (!topology) {
    EXPECT_EQ(error.code, topology.error().code);
    return;
  }
  ASSERT_EQ(error.code, ErrorCode::unsuitable_for_scheme) << describe(error);
  if (error.place.face) {
    EXPECT_NE(given.face(*error.place.face).size(), 3);
  } else if (error.place.edge) {
    EXPECT_FALSE(given.creases.empty());
  } else {
    ASSERT_TRUE(error.place.vertex);
    EXPECT_TRUE(!given.creases.empty() || !given.corners.empty() ||
                topology->valence(*error.place.vertex) < 3);
  }
}

NonstationaryTally check_nonstationary(const std::vector<std::string>& paths) {
  NonstationaryTally tally;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto loaded = read_mesh(path);
    if (!loaded) {
      ADD_FAILURE() << describe(loaded.error());
      continue;
    }
    const auto possible = NonstationaryLoop::create(loaded->mesh);
    if (!possible) {
      check_refusal(loaded->mesh, possible.error());
      ++tally.refused;
      continue;
    }
    const bool open = Topology::build(loaded->mesh)->boundary_edge_count() > 0;
    check_surface(loaded->mesh, Boundary::edge_only, tally);
    if (open) check_surface(loaded->mesh, Boundary::edge_and_corner, tally);
    ++tally.interpolated;
  }
  return tally;
}

TEST(EveryMeshNonstationary, CommittedOnesInterpolate) {
  const auto tally = check_nonstationary(test::committed_meshes());
  EXPECT_GE(tally.interpolated, 20);
}

TEST(EveryMeshNonstationary, GivenTrianglesInterpolate) {
  if (test::data_folder().empty()) GTEST_SKIP() << "needs a folder of real meshes";
  const auto tally = check_nonstationary(test::real_meshes("tri"));
  EXPECT_GE(tally.interpolated, 90) << tally.refused << " refused";
  EXPECT_GE(tally.on_boundaries, 10000);
}

}  // namespace
}  // namespace surpass

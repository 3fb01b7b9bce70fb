// Limit normals: against OpenSubdiv's tangents where it has one plane, and everywhere against the
// normals of deeply refined faces, which know no mask.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "osd.hpp"
#include "scheme/ring.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

double angle(const Point& a, const Point& b) {
  const Point c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::hypot(c[0], c[1], c[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

constexpr std::array kSchemes = {Scheme::loop, Scheme::catmull_clark};

TEST(Normals, SmoothVerticesMatchOpenSubdiv) {
  for (const auto& [scheme, kind] : {std::pair{Scheme::loop, 0},
                                     {Scheme::loop, 1},
                                     {Scheme::catmull_clark, 0},
                                     {Scheme::catmull_clark, 1}}) {
    const Mesh mesh = test::random_mesh_for(scheme, {.seed = 3, .kind = kind});
    const Rules rules{scheme, Boundary::edge_only};
    const auto ours = limit_normals(mesh, rules).value();
    const auto theirs = test::osd_normals(mesh, rules);
    for (std::size_t v = 0; v < ours.size(); ++v) EXPECT_LT(angle(ours[v], theirs[v]), 1e-12) << v;
  }
}

// OpenSubdiv's mask across a boundary is an eigenvector of the boundary rule for up to three faces.
// For more it is not; there the next tests let refinement decide.
TEST(Normals, BoundaryVerticesOfUpToThreeFacesMatchOpenSubdiv) {
  const Mesh mesh = test::random_mesh({.seed = 3, .kind = 2, .size = 8});
  const Topology topology = Topology::build(mesh).value();
  const auto ours = limit_normals(mesh, {Scheme::loop, Boundary::edge_only}).value();
  const auto theirs = test::osd_normals(mesh, Rules{Scheme::loop, Boundary::edge_only});
  int compared = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!topology.is_boundary(v) || topology.faces_at(v) > 3) continue;
    EXPECT_LT(angle(ours[v], theirs[v]), 1e-7) << v;
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

// Normal of one fan of refined faces around a vertex after `levels` steps: tends to the limit
// normal.
Point refined_normal(const Mesh& mesh, const Rules& rules, Index v, int levels) {
  const Mesh fine = refine(mesh, rules, levels).value();
  const auto limit = limit_positions(fine, rules).value();
  const Topology topology = Topology::build(fine).value();
  Point sum = {};
  topology.for_each_outgoing(v, [&](Index h) {
    const Point& o = limit[v];
    const Point& p = limit[topology.head(h)];
    const Point& q = limit[topology.tail(topology.previous(h))];
    const Point a = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    const Point b = {q[0] - o[0], q[1] - o[1], q[2] - o[2]};
    Point n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k] / length;
  });
  return sum;
}

// The error of refined faces shrinks by a constant factor a level; were its limit not ours, the
// angle would stay.
void expect_refined_normals_to_close_in(const Mesh& mesh, const Rules& rules, Index v) {
  const Point ours = limit_normals(mesh, rules).value()[v];
  const double coarse = angle(ours, refined_normal(mesh, rules, v, 2));
  const double fine = angle(ours, refined_normal(mesh, rules, v, 7));
  EXPECT_LT(fine, 0.5 * coarse + 1e-9) << "vertex " << v << ", coarse " << coarse;
}

TEST(Normals, DartsAreTheLimitOfRefinedFaces) {
  for (const Index n : {4U, 5U, 6U, 7U}) {
    Mesh mesh = test::bipyramid(n);
    for (Index i = 0; i < n; ++i) mesh.points[i][2] += 0.2 * std::cos(2.0 * i) + 0.1 * i / n;
    mesh.creases.push_back({{n, 1}, 10});
    for (const Scheme scheme : kSchemes) expect_refined_normals_to_close_in(mesh, {scheme}, n);
  }
}

// A boundary vertex, number 0, with n faces that do not lie in a plane.
Mesh boundary_fan(Index n) {
  Mesh mesh;
  mesh.points.push_back({0, 0, 0});
  for (Index i = 0; i <= n; ++i) {
    const double t = M_PI * i / n;
    mesh.points.push_back({std::cos(t), std::sin(t), 0.3 * std::sin(2.0 * i) + 0.1 * i});
  }
  for (Index i = 0; i < n; ++i) mesh.add_face(std::vector<Index>{0, i + 1, i + 2});
  return mesh;
}

TEST(Normals, BoundariesUnderEveryRuleAreTheLimitOfRefinedFaces) {
  for (const Boundary boundary : {Boundary::edge_only, Boundary::hoppe}) {
    for (const Index faces : {1U, 3U, 4U}) {
      expect_refined_normals_to_close_in(boundary_fan(faces), {Scheme::loop, boundary}, 0);
    }
  }
  // With four faces or more an inner mode fades no faster than the curve does.
  for (const Index faces : {2U, 3U}) {
    const Rules rules{Scheme::catmull_clark, Boundary::edge_only};
    expect_refined_normals_to_close_in(boundary_fan(faces), rules, 0);
  }
}

TEST(Normals, SemiSharpVerticesAreTheLimitOfRefinedFaces) {
  Mesh mesh = test::icosahedron();
  mesh.points[0][1] += 0.4;
  mesh.creases = {{{0, 11}, 1.4F}, {{0, 7}, 0.7F}};
  for (const Scheme scheme : kSchemes) {
    for (const Index v : {0U, 7U, 11U}) expect_refined_normals_to_close_in(mesh, {scheme}, v);
  }
}

// What makes a tangent mask exact: refinement does not change the tangent plane.
void expect_invariant_normals(const Mesh& mesh, const Rules& rules) {
  const auto before = limit_normals(mesh, rules).value();
  const auto after = limit_normals(refine(mesh, rules, 1).value(), rules).value();
  const Topology topology = Topology::build(mesh).value();
  const Sharpness sharpness = Sharpness::build(mesh, topology, rules.boundary).value();
  for (Index v = 0; v < before.size(); ++v) {
    const Ring ring = Ring::around(topology, sharpness, v);
    if (ring.size() == 0 || ring.rule() == VertexRule::corner) continue;
    // Catmull-Clark surfaces have no tangent plane where one face alone lies beside a curve.
    if (rules.scheme == Scheme::catmull_clark && ring.rule() == VertexRule::crease) {
      const auto found = sectors(ring);
      if (std::any_of(found.begin(), found.end(), [](const Sector& s) { return s.faces == 1; })) {
        continue;
      }
    }
    EXPECT_LT(angle(before[v], after[v]), 1e-10)
        << name_of(rules.scheme) << ", vertex " << v << ", " << name_of(rules.boundary);
  }
}

TEST(Normals, AreInvariantUnderRefinement) {
  for (const int kind : {0, 1, 2, 3, 4}) {
    for (const bool semi_sharp : {false, true}) {
      const test::RandomShape shape{
          .seed = 21, .kind = kind, .creases = 0.1, .semi_sharp = semi_sharp};
      const Mesh triangles = test::random_mesh(shape);
      for (const Boundary boundary :
           {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe}) {
        expect_invariant_normals(triangles, {Scheme::loop, boundary});
      }
      const Mesh polygons = test::random_polygons(shape);
      for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
        expect_invariant_normals(polygons, {Scheme::catmull_clark, boundary});
      }
    }
  }
}

TEST(Normals, PointOutwardOnConvexMeshes) {
  const Mesh mesh = test::icosahedron();
  const auto normals = limit_normals(mesh, {}).value();
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_LT(angle(normals[v], mesh.points[v]), 1e-12);  // by symmetry
  }
}

}  // namespace
}  // namespace surpass

// Normals and directions that the least change would meet by tangents of length 0: they are met by
// tangents worth the name, or refused by a sentence that names all that take part.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/polygons.hpp"
#include "support/requirements.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;
constexpr double kShort = 0.3;  // of the length that the tangent has without requirements

double length(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// The two tangents at a corner of the given mesh, as lengths, and the sine between them.
std::array<double, 3> tangents_at(const Mesh& control, Index corner) {
  const SurfaceSample s = LimitSurface::create(control, {Scheme::catmull_clark})
                              .value()
                              .evaluate({corner, 0, 0})
                              .value();
  const Point cross = {s.du[1] * s.dv[2] - s.du[2] * s.dv[1], s.du[2] * s.dv[0] - s.du[0] * s.dv[2],
                       s.du[0] * s.dv[1] - s.du[1] * s.dv[0]};
  return {length(s.du), length(s.dv), length(cross) / length(s.du) / length(s.dv)};
}

Index corner_of(const Mesh& mesh, Index vertex) {
  const auto at = std::find(mesh.face_vertices.begin(), mesh.face_vertices.end(), vertex);
  return static_cast<Index>(at - mesh.face_vertices.begin());
}

Mesh flat_sheet() {
  Mesh mesh = test::quad_grid(7, 7);
  for (Point& p : mesh.points) p[2] = 0;
  return mesh;
}

std::vector<Index> rim_of(const Mesh& mesh) {
  const Topology topology = Topology::build(mesh).value();
  std::vector<Index> rim;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (topology.is_boundary(v) && topology.faces_at(v) == 2) rim.push_back(v);
  }
  return rim;
}

// The neighbour inside.
Index inner_of(const Mesh& mesh, Index vertex) {
  const Topology topology = Topology::build(mesh).value();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Index next = face[(k + 1) % face.size()];
      if (face[k] == vertex && !topology.is_boundary(next)) return next;
      if (next == vertex && !topology.is_boundary(face[k])) return face[k];
    }
  }
  return kNone;
}

void expect_met(const Mesh& mesh, const std::vector<Requirement>& all,
                const std::vector<Index>& corners) {
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.similarity = form;
    const auto plain_found = interpolate_required(mesh, {}, options);
    ASSERT_TRUE(plain_found) << describe(plain_found.error());
    const auto& plain = *plain_found;
    const auto found = interpolate_required(mesh, all, options);
    ASSERT_TRUE(found) << name_of(form) << ": " << describe(found.error());
    EXPECT_LT(found->report.solve.final.max, 1e-14);
    for (const RequirementOutcome& outcome : found->report.requirements) {
      EXPECT_LT(outcome.error, 1e-14);
      EXPECT_FALSE(outcome.flipped);
    }
    for (const Index corner : corners) {
      const auto before = tangents_at(plain.control, corner);
      const auto after = tangents_at(found->control, corner);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(after[k], kShort * before[k]) << name_of(form);
    }
  }
}

TEST(RequirementTangents, AFlatSheetCanBeAskedToStandUpright) {
  const Mesh mesh = flat_sheet();
  const std::vector<Index> rim = rim_of(mesh);
  ASSERT_EQ(rim.size(), 20U);
  std::vector<Requirement> upright;
  std::vector<Requirement> normals;
  std::vector<Index> corners;
  for (const Index v : rim) {
    const Index inner = inner_of(mesh, v);
    upright.push_back(test::towards(Kind::direction, v, inner, {0, 0, 1}));
    Point out = mesh.points[v];
    for (std::size_t c = 0; c < 3; ++c) out[c] -= mesh.points[inner][c];
    normals.push_back(test::at_vertex(Kind::normal, v, out));
    corners.push_back(corner_of(mesh, v));
  }
  expect_met(mesh, {upright[3]}, {corners[3]});
  expect_met(mesh, {normals[3]}, {corners[3]});
  expect_met(mesh, upright, corners);
  expect_met(mesh, normals, corners);
}

TEST(RequirementTangents, HardlyAnyLengthIsNoLength) {
  const Mesh mesh = flat_sheet();
  const Index v = rim_of(mesh)[2];
  const Index inner = inner_of(mesh, v);
  Point almost = {0, 0, 1};
  for (std::size_t c = 0; c < 2; ++c)
    almost[c] = 1e-6 * (mesh.points[inner][c] - mesh.points[v][c]);
  expect_met(mesh, {test::towards(Kind::direction, v, inner, almost)}, {corner_of(mesh, v)});
}

// Whoever asks for a short tangent gets it, a normal beside it or not.
TEST(RequirementTangents, AShortDerivativeIsNoShrunkSurface) {
  const Mesh mesh = test::cube();
  for (const double length : {1e-2, 1e-5, 1e-7}) {
    SCOPED_TRACE(length);
    const std::vector<Requirement> both = {test::towards(Kind::derivative, 0, 1, {length, 0, 0}),
                                           test::at_vertex(Kind::normal, 0, {0, -1, -1})};
    const auto found = interpolate_required(mesh, both);
    ASSERT_TRUE(found) << describe(found.error());
    for (const RequirementOutcome& outcome : found->report.requirements) {
      EXPECT_LT(outcome.error, 1e-12);
    }
  }
}

// The surface turns over there, for its sign is a part of what a normal says.
TEST(RequirementTangents, OppositeNormalsAndDirectionsAreMetWithTheirSign) {
  const Mesh mesh = test::icosahedron();
  const Index corner = corner_of(mesh, 5);
  const Index next = mesh.face_vertices[corner / 3 * 3 + (corner + 1) % 3];
  Point back;
  for (std::size_t c = 0; c < 3; ++c) back[c] = mesh.points[5][c] - mesh.points[next][c];
  const auto inward = [&](Index v) {
    const Point& p = mesh.points[v];
    return test::at_vertex(Kind::normal, v, {-p[0], -p[1], -p[2]});
  };
  const std::vector<Requirement> all = {inward(0), inward(7),
                                        test::towards(Kind::direction, 5, next, back)};
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.similarity = form;
    options.rules = {Scheme::catmull_clark};
    const auto found = interpolate_required(mesh, all, options);
    ASSERT_TRUE(found) << describe(found.error());
    const LimitSurface surface = LimitSurface::create(found->control, options.rules).value();
    for (const Index v : {0U, 7U}) {
      const Point n = surface.evaluate({corner_of(mesh, v), 0, 0}).value().normal;
      const Point& p = mesh.points[v];
      EXPECT_NEAR(n[0] * p[0] + n[1] * p[1] + n[2] * p[2], -length(p), 1e-12);
    }
    const Point du = surface.evaluate({corner, 0, 0}).value().du;
    const double along = du[0] * back[0] + du[1] * back[1] + du[2] * back[2];
    EXPECT_NEAR(along, length(du) * length(back), 1e-12);
    for (const auto& outcome : found->report.requirements) {
      EXPECT_LT(outcome.error, 1e-14);
      EXPECT_FALSE(outcome.flipped);
      EXPECT_TRUE(outcome.length_chosen);
    }
  }
}

// Where nothing else is asked: a mesh's own normals, turned inward, at some vertices or at all.
TEST(RequirementTangents, ManyOppositeNormalsAreMetWithTheirSign) {
  const Mesh mesh = test::random_polygons({.seed = 4, .kind = 1, .size = 8});
  const Rules rules{Scheme::catmull_clark};
  const auto normals = limit_normals(mesh, rules).value();
  for (const Index every : {5U, 1U}) {
    std::vector<Requirement> all;
    for (Index v = 0; v < mesh.vertex_count(); v += every) {
      const Point& n = normals[v];
      all.push_back(test::at_vertex(Kind::normal, v, {-n[0], -n[1], -n[2]}));
    }
    const auto found = interpolate_required(mesh, all);
    ASSERT_TRUE(found) << describe(found.error());
    for (const RequirementOutcome& outcome : found->report.requirements) {
      EXPECT_LT(outcome.error, 1e-14);
      EXPECT_LT(outcome.angle, 1e-12);
    }
  }
}

// How far the tangents have to move: along one the whole length, for a normal the lesser of two
// that are orthogonal.
TEST(RequirementTangents, TheErrorOfAnOppositeSignIsTheWayToTheRightOne) {
  const Mesh mesh = flat_sheet();
  const Rules rules{Scheme::catmull_clark};
  const SurfacePlace place{14, 0.5, 0.5};
  const SurfaceSample s = LimitSurface::create(mesh, rules).value().evaluate(place).value();
  ASSERT_EQ(s.normal, (Point{0, 0, 1}));
  const double side = bounding_box(mesh.points).side();
  const auto expect = [&](const Requirement& r, double error) {
    const auto outcome = certify_required(mesh, mesh, rules, std::vector{r}).value().outcomes[0];
    EXPECT_NEAR(outcome.error, error / side, 1e-14);
    EXPECT_EQ(outcome.flipped, error > 0);
    EXPECT_NEAR(outcome.angle, error > 0 ? std::acos(-1.0) : 0, 1e-12);
  };
  expect(test::on_face(Kind::normal, place, {0, 0, 1}), 0);
  // By the parameters of the mesh refined once, where derivatives are half as long.
  expect(test::on_face(Kind::normal, place, {0, 0, -1}), std::min(length(s.du), length(s.dv)) / 2);
  const Point back = {-s.du[0], -s.du[1], -s.du[2]};
  expect(test::on_face(Kind::direction, place, s.du, {1, 0}), 0);
  expect(test::on_face(Kind::direction, place, back, {1, 0}), length(s.du));
}

TEST(RequirementTangents, NormalsAcrossTheSurfaceAreMet) {
  expect_met(test::cube(), {test::on_face(Kind::normal, {0, 0.5, 0.5}, {1, 0, 0})}, {});
  const Mesh mesh = flat_sheet();
  const Index v = 24;  // in the middle
  expect_met(mesh, {test::at_vertex(Kind::normal, v, {1, 0, 0})}, {corner_of(mesh, v)});
}

// What else is required at the place decides how the tangents lie.
TEST(RequirementTangents, PrescribedDerivativesStayBesideTurnedNormals) {
  const Mesh mesh = flat_sheet();
  const Index v = 24;
  const Index next = mesh.face_vertices[corner_of(mesh, v) + 1];
  for (const Kind kind : {Kind::derivative, Kind::direction}) {
    for (const Point& value : {Point{0, 0.3, 0}, Point{0, -0.3, 0}, Point{0, 0.3, -0.01}}) {
      SCOPED_TRACE(fmt::format("{} {} {}", name_of(kind), value[1], value[2]));
      expect_met(mesh,
                 {test::towards(kind, v, next, value), test::at_vertex(Kind::normal, v, {1, 0, 0}),
                  test::at_vertex(Kind::normal, 10, {0, 0.1, 1})},
                 {corner_of(mesh, v)});
    }
  }
}

TEST(RequirementTangents, ChosenLengthsHaveTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = flat_sheet();
  std::vector<Requirement> all;
  for (const Index v : rim_of(mesh)) {
    all.push_back(test::towards(Kind::direction, v, inner_of(mesh, v), {0, 0, 1}));
  }
  const auto one = interpolate_required(mesh, all, {}, {.threads = 1}).value();
  const auto two = interpolate_required(mesh, all, {}, {.threads = 2}).value();
  EXPECT_EQ(one.control.points, two.control.points);
}

void expect_refusal(const Mesh& mesh, const std::vector<Requirement>& all,
                    const std::vector<std::string>& named, const std::string& innocent = "?") {
  const auto result = interpolate_required(mesh, all, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::contradictory);
  const std::string& message = result.error().message;
  for (const std::string& name : named) {
    EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
  }
  EXPECT_EQ(message.find(innocent), std::string::npos) << message;
}

TEST(RequirementTangents, AllThatExcludeEachOtherTogetherAreNamed) {
  const Mesh mesh = test::cube();
  const Index corner = corner_of(mesh, 0);
  const auto face = mesh.face(corner / 4);
  const Index next = face[(corner + 1) % 4];
  const Index before = face[(corner + 3) % 4];
  expect_refusal(mesh,
                 {test::at_vertex(Kind::normal, 0, {0, 0, 1}),
                  test::towards(Kind::direction, 0, next, {1, 0, 0}),
                  test::at_vertex(Kind::normal, 6, {0, 0, 1}),
                  test::towards(Kind::direction, 0, before, {1, 0, 0}),
                  test::at_vertex(Kind::normal, 0, {0, 0, 1})},
                 {"contradict each other", "0 (normal at vertex 0)", "1 (direction at vertex 0",
                  "3 (direction at vertex 0"},
                 "2 (normal");
}

// Points of a cubic curve that rises from a given vertex and stands still at the last of them.
std::vector<Requirement> curve_that_stops(const Mesh& mesh, Index face) {
  const Point& start = mesh.points[mesh.face(face)[0]];
  std::vector<Requirement> all;
  for (const double t : {1.0 / 3, 2.0 / 3, 1.0}) {
    const double rise = 0.1 * (1 - std::pow(1 - t, 3));
    all.push_back(test::on_face(Kind::position, {face, t, 0, 0}, {start[0], start[1], rise}));
  }
  return all;
}

// A derivative follows from the curve, by shares so large that a decomposition may overlook it.
TEST(RequirementTangents, WhatFollowsByLargeSharesIsRedundant) {
  const Mesh mesh = flat_sheet();
  std::vector<Requirement> all = curve_that_stops(mesh, 14);
  all.push_back(test::on_face(Kind::derivative, {14, 1, 0, 0}, {}));
  const auto found = interpolate_required(mesh, all, {});
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->report.requirements[3].redundant);
  for (const auto& outcome : found->report.requirements) EXPECT_LT(outcome.error, 1e-13);
}

// The equations of the direction there hold, and nothing can give the tangent a length.
TEST(RequirementTangents, WhereNoLengthIsLeftAllThatTakePartAreNamed) {
  const Mesh mesh = flat_sheet();
  std::vector<Requirement> all = curve_that_stops(mesh, 14);
  all.push_back(test::on_face(Kind::direction, {14, 1, 0, 0}, {0, 0, 1}));
  expect_refusal(
      mesh, all,
      {"no surface was found", "0 (position", "1 (position", "2 (position", "3 (direction"});
}

// There the normals of the surface are stand-ins, and would be reported as met.
TEST(RequirementTangents, ANormalNeedsATangentPlane) {
  Mesh sharp = test::cube();
  sharp.corners.push_back({0, kInfinitelySharp});
  Mesh pinched = test::cube();
  pinched = test::split_edge(pinched, pinched.face(0)[0], pinched.face(0)[1], {-2, -2, -2});
  const Index added = pinched.vertex_count() - 1;
  for (const auto& [mesh, v] : {std::pair{sharp, Index{0}}, std::pair{pinched, added}}) {
    const auto result =
        interpolate_required(mesh, std::vector{test::at_vertex(Kind::normal, v, {0, 0, 1})}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::contradictory);
    EXPECT_NE(result.error().message.find("no tangent plane"), std::string::npos);
    EXPECT_EQ(result.error().place.vertex, v);
    const std::vector<Point> normals(mesh.points.size(), Point{0, 0, 1});
    const auto elsewhere = normals_everywhere(mesh, {Scheme::catmull_clark}, normals).value();
    for (const Requirement& r : elsewhere) EXPECT_NE(r.vertex, v);
  }
}

// What is returned at an interior vertex of valence 2 is a stand-in: no plane is there that the
// normals nearby tend to. They swing about it, to the other side with each halving.
TEST(RequirementTangents, NormalsNearValenceTwoSwingAboutTheStandIn) {
  Mesh mesh = test::cube();
  mesh = test::split_edge(mesh, mesh.face(0)[0], mesh.face(0)[1], {-2, -2, -2});
  const LimitSurface surface =
      LimitSurface::create(refine(mesh, {Scheme::catmull_clark}, 1).value(),
                           {Scheme::catmull_clark})
          .value();
  const Index corner = corner_of(mesh, mesh.vertex_count() - 1);
  const SurfaceSample there = surface.evaluate({corner, 0, 0}).value();
  EXPECT_FALSE(surface.stencil({corner, 0, 0}).value().has_plane);
  EXPECT_EQ(there.du, Point{});
  EXPECT_NEAR(length(there.normal), 1, 1e-14);
  const auto off = [&](int k) {
    const double u = std::ldexp(1.0, -k);
    Point n = surface.evaluate({corner, u, u}).value().normal;
    for (std::size_t c = 0; c < 3; ++c) n[c] -= there.normal[c];
    return n;
  };
  for (int k = 10; k < 16; ++k) {
    const Point a = off(k);
    const Point b = off(k + 1);
    EXPECT_GT(length(a), 1e-3);
    EXPECT_LT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0) << k;
  }
}

// One box for all errors of a report: that of what the surface shall pass through.
TEST(RequirementTangents, ErrorsAreRelativeToTheMovedPoints) {
  Requirement away = test::at_vertex(Kind::position, 0, {1e12, 0, 0});
  const auto found = interpolate_required(test::cube(), std::vector{away}, {});
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->report.solve.converged);
  EXPECT_LT(found->report.requirements[0].error, 1e-14);
}

TEST(RequirementTangents, NotesAreRightInTheSingular) {
  const std::vector<Requirement> one = {test::at_vertex(Kind::normal, 0, {0, 0, 1})};
  const std::vector<RequirementOutcome> outcomes = {{.redundant = true, .error = 1}};
  const auto notes = notes_on(one, outcomes, 1e-10);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].rfind("1 of 1 requirement was dropped, for it follows", 0), 0U) << notes[0];
  EXPECT_EQ(notes[1].rfind("1 of 1 requirement was missed", 0), 0U) << notes[1];
}

}  // namespace
}  // namespace surpass

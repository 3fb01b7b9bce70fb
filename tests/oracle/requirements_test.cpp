// Requirements on surfaces, as OpenSubdiv evaluates them.
#include "support/requirements.hpp"

#include <surpass/oracle.hpp>

#include <gtest/gtest.h>

#include "osd.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

constexpr Rules kRules = {Scheme::catmull_clark, Boundary::edge_and_corner};
constexpr std::array kForms = {Similarity::vectors, Similarity::directions, Similarity::fair};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Point& a) { return std::sqrt(dot(a, a)); }
double distance(const Point& a, const Point& b) {
  return norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

SimilarityOptions options_of(Similarity form) {
  SimilarityOptions options;
  options.similarity = form;
  return options;
}

// Positions and derivatives on quads, by their parameters; the control mesh has a face for each of
// their quarters, of which (0.5, 0.25) is in the first: its parameters there are (1, 0.5).
void expect_all_kinds(const Mesh& mesh) {
  const auto surface = LimitSurface::create(mesh, kRules).value();
  std::vector<Requirement> all;
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.face_count() && faces.size() < 10; ++f) {
    if (mesh.face(f).size() != 4) continue;
    const SurfacePlace place{f, 0.5, 0.25};
    const SurfaceSample s = surface.evaluate(place).value();
    const double d = 0.03 * static_cast<double>(1 + f % 3);
    all.push_back(test::on_face(Requirement::Kind::position, place,
                                {s.position[0] + d, s.position[1], s.position[2] - d}));
    all.push_back(test::on_face(Requirement::Kind::direction, {f, 0.2, 0.1},
                                {s.du[0] + d, s.du[1] - d, s.du[2]}, {1, 0.25}));
    all.push_back(test::on_face(Requirement::Kind::derivative, {f, 0.125, 0.375},
                                {s.dv[0], s.dv[1] + d, s.dv[2]}, {0, 1}));
    all.push_back(test::on_face(Requirement::Kind::normal, {f, 0.45, 0.05},
                                {s.normal[0] + d, s.normal[1], s.normal[2]}));
    faces.push_back(f);
  }
  ASSERT_GT(faces.size(), 5U);
  for (const Similarity form : kForms) {
    const auto found = interpolate_required(mesh, all, options_of(form));
    ASSERT_TRUE(found) << describe(found.error());
    const test::OsdSurface theirs(found->control, kRules);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index quarter = mesh.face_offsets[faces[i]];
      const auto position = theirs.evaluate({quarter, 1, 0.5}).value();
      EXPECT_LT(distance(position.position, all[4 * i].value), 1e-13);
      const auto at = theirs.evaluate({quarter, 0.4, 0.2}).value();
      const Point& wanted = all[4 * i + 1].value;
      Point v;
      for (std::size_t c = 0; c < 3; ++c) v[c] = at.du[c] + 0.25 * at.dv[c];
      const Point across = {v[1] * wanted[2] - v[2] * wanted[1],
                            v[2] * wanted[0] - v[0] * wanted[2],
                            v[0] * wanted[1] - v[1] * wanted[0]};
      EXPECT_LT(norm(across), 1e-12 * norm(v) * norm(wanted));
      EXPECT_EQ(dot(v, wanted) < 0, found->report.requirements[4 * i + 1].flipped);
      const auto derivative = theirs.evaluate({quarter, 0.25, 0.75}).value();
      Point dv;  // by the parameters of the quad
      for (std::size_t c = 0; c < 3; ++c) dv[c] = 2 * derivative.dv[c];
      EXPECT_LT(distance(dv, all[4 * i + 2].value), 1e-12);
      const auto plane = theirs.evaluate({quarter, 0.9, 0.1}).value();
      const Point& normal = all[4 * i + 3].value;
      EXPECT_LT(std::abs(dot(plane.du, normal)), 1e-12);
      EXPECT_LT(std::abs(dot(plane.dv, normal)), 1e-12);
    }
    const auto certificate = opensubdiv_limit_positions(found->control, kRules).value();
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_LT(distance(certificate[v], mesh.points[v]), 1e-12);
    }
  }
}

TEST(RequirementsAgainstOpenSubdiv, ClosedAndOpen) {
  expect_all_kinds(refine(test::tetrahedron(), kRules, 2).value());
  expect_all_kinds(test::quad_grid(5, 5));
}

TEST(RequirementsAgainstOpenSubdiv, CreasedPolygons) {
  expect_all_kinds(test::random_polygons({.seed = 6, .kind = 3, .creases = 0.1}));
}

// Normals at all vertices, irregular ones as well, judged by OpenSubdiv's limit tangents.
void expect_normals(const Mesh& mesh) {
  auto normals = limit_normals(mesh, kRules).value();
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v][v % 3] += 0.1;
  const auto all = normals_everywhere(mesh, kRules, normals).value();
  ASSERT_EQ(all.size(), mesh.points.size());
  for (const Similarity form : kForms) {
    const auto found = interpolate_required(mesh, all, options_of(form));
    ASSERT_TRUE(found) << describe(found.error());
    const auto theirs = test::osd_normals(found->control, kRules);
    for (std::size_t v = 0; v < all.size(); ++v) {
      const double cosine = dot(theirs[v], normals[v]) / norm(normals[v]);
      EXPECT_LT(std::acos(std::min(1.0, std::abs(cosine))), 1e-6) << v;
      EXPECT_EQ(cosine < 0, found->report.requirements[v].flipped);
      EXPECT_LT(found->report.requirements[v].error, 1e-14);
    }
  }
}

TEST(RequirementsAgainstOpenSubdiv, NormalsAtAllVertices) {
  expect_normals(test::random_polygons({.seed = 2, .kind = 1}));
  expect_normals(refine(test::icosahedron(), kRules, 1).value());
}

Point smooth_normal_sum(const Mesh& mesh, const Topology& topology, Index v) {
  Point sum = {};
  topology.for_each_outgoing(v, [&](Index h) {
    const Point& o = mesh.points[v];
    const Point& p = mesh.points[topology.head(h)];
    const Point& q = mesh.points[topology.tail(topology.previous(h))];
    const Point a = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    const Point b = {q[0] - o[0], q[1] - o[1], q[2] - o[2]};
    sum = {sum[0] + a[1] * b[2] - a[2] * b[1], sum[1] + a[2] * b[0] - a[0] * b[2],
           sum[2] + a[0] * b[1] - a[1] * b[0]};
  });
  return sum;
}

// The meshes' own smooth normals: sums of their faces'.
TEST(RequirementsAgainstOpenSubdiv, SpotAndBigguyKeepTheirOwnNormals) {
  int meshes = 0;
  for (const std::string& path : test::real_meshes("quad")) {
    if (path.find("spot") == std::string::npos && path.find("bigguy") == std::string::npos)
      continue;
    SCOPED_TRACE(path);
    ++meshes;
    const Mesh mesh = read_mesh(path)->mesh;
    const Topology topology = Topology::build(mesh).value();
    std::vector<Point> normals(mesh.points.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      normals[v] = smooth_normal_sum(mesh, topology, v);
    const auto all = normals_everywhere(mesh, kRules, normals).value();
    EXPECT_EQ(all.size(), mesh.points.size());
    for (const Similarity form : kForms) {
      const auto found = interpolate_required(mesh, all, options_of(form));
      ASSERT_TRUE(found) << describe(found.error());
      EXPECT_LT(found->report.solve.final.max, 1e-12);
      const auto theirs = test::osd_normals(found->control, kRules);
      int flipped = 0;
      for (std::size_t v = 0; v < all.size(); ++v) {
        EXPECT_LT(found->report.requirements[v].error, 1e-12);
        const double cosine = dot(theirs[v], normals[v]) / norm(normals[v]);
        EXPECT_LT(std::acos(std::min(1.0, std::abs(cosine))), 1e-5) << v;
        flipped += found->report.requirements[v].flipped ? 1 : 0;
      }
      EXPECT_EQ(flipped, 0);  // equations cannot tell, but lengths of the tangents can
    }
  }
  if (meshes == 0) GTEST_SKIP() << "no folder of real meshes";
  EXPECT_EQ(meshes, 2);
}

}  // namespace
}  // namespace surpass

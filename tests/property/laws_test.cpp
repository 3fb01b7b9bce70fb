// Laws that hold for every mesh, whatever the masks are.
#include <algorithm>
#include <numeric>
#include <sstream>

#include <gtest/gtest.h>

#include "generators.hpp"

namespace surpass {
namespace {

Point transformed(const Point& p) {
  return {0.3 * p[0] - 2 * p[1] + 0.1 * p[2] + 5, p[0] + p[1] - p[2] - 3, 0.7 * p[2] + 0.2 * p[0]};
}

Mesh transformed(Mesh mesh) {
  for (Point& p : mesh.points) p = transformed(p);
  return mesh;
}

std::vector<Index> shuffled_numbers(Index n, std::uint64_t seed) {
  std::vector<Index> to(n);
  std::iota(to.begin(), to.end(), Index{0});
  std::mt19937_64 random(seed);
  for (Index i = n; i > 1; --i) std::swap(to[i - 1], to[random() % i]);
  return to;
}

Mesh renumbered(const Mesh& mesh, const std::vector<Index>& to) {
  Mesh out = mesh;
  for (Index v = 0; v < mesh.vertex_count(); ++v) out.points[to[v]] = mesh.points[v];
  for (Index& v : out.face_vertices) v = to[v];
  for (Crease& c : out.creases) {
    for (Index& v : c.vertices) v = to[v];
  }
  for (Corner& c : out.corners) c.vertex = to[c.vertex];
  return out;
}

// The same faces, in another order and starting from other corners.
Mesh rotated(const Mesh& mesh, std::uint64_t seed) {
  Mesh out = mesh;
  out.face_offsets = {0};
  out.face_vertices.clear();
  std::mt19937_64 random(seed);
  for (const Index f : shuffled_numbers(mesh.face_count(), seed)) {
    std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()),
                face.end());
    out.add_face(face);
  }
  return out;
}

TEST(Laws, AffineInvariance) {
  test::check("affine", 30, [] {
    const auto [mesh, rules] = test::any_case(true);
    const auto control = interpolate(mesh, {.rules = rules, .tolerance = 1e-14});
    const auto moved = interpolate(transformed(mesh), {.rules = rules, .tolerance = 1e-14});
    RC_ASSERT(control && moved);
    const Mesh expected = transformed(control->control);
    RC_ASSERT(test::max_distance(moved->control.points, expected.points) < 1e-10);
  });
}

SimilarityOptions solved_well(Similarity similarity, const Rules& rules) {
  SimilarityOptions options;
  options.rules = rules;
  options.similarity = similarity;
  options.solver_tolerance = 1e-13;
  options.max_iterations = 20000;
  return options;
}

// The vectors and the fair form see each coordinate alone and treat all the same; without scaling
// they do not know how the coordinates lie.
TEST(Laws, SimilarityOfVectorsIsAffinelyInvariant) {
  test::check("similar affine", 20, [] {
    const auto [mesh, rules] = test::any_case(true, Scheme::catmull_clark);
    SimilarityOptions options =
        solved_well(*rc::gen::element(Similarity::vectors, Similarity::fair), rules);
    options.scaling = Scaling::none;
    const auto control = interpolate_similar(mesh, options);
    const auto moved = interpolate_similar(transformed(mesh), options);
    RC_ASSERT(control && moved);
    const Mesh expected = transformed(control->control);
    RC_ASSERT(test::max_distance(moved->control.points, expected.points) < 1e-10);
  });
}

// Directions know lengths and angles; all forms know the axes by their scaling.
TEST(Laws, SimilarityIsInvariantUnderScaleAndTranslation) {
  test::check("similar scale", 20, [] {
    const auto [mesh, rules] = test::any_case(false, Scheme::catmull_clark);
    SimilarityOptions options = solved_well(
        *rc::gen::element(Similarity::vectors, Similarity::directions, Similarity::fair), rules);
    options.row_weights = *rc::gen::element(RowWeights::none, RowWeights::regularised);
    options.scaling = *rc::gen::element(Scaling::none, Scaling::per_axis, Scaling::isotropic);
    options.solver_tolerance = 1e-2;
    const auto moved = [](Mesh m) {
      for (Point& p : m.points) p = {64 * p[0] + 32, 64 * p[1] - 16, 64 * p[2]};
      return m;
    };
    const auto control = interpolate_similar(mesh, options);
    const auto found = interpolate_similar(moved(mesh), options);
    RC_ASSERT(control && found);
    const Mesh expected = moved(control->control);
    RC_ASSERT(test::max_distance(found->control.points, expected.points) < 64 * 1e-11);
  });
}

TEST(Laws, SimilarityDoesNotSeeVertexNumbers) {
  test::check("similar permutation", 20, [] {
    const auto [mesh, rules] = test::any_case(true, Scheme::catmull_clark);
    const auto to = shuffled_numbers(mesh.vertex_count(), *rc::gen::arbitrary<std::uint64_t>());
    SimilarityOptions options =
        solved_well(*rc::gen::element(Similarity::vectors, Similarity::fair), rules);
    const auto a = interpolate_similar(mesh, options);
    const auto b = interpolate_similar(renumbered(mesh, to), options);
    RC_ASSERT(a && b);
    // Faces keep their order and their points come last.
    const auto point = [](const Mesh& m, Index from_end) {
      return m.points[m.points.size() - 1 - from_end];
    };
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      RC_ASSERT(test::max_distance({a->control.points[v]}, {b->control.points[to[v]]}) < 1e-9);
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
      RC_ASSERT(test::max_distance({point(a->control, f)}, {point(b->control, f)}) < 1e-9);
    }
  });
}

TEST(Laws, VertexNumbersDoNotMatter) {
  test::check("permutation", 30, [] {
    const auto [mesh, rules] = test::any_case(true);
    const auto to = shuffled_numbers(mesh.vertex_count(), *rc::gen::arbitrary<std::uint64_t>());
    const auto a = interpolate(mesh, {.rules = rules, .tolerance = 1e-14});
    const auto b = interpolate(renumbered(mesh, to), {.rules = rules, .tolerance = 1e-14});
    RC_ASSERT(a && b);
    std::vector<Point> back(mesh.points.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v) back[v] = b->control.points[to[v]];
    RC_ASSERT(test::max_distance(a->control.points, back) < 1e-10);
  });
}

TEST(Laws, FaceOrderAndFirstCornersDoNotMatter) {
  test::check("rotation", 30, [] {
    const auto [mesh, rules] = test::any_case(true);
    const Mesh turned = rotated(mesh, *rc::gen::arbitrary<std::uint64_t>());
    const auto a = limit_positions(mesh, rules);
    const auto b = limit_positions(turned, rules);
    RC_ASSERT(a && b);
    RC_ASSERT(test::max_distance(*a, *b) < 1e-14);
    const auto na = limit_normals(mesh, rules);
    const auto nb = limit_normals(turned, rules);
    RC_ASSERT(test::max_distance(*na, *nb) < 1e-9);
  });
}

TEST(Laws, RefinementKeepsTheLimit) {
  test::check("refine", 30, [] {
    const auto [mesh, rules] =  // Doo-Sabin surfaces have given vertices inside refined faces
        test::any_case(true, *rc::gen::element(Scheme::loop, Scheme::catmull_clark));
    const auto before = limit_positions(mesh, rules);
    const auto refined = refine(mesh, rules, *rc::gen::inRange(1, 4));
    RC_ASSERT(before && refined);
    auto after = limit_positions(*refined, rules).value();
    after.resize(mesh.points.size());
    RC_ASSERT(test::max_distance(*before, after) < 1e-13);
  });
}

// Positions of all corners, face after face.
std::vector<Point> corner_points(const Mesh& mesh) {
  std::vector<Point> points;
  for (const Index v : mesh.face_vertices) points.push_back(mesh.points[v]);
  return points;
}

TEST(Laws, LimitMeshesLeaveHoleFacesOut) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    Mesh mesh = scheme == Scheme::loop ? test::triangle_grid(5, 4) : test::quad_grid(5, 4);
    std::vector<Point> expected = corner_points(limit_mesh(mesh, {scheme}, 1).value());
    constexpr std::ptrdiff_t kHole = 7;  // whose children are the faces 28..31
    const std::ptrdiff_t size = 4 * static_cast<std::ptrdiff_t>(mesh.face(0).size());
    expected.erase(expected.begin() + kHole * size, expected.begin() + (kHole + 1) * size);
    mesh.hole_faces = {static_cast<Index>(kHole)};
    const Mesh limit = limit_mesh(mesh, {scheme}, 1).value();
    EXPECT_EQ(corner_points(limit), expected);
    EXPECT_TRUE(limit.hole_faces.empty());
    const auto limits = limit_positions(mesh, {scheme}).value();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LT(test::max_distance({limit.points[v]}, {limits[v]}), 1e-14);
    }
  }
}

TEST(Laws, MirrorImagesHaveMirroredNormals) {
  test::check("mirror", 20, [] {
    const auto [mesh, rules] = test::any_case(true);
    Mesh mirrored = mesh;
    for (Point& p : mirrored.points) p[0] = -p[0];
    for (Index f = 0; f < mesh.face_count(); ++f) {
      std::reverse(mirrored.face_vertices.begin() + mesh.face_offsets[f],
                   mirrored.face_vertices.begin() + mesh.face_offsets[f + 1]);
    }
    auto expected = limit_normals(mesh, rules).value();
    for (Point& n : expected) n[0] = -n[0];
    RC_ASSERT(test::max_distance(limit_normals(mirrored, rules).value(), expected) < 1e-9);
  });
}

}  // namespace
}  // namespace surpass

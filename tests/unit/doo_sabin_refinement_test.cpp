// Doo-Sabin refined meshes: soundness, creases, inherited attributes.
#include "doo_sabin_samples.hpp"

namespace surpass::test {
namespace {

// Vertices less edges plus faces; a bow-tie stays one vertex.
long euler(const Topology& t) {
  return static_cast<long>(t.vertex_count()) - static_cast<long>(t.edge_count()) +
         static_cast<long>(t.face_count());
}

Index isolated(const Topology& t) {
  Index n = 0;
  for (Index v = 0; v < t.vertex_count(); ++v) n += t.is_isolated(v) ? 1U : 0U;
  return n;
}

TEST(DooSabinRefinement, KeepsTheSurfaceSound) {
  for_every_sample([](const Sample& sample, const Rules& rules) {
    const auto given = Topology::build(sample.mesh).value();
    for (int levels = 1; levels <= 3; ++levels) {
      const auto refined = refine(sample.mesh, rules, levels);
      ASSERT_TRUE(refined) << describe(refined.error());
      const auto topology = Topology::build(*refined);
      ASSERT_TRUE(topology) << describe(topology.error());
      EXPECT_EQ(euler(*topology), euler(given));
      EXPECT_EQ(topology->boundary_edge_count() == 0, given.boundary_edge_count() == 0);
      EXPECT_EQ(boundary_loops(*topology).size(), boundary_loops(given).size());
      EXPECT_EQ(isolated(*topology), isolated(given));
    }
  });
}

TEST(DooSabinRefinement, NumbersItsFirstStepAsDocumented) {
  const Mesh refined = refine(cube(), {.scheme = Scheme::doo_sabin}, 1).value();
  EXPECT_EQ(refined.vertex_count(), 24U);
  EXPECT_EQ(refined.face_count(), 6U + 12U + 8U);
  for (Index f = 0; f < 6; ++f) {
    for (Index i = 0; i < 4; ++i) EXPECT_EQ(refined.face(f)[i], 4 * f + i);
  }
}

TEST(DooSabinRefinement, KeepsAFullySharpCubeFlat) {
  Mesh mesh = cube();
  const auto topology = Topology::build(mesh).value();
  for (Index e = 0; e < topology.edge_count(); ++e) {
    mesh.creases.push_back({topology.edge_vertices(e), kInfinitelySharp});
  }
  for (Index v = 0; v < 8; ++v) mesh.corners.push_back({v, kInfinitelySharp});
  const Rules rules{.scheme = Scheme::doo_sabin};
  EXPECT_EQ(limit_positions(mesh, rules).value(), mesh.points);
  for (int levels = 0; levels <= 4; ++levels) {
    for (const Mesh& m :
         {refine(mesh, rules, levels).value(), limit_mesh(mesh, rules, levels).value()}) {
      for (const Point& p : m.points) {
        EXPECT_NEAR(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}), 1, 1e-15);
      }
    }
  }
}

// B-spline of degree 2 with the corners b, c, d, at t in [0, 1] of the piece of c.
Point quadratic_spline(const Point& b, const Point& c, const Point& d, double t) {
  Point p = {};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = (1 - t) * (1 - t) / 2 * b[i] + (0.5 + t - t * t) * c[i] + t * t / 2 * d[i];
  }
  return p;
}

Mesh cube_with_sharp_top() {
  Mesh mesh = cube();
  mesh.points[5][2] = 1.5;
  mesh.points[6] = {-1.3, 0.8, 0.7};
  for (const auto& edge : {std::array<Index, 2>{4, 5}, {5, 7}, {7, 6}, {6, 4}}) {
    mesh.creases.push_back({edge, kInfinitelySharp});
  }
  return mesh;
}

TEST(DooSabinRefinement, MakesCreasesQuadraticSplines) {
  const Mesh mesh = cube_with_sharp_top();
  const Index ring[4] = {4, 5, 7, 6};
  const int levels = 4;
  const Mesh refined = refine(mesh, {.scheme = Scheme::doo_sabin}, levels).value();
  ASSERT_EQ(refined.creases.size(), 4U << levels);
  for (const Crease& crease : refined.creases) {
    const Point middle =
        mean({refined.points[crease.vertices[0]], refined.points[crease.vertices[1]]});
    double nearest = 1;
    for (std::size_t i = 0; i < 4; ++i) {
      for (int k = 0; k < 1 << levels; ++k) {
        const Point on_curve = quadratic_spline(
            mesh.points[ring[i]], mesh.points[ring[(i + 1) % 4]], mesh.points[ring[(i + 2) % 4]],
            static_cast<double>(k) / (1 << levels));
        nearest = std::min(nearest, distance(middle, on_curve));
      }
    }
    EXPECT_LT(nearest, 1e-14);
  }
}

TEST(DooSabinRefinement, BendsTheSurfaceAtCreasesOnly) {
  const Mesh refined = refine(cube_with_sharp_top(), {.scheme = Scheme::doo_sabin}, 5).value();
  const auto topology = Topology::build(refined).value();
  std::vector<char> sharp(topology.edge_count(), 0);
  for (const Crease& c : refined.creases) {
    sharp[topology.find_edge(c.vertices[0], c.vertices[1])] = 1;
  }
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const Index h = topology.edge_halfedge(e);
    const double cosine = dot(face_normal(refined, topology.face(h)),
                              face_normal(refined, topology.face(topology.opposite(h))));
    if (sharp[e] != 0) {
      EXPECT_LT(cosine, 0.9);
    } else {
      EXPECT_GT(cosine, 0.9);
    }
  }
}

Mesh flat_grid() {
  Mesh mesh = quad_grid(4, 3);
  for (Point& p : mesh.points) p[2] = 0;
  return mesh;
}

CornerChannel plane_coordinates(const Mesh& mesh) {
  CornerChannel texture{"texture", 2, {}, mesh.face_vertices};
  for (const Point& p : mesh.points) texture.values.insert(texture.values.end(), {p[0], p[1]});
  return texture;
}

TEST(DooSabinRefinement, RefinesContinuousCornerChannelsLikePositions) {
  for (const Rules& rules : doo_sabin_rules()) {
    Mesh mesh = flat_grid();
    mesh.corners.push_back({5, kInfinitelySharp});
    mesh.creases.push_back({{5, 6}, kInfinitelySharp});
    mesh.corner_channels.push_back(plane_coordinates(mesh));
    const Mesh refined = refine(mesh, rules, 3).value();
    const CornerChannel& texture = refined.corner_channels.at(0);
    ASSERT_EQ(texture.indices.size(), refined.face_vertices.size());
    for (Index c = 0; c < refined.corner_count(); ++c) {
      const Index row = texture.indices[c];
      ASSERT_NE(row, kNone);
      EXPECT_NEAR(texture.values[2 * row], refined.points[refined.face_vertices[c]][0], 1e-14);
      EXPECT_NEAR(texture.values[2 * row + 1], refined.points[refined.face_vertices[c]][1], 1e-14);
    }
  }
}

TEST(DooSabinRefinement, HasNoCornerValuesAcrossSeams) {
  Mesh mesh = flat_grid();
  CornerChannel texture{"texture", 1, {}, {}};
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    texture.values.push_back(c);
    texture.indices.push_back(c);
  }
  mesh.corner_channels.push_back(texture);
  const Mesh refined = refine(mesh, {.scheme = Scheme::doo_sabin}, 1).value();
  const auto topology = Topology::build(mesh).value();
  const auto& indices = refined.corner_channels.at(0).indices;
  const Index edges = topology.edge_count() - topology.boundary_edge_count();
  Index without = 0;
  for (Index f = 0; f < refined.face_count(); ++f) {
    const auto begin = indices.begin() + refined.face_offsets[f];
    const auto end = indices.begin() + refined.face_offsets[f + 1];
    const auto none = std::count(begin, end, kNone);
    EXPECT_TRUE(none == 0 || none == end - begin);
    if (none > 0) ++without;
    EXPECT_TRUE(none == 0 || f >= mesh.face_count());
  }
  // Every inner edge and every vertex of more than one face; the four outer vertices have one.
  EXPECT_EQ(without, edges + mesh.vertex_count() - 4);
}

TEST(DooSabinRefinement, InheritsFaceSetsHolesAndFaceChannels) {
  Mesh mesh = quad_grid(4, 2);  // three quads in a row
  mesh.face_sets.push_back({FaceSet::Kind::group, "left", {0, 1}});
  mesh.hole_faces = {2};
  mesh.face_channels.push_back({"label", {"x"}, {7, 8, 9}, Storage::float64});
  const Mesh refined = refine(mesh, {.scheme = Scheme::doo_sabin}, 1).value();
  const auto topology = Topology::build(mesh).value();
  ASSERT_EQ(refined.face_sets.size(), 1U);
  std::vector<Index> expected_set = {0, 1};
  std::vector<Index> expected_holes = {2};
  Index f = mesh.face_count();
  for (Index e = 0; e < topology.edge_count(); ++e, ++f) {
    const Index h = topology.edge_halfedge(e);
    const Index g = topology.opposite(h);
    const Index a = topology.face(h);
    const Index b = g == kNone ? a : topology.face(g);
    if (a < 2 && b < 2) expected_set.push_back(f);
    if (a == 2 && b == 2) expected_holes.push_back(f);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v, ++f) {
    const Index x = v % 4;
    if (x <= 1) expected_set.push_back(f);
    if (x == 3) expected_holes.push_back(f);
  }
  EXPECT_EQ(f, refined.face_count());
  EXPECT_EQ(refined.face_sets[0].faces, expected_set);
  EXPECT_EQ(refined.hole_faces, expected_holes);
  ASSERT_EQ(refined.face_channels.at(0).values.size(), refined.face_count());
  EXPECT_EQ(refined.face_channels[0].values[1], 8);
}

TEST(DooSabinRefinement, CarriesVertexChannelsLikePositions) {
  Mesh mesh = random_polygons({.seed = 12, .kind = 3, .creases = 0.1});
  const auto values = flat(std::span<const Point>(mesh.points));
  mesh.channels.push_back({"copy", {"x", "y", "z"}, {values.begin(), values.end()}});
  const Rules rules{.scheme = Scheme::doo_sabin};
  for (const Mesh& m : {refine(mesh, rules, 2).value(), limit_mesh(mesh, rules, 2).value()}) {
    const auto points = flat(std::span<const Point>(m.points));
    EXPECT_EQ(m.channels.at(0).values, std::vector<double>(points.begin(), points.end()));
  }
}

}  // namespace
}  // namespace surpass::test

// Everything that hangs on a mesh follows through every operation.
#include <surpass/repair.hpp>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

// A cube whose every element carries its own number.
Mesh labelled_cube() {
  Mesh mesh = samples::cube();
  mesh.channels = {{"number", {"n", "square"}, {}, Storage::int32}};
  for (Index v = 0; v < 8; ++v) {
    mesh.channels[0].values.insert(mesh.channels[0].values.end(), {double(v), double(v * v)});
  }
  mesh.face_channels = {{"label", {"n"}, {10, 11, 12, 13, 14, 15}, Storage::uint8}};
  mesh.corner_channels = {{"texture", 2, {}, {}}};
  for (Index c = 0; c < 24; ++c) {
    mesh.corner_channels[0].values.insert(mesh.corner_channels[0].values.end(),
                                          {c + 0.25, c + 0.5});
    mesh.corner_channels[0].indices.push_back(c);
  }
  mesh.corner_channels[0].indices[5] = kNone;
  mesh.face_sets = {{FaceSet::Kind::group, "sides", {2, 3, 4, 5}},
                    {FaceSet::Kind::material, "red", {0, 4}}};
  mesh.hole_faces = {1, 4};
  mesh.creases = {{{0, 1}, 3.0F}, {{6, 7}, 10.0F}};
  mesh.corners = {{7, 2.0F}};
  mesh.material_libraries = {"a.mtl"};
  mesh.tags = {"interpolateboundary 1/0/0 1"};
  mesh.annotate("scheme", "loop");
  return mesh;
}

void expect_same_extras(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.material_libraries, b.material_libraries);
  EXPECT_EQ(a.tags, b.tags);
  EXPECT_EQ(a.annotations, b.annotations);
}

TEST(Follow, FacesThatAreDroppedOrTurned) {
  Mesh given = labelled_cube();
  // Face 0 is degenerate, face 3 is inside out.
  for (Index c = 0; c < 4; ++c) given.face_vertices[c] = 0;
  std::swap(given.face_vertices[13], given.face_vertices[15]);
  const Mesh mesh = repair(given).mesh;
  ASSERT_EQ(mesh.face_count(), 5U);
  EXPECT_EQ(mesh.face_channels[0].values, (std::vector<double>{11, 12, 13, 14, 15}));
  EXPECT_EQ(mesh.face_channels[0].storage, Storage::uint8);
  EXPECT_EQ(mesh.face_sets[0].faces, (Face{1, 2, 3, 4}));
  EXPECT_EQ(mesh.face_sets[1].faces, (Face{3}));
  EXPECT_EQ(mesh.hole_faces, (Face{0, 3}));
  EXPECT_EQ(mesh.corner_channels[0].indices,
            (Face{4, kNone, 6, 7, 8, 9, 10, 11, 12, 15, 14, 13, 16, 17, 18, 19, 20, 21, 22, 23}));
  EXPECT_EQ(mesh.channels, given.channels);
  EXPECT_EQ(mesh.creases, given.creases);
  EXPECT_EQ(mesh.corners, given.corners);
  expect_same_extras(mesh, given);
}

TEST(Follow, VerticesThatAreMerged) {
  Mesh given = labelled_cube();
  given.points[6] = given.points[2];
  const Mesh mesh = weld(given, 0)->mesh;
  ASSERT_EQ(mesh.points.size(), 7U);
  EXPECT_EQ(mesh.channels[0].values,
            (std::vector<double>{0, 0, 1, 1, 2, 4, 3, 9, 4, 16, 5, 25, 7, 49}));
  EXPECT_EQ(mesh.creases, (std::vector<Crease>{{{0, 1}, 3.0F}, {{2, 6}, 10.0F}}));
  EXPECT_EQ(mesh.corners, (std::vector<Corner>{{6, 2.0F}}));
  EXPECT_EQ(mesh.corner_channels, given.corner_channels);
  EXPECT_EQ(mesh.face_sets, given.face_sets);
  expect_same_extras(mesh, given);
}

TEST(Follow, FacesThatAreCut) {
  const Mesh given = labelled_cube();
  const Mesh mesh = triangulate(given).mesh;
  ASSERT_EQ(mesh.face_count(), 12U);
  EXPECT_EQ(mesh.face_channels[0].values,
            (std::vector<double>{10, 10, 11, 11, 12, 12, 13, 13, 14, 14, 15, 15}));
  EXPECT_EQ(mesh.face_sets[1].faces, (Face{0, 1, 8, 9}));
  EXPECT_EQ(mesh.hole_faces, (Face{2, 3, 8, 9}));
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    const Index row = mesh.corner_channels[0].indices[c];
    const Index old = row == kNone ? 5 : row;
    EXPECT_EQ(given.face_vertices[old], mesh.face_vertices[c]);
  }
  EXPECT_EQ(mesh.creases, given.creases);
  EXPECT_EQ(mesh.points, given.points);
  expect_same_extras(mesh, given);
}

TEST(Follow, VerticesThatAreDropped) {
  Mesh given = labelled_cube();
  given.points.insert(given.points.begin(), {9, 9, 9});
  given.channels[0].values.insert(given.channels[0].values.begin(), {-1, -1});
  for (Index& v : given.face_vertices) ++v;
  for (Crease& c : given.creases) c.vertices = {c.vertices[0] + 1, c.vertices[1] + 1};
  ++given.corners[0].vertex;
  given.corners.push_back({0, 1.0F});
  const Mended mended = drop_isolated_vertices(given);
  EXPECT_EQ(mended.mesh, labelled_cube());
  EXPECT_EQ(mended.done, (std::vector<std::string>{"dropped 1 vertex that no face uses"}));
  EXPECT_EQ(drop_isolated_vertices(labelled_cube()).mesh, labelled_cube());
}

}  // namespace
}  // namespace surpass

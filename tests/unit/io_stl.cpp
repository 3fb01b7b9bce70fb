#include "unit/io_support.hpp"

namespace surpass {
namespace {

constexpr const char* kTwoSolids =
    "SOLID one part\nfacet normal 0 0 nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nENDSOLID one part\nsolid\n facet normal 0 0 1 outer loop vertex 1 0 0\n"
    "vertex 1 1 0 vertex -0 1 0 endloop endfacet\nendsolid";

Mesh square() {
  Mesh mesh = unit_triangle();
  mesh.points.push_back({1, 1, 0});
  mesh.add_face(std::array<Index, 3>{1, 3, 2});
  return mesh;
}

TEST(Stl, WeldsInOrderOfFirstOccurrence) {
  Mesh expected = square();
  expected.face_sets = {{FaceSet::Kind::object, "one part", {0}}};
  EXPECT_EQ(parsed(kTwoSolids, Format::stl).mesh, expected);
}

TEST(Stl, BinaryThatBeginsWithSolidIsBinary) {
  std::string bytes = formatted(square(), {.format = Format::stl});
  EXPECT_EQ(bytes.size(), 84U + 2 * 50U);
  bytes.replace(0, 12, "solid a part");
  EXPECT_EQ(parsed(bytes, Format::automatic).mesh, square());
}

TEST(Stl, BinaryHoldsUnitNormalsAndFloats) {
  const std::string bytes = formatted(square(), {.format = Format::stl});
  const std::string up("\0\0\0\0\0\0\0\0\0\0\x80\x3f", 12);  // 0, 0, 1 in little-endian floats
  EXPECT_EQ(bytes.substr(84, 12), up);
}

TEST(Stl, AttributeBytesAreMentioned) {
  std::string bytes = formatted(square(), {.format = Format::stl});
  bytes[84 + 48] = 1;
  EXPECT_EQ(parsed(bytes, Format::stl).notices.size(), 1U);
}

TEST(Stl, TextKeepsObjectsAsSolids) {
  Mesh mesh = square();
  mesh.face_sets = {{FaceSet::Kind::object, "a b", {0}}, {FaceSet::Kind::object, "c", {1}}};
  EXPECT_EQ(written_and_read(mesh, {.format = Format::stl, .encoding = Encoding::ascii}), mesh);
}

TEST(Stl, PolygonsAreRefusedWithTheWayOut) {
  Mesh mesh = unit_triangle();
  mesh.points.push_back({1, 1, 0});
  mesh.add_face(std::array<Index, 4>{0, 1, 3, 2});
  std::string bytes;
  const auto result = format_mesh(mesh, {.format = Format::stl}, bytes);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::unsuitable_for_scheme);
  EXPECT_EQ(describe(result.error()),
            "STL holds triangles only, and this face has 4 corners; write triangles, or "
            "another format (face 1, counted from 0)");
  EXPECT_TRUE(bytes.empty());
}

TEST(Stl, PositionsBeyondFloatsAreRefused) {
  Mesh mesh = unit_triangle();
  mesh.points[2][1] = 1e300;
  std::string bytes;
  const auto result = format_mesh(mesh, {.format = Format::stl}, bytes);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place.vertex, 2U);
}

TEST(Stl, SaysWhatItCannotHold) {
  Mesh mesh = unit_triangle();
  mesh.points.push_back({5, 5, 5});
  mesh.channels = {{"a", {"a"}, {1, 2, 3, 4}}};
  mesh.face_sets = {{FaceSet::Kind::group, "g", {0}}};
  std::vector<std::string> notes;
  (void)formatted(mesh, {.format = Format::stl}, &notes);
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "STL has no place for groups, objects and materials; 1 left out",
                       "STL has no place for the channel 'a'; it is left out",
                       "STL holds no vertices without faces; 1 left out"}));
}

}  // namespace
}  // namespace surpass

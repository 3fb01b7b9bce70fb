#include <cmath>

#include <fmt/format.h>

#include "unit/io_support.hpp"

namespace surpass {
namespace {

Mesh read_obj(std::string_view text) { return parsed(text, Format::obj).mesh; }

using Indices = std::vector<Index>;

TEST(Obj, ReadsPositionsOfEveryNumberForm) {
  const Mesh mesh = read_obj("v 1 2. .5\nv +1e2 -3E-1 0\nv\t-0\t1e-310 0.1\nf 1 2 3\n");
  const std::vector<Point> expected = {{1, 2, 0.5}, {100, -0.3, 0}, {-0.0, 1e-310, 0.1}};
  EXPECT_EQ(mesh.points, expected);
  EXPECT_TRUE(std::signbit(mesh.points[2][0]));
}

TEST(Obj, LineEndsCommentsAndContinuationsDoNotMatter) {
  const Mesh plain = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
        "# c\nv 0 0 0 # here\n\n  v\t1 0 0 \nv 0 1 0\nf 1 2 3 # end",
        "v 0 \\\n0 0\nv 1 0 0\nv 0 1 \\\r\n0\nf 1 \\\n 2 \\\n3",
        "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}) {
    EXPECT_EQ(read_obj(text), plain) << text;
  }
}

TEST(Obj, NegativeNumbersCountBackwardsAndForwardReferencesAreLegal) {
  const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf 4 1 2\nv 0 0 1\n");
  EXPECT_EQ(mesh.face_vertices, (Indices{0, 1, 2, 3, 0, 1}));
}

TEST(Obj, NumbersOfVerticesHaveAnyCountOfDigits) {
  constexpr Index kCount = 1234567;
  std::string text;
  for (Index v = 0; v < kCount; ++v) text += "v 0 0 0\n";
  const Indices expected = {0, 11, 122, 1233, 12344, 123455, 1234566, 6, 77, 8, 0, 9};
  text += "f 1 12 123 1234 12345 123456 1234567\nf 007/ 00000078// 000000000000000009 ";
  EXPECT_EQ(read_obj(text + "1 10").face_vertices, expected);
  EXPECT_EQ(read_obj(text + "1 10\t# end of the file\n").face_vertices, expected);
  for (const char* wrong : {"1x", "1\xB9", "12345678901", "18446744073709551617", "\x01"}) {
    EXPECT_FALSE(parse_mesh(text + wrong, Format::obj, "test")) << wrong;
  }
}

TEST(Obj, CornersKeepTextureAndNormalNumbers) {
  const Mesh mesh = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0.5\nvt 1 0\nvn 0 0 1\n"
      "f 1 2 3\nf 1/1/1 2/2/1 3/-1/-1\nf 2//1 4//1 3//1\nf 1/2 2/1 4/\n");
  ASSERT_EQ(mesh.corner_channels.size(), 2U);
  const CornerChannel& texture = mesh.corner_channels[0];
  EXPECT_EQ(texture.name, "texture");
  EXPECT_EQ(texture.values, (std::vector<double>{0, 0.5, 1, 0}));
  EXPECT_EQ(texture.indices,
            (Indices{kNone, kNone, kNone, 0, 1, 1, kNone, kNone, kNone, 1, 0, kNone}));
  const CornerChannel& normal = mesh.corner_channels[1];
  EXPECT_EQ(normal.indices, (Indices{kNone, kNone, kNone, 0, 0, 0, 0, 0, 0, kNone, kNone, kNone}));
}

TEST(Obj, TextureRowsWidenToTheWidest) {
  const Mesh mesh =
      read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1\nvt 2 3\nvt 4 5 6\nvt 7\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(mesh.corner_channels.at(0).width, 3U);
  EXPECT_EQ(mesh.corner_channels.at(0).values,
            (std::vector<double>{1, 0, 0, 2, 3, 0, 4, 5, 6, 7, 0, 0}));
}

TEST(Obj, ReferencesToNormalsThatTheFileLacksAreLeftOutWithANotice) {
  const LoadedMesh loaded = parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n", Format::obj);
  EXPECT_TRUE(loaded.mesh.corner_channels.empty());
  EXPECT_EQ(loaded.notices,
            (std::vector<std::string>{
                "faces name normals, but the file has none; the normals are left out"}));
}

TEST(Obj, PolygonsOfAnySize) {
  std::string text;
  std::string face = "f";
  for (int k = 1; k <= 1000; ++k) {
    text += fmt::format("v {} 0 0\n", k);
    face += fmt::format(" {}", k);
  }
  const Mesh mesh = read_obj(text + face + "\nf 1 2\nf 7\n");
  EXPECT_EQ(mesh.face_offsets, (Indices{0, 1000, 1002, 1003}));
  EXPECT_EQ(mesh.face_vertices[999], 999U);
}

TEST(Obj, ColoursNeedEveryVertex) {
  const Mesh mesh = read_obj("v 0 0 0 0.5 0.25 1\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  const Channel expected = {"color", {"red", "green", "blue"}, {0.5, 0.25, 1, 0, 1, 0, 0, 0, 0}};
  EXPECT_EQ(mesh.channels, std::vector{expected});
  const LoadedMesh partly = parsed("v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0 2\nf 1 2 3\n", Format::obj);
  EXPECT_TRUE(partly.mesh.channels.empty());
  EXPECT_EQ(partly.notices.at(0), "1 of 3 vertices have a colour; these colours are left out");
  EXPECT_EQ(partly.notices.at(1),
            "1 vertex has a weight other than 1; positions are kept as they stand");
}

TEST(Obj, GroupsObjectsMaterialsAndSmoothing) {
  const Mesh mesh = read_obj(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\no some thing\ng a b\nusemtl red\ns 1\nf 1 2 3\n"
      "g b\ns off\nf 1 2 3\ng\nusemtl blue # c\nf 1 2 3\ng a\nf 1 2 3\n");
  using Kind = FaceSet::Kind;
  const std::vector<FaceSet> expected = {{Kind::group, "a", {0, 3}},
                                         {Kind::group, "b", {0, 1}},
                                         {Kind::object, "some thing", {0, 1, 2, 3}},
                                         {Kind::material, "red", {0, 1}},
                                         {Kind::material, "blue", {2, 3}},
                                         {Kind::smoothing, "1", {0}}};
  EXPECT_EQ(mesh.face_sets, expected);
  EXPECT_EQ(mesh.material_libraries, std::vector<std::string>{"a.mtl"});
  EXPECT_EQ(written_and_read(mesh, {.format = Format::obj}), mesh);
}

TEST(Obj, ReadsOpenSubdivTags) {
  const LoadedMesh loaded = parsed(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n"
      "t crease 2/1/0 0 1 2.5\nt crease 4/2/0 0 2 1 2 1 10\nt corner 1/1/0 3 4\n"
      "t corner 2/1/0 0 1 0.1\nt hole 2/0/0 1 0\nt interpolateboundary 1/0/0 2\n"
      "t creasemethod 0/0/1 chaikin\n",
      Format::obj);
  const Mesh& mesh = loaded.mesh;
  EXPECT_EQ(mesh.creases, (std::vector<Crease>{{{0, 1}, 2.5F}, {{0, 2}, 1}, {{1, 2}, 10}}));
  EXPECT_EQ(mesh.corners, (std::vector<Corner>{{3, 4}, {0, 0.1F}, {1, 0.1F}}));
  EXPECT_EQ(mesh.hole_faces, (Indices{0, 1}));
  EXPECT_EQ(mesh.tags, (std::vector<std::string>{"t interpolateboundary 1/0/0 2",
                                                 "t creasemethod 0/0/1 chaikin"}));
  EXPECT_EQ(loaded.notices,
            (std::vector<std::string>{"the crease method 'chaikin' is treated as uniform"}));
  EXPECT_EQ(written_and_read(mesh, {.format = Format::obj}), mesh);
}

TEST(Obj, SkipsOtherStatementsWithOneNoticeEach) {
  const LoadedMesh loaded =
      parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\np 1\ncurv 0 1 \\\n f 9 9 9\nf 1 2 3\n",
             Format::obj);
  EXPECT_EQ(loaded.mesh.face_count(), 1U);
  EXPECT_EQ(loaded.notices,
            (std::vector<std::string>{"2 'l' statements skipped; only faces are read",
                                      "1 'p' statement skipped; only faces are read",
                                      "1 'curv' statement skipped; only faces are read"}));
}

TEST(Obj, AnnotationsAreACommentInAllTextFormats) {
  Mesh mesh = unit_triangle();
  mesh.annotate("scheme", "loop");
  mesh.annotate("boundary", "edge-and-corner");
  EXPECT_EQ(formatted(mesh, {.format = Format::obj, .comments = {"a\nb"}}),
            "# surpass scheme=loop boundary=edge-and-corner\n# a b\n"
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const Format format : {Format::obj, Format::ply, Format::off, Format::stl}) {
    EXPECT_EQ(written_and_read(mesh, {.format = format}), mesh) << name_of(format);
  }
  EXPECT_EQ(written_and_read(mesh, {.format = Format::stl, .encoding = Encoding::ascii}), mesh);
  EXPECT_TRUE(read_obj("# surpass is a program\nv 0 0 0\n").annotations.empty());
}

TEST(Obj, VertexNormalsAndTextureAreWrittenAsRowsPerVertex) {
  Mesh mesh = unit_triangle();
  mesh.channels = {{"normal", {"nx", "ny", "nz"}, {0, 0, 1, 0, 0, 1, 0, 1, 0}},
                   {"texture", {"s", "t"}, {0, 0, 1, 0, 0, 1}},
                   {"weight", {"weight"}, {1, 2, 3}}};
  std::vector<std::string> notes;
  EXPECT_EQ(formatted(mesh, {.format = Format::obj}, &notes),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 1 0\n"
            "f 1/1/1 2/2/2 3/3/3\n");
  EXPECT_EQ(
      notes,
      (std::vector<std::string>{"OBJ has no place for the channel 'weight'; it is left out"}));
}

TEST(Obj, NormalsOfPointsWithoutFacesComeBack) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.channels = {{"color", {"red", "green", "blue"}, {0, 0.5, 1, 1, 0, 0, 0.25, 0, 0}},
                   {"normal", {"nx", "ny", "nz"}, {0, 0, 1, 0, 0.6, 0.8, -1, 0, 0}}};
  EXPECT_EQ(written_and_read(mesh, {.format = Format::obj}), mesh);
  const auto points = parse_points(formatted(mesh, {.format = Format::obj}), Format::obj, "test");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->mesh, mesh);
  const LoadedMesh fewer = parsed("v 0 0 0\nv 1 0 0\nvn 0 0 1\n", Format::obj);
  EXPECT_TRUE(fewer.mesh.channels.empty());
  EXPECT_EQ(fewer.notices,
            std::vector<std::string>{
                "there are no faces to name normals, and their count (1) is not that of the "
                "vertices (2): they belong to none"});
  const Mesh face = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1 2 3\n");
  EXPECT_TRUE(face.channels.empty());
}

TEST(Obj, WritesTheShortestDigitsThatReadBack) {
  Mesh mesh = unit_triangle();
  mesh.points = {{0.1, 1e300, -5e-324}, {1.0 / 3, 1e5, 123456789}, {-0.0, 2.5, 1e-7}};
  const std::string text = formatted(mesh, {.format = Format::obj});
  EXPECT_NE(
      text.find("v 0.1 1e+300 -5e-324\nv 0.3333333333333333 100000 123456789\nv -0 2.5 1e-07"),
      text.npos)
      << text;
}

}  // namespace
}  // namespace surpass

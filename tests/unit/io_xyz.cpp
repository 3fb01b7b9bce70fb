// XYZ: columns, counts, numbers that are none, and the way back.
#include <cmath>

#include "io_support.hpp"

namespace surpass {
namespace {

Error refusal(std::string_view text) {
  const auto result = parse_points(text, Format::xyz, "test");
  EXPECT_FALSE(result);
  return result ? Error{} : result.error();
}

TEST(Xyz, PositionsCommentsAndBlankLines) {
  const Mesh mesh = parsed("# a head\n1 2 3\n\n  -4e0\t5 +6  # a point\r\n7 8 9", Format::xyz).mesh;
  EXPECT_EQ(mesh.points, (std::vector<Point>{{1, 2, 3}, {-4, 5, 6}, {7, 8, 9}}));
  EXPECT_TRUE(mesh.channels.empty());
  EXPECT_EQ(mesh.face_count(), 0U);
}

TEST(Xyz, ColumnsAreNormalsOrColours) {
  const Mesh normals = parsed("0 0 0 0 0 1\n1 0 0 0 1 0\n", Format::xyz).mesh;
  ASSERT_EQ(normals.channels.size(), 1U);
  EXPECT_EQ(normals.channels[0].name, "normal");
  EXPECT_EQ(normals.channels[0].values, (std::vector<double>{0, 0, 1, 0, 1, 0}));
  const Mesh colours = parsed("0 0 0 255 0 1\n1 0 0 9 1 0\n", Format::xyz).mesh;
  ASSERT_EQ(colours.channels.size(), 1U);
  EXPECT_EQ(colours.channels[0].name, "color");
  EXPECT_EQ(colours.channels[0].storage, Storage::uint8);
  const Mesh all = parsed("0 0 0 0.5 200 0 1 0 0 1\n", Format::xyz).mesh;
  ASSERT_EQ(all.channels.size(), 3U);
  EXPECT_EQ(all.channels[0].name, "intensity");
  EXPECT_EQ(all.channels[1].name, "color");
  EXPECT_EQ(all.channels[2].name, "normal");
  const Mesh odd = parsed("0 0 0 7 8\n", Format::xyz).mesh;
  ASSERT_EQ(odd.channels.size(), 2U);
  EXPECT_EQ(odd.channels[1].name, "column5");
  EXPECT_EQ(odd.channels[1].values, std::vector<double>{8});
}

TEST(Xyz, AFirstLineMayAnnounceTheCount) {
  EXPECT_EQ(parsed("2\n0 0 0\n1 1 1\n", Format::xyz).mesh.points.size(), 2U);
  EXPECT_EQ(refusal("3\n0 0 0\n1 1 1\n").code, ErrorCode::unexpected_end);
}

TEST(Xyz, RefusalsNameTheLine) {
  EXPECT_EQ(refusal("0 0 0\n1 0\n").place.line, 2U);
  EXPECT_EQ(refusal("0 0 0\n1 0\n").code, ErrorCode::syntax);
  EXPECT_EQ(refusal("0 0 0\n1 0 0 5\n").place.line, 2U);
  EXPECT_EQ(refusal("x,y,z\n0,0,0\n").code, ErrorCode::bad_number);
  EXPECT_EQ(refusal("0 0 0\n1 0 zero\n").place.column, 5U);
}

TEST(Xyz, NumbersThatAreNoneAreForPointsOnly) {
  constexpr std::string_view kText = "0 0 0\nnan 1 -inf\n";
  const auto points = parse_points(kText, Format::xyz, "test");
  ASSERT_TRUE(points);
  EXPECT_TRUE(std::isnan(points->mesh.points[1][0]));
  EXPECT_TRUE(std::isinf(points->mesh.points[1][2]));
  EXPECT_EQ(parse_mesh(kText, Format::xyz, "test").error().code, ErrorCode::not_finite);
}

TEST(Points, OfEveryFormatMayBeNotFinite) {
  const char* files[] = {
      "v 0 0 0\nv nan 0 0\n", "OFF\n2 0 0\n0 0 0\nnan 0 0\n",
      ("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
       "property float z\nend_header\n0 0 0\nnan 0 0\n")};
  for (const char* text : files) {
    const auto points = parse_points(text, Format::automatic, "test");
    ASSERT_TRUE(points) << text;
    EXPECT_EQ(points->mesh.points.size(), 2U);
    EXPECT_TRUE(std::isnan(points->mesh.points[1][0]));
  }
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float "
      "y\nproperty float z\nend_header\n";
  binary.append("\0\0\xC0\x7F\0\0\x80\x3F\0\0\0\0", 12);
  const auto points = parse_points(binary, Format::ply, "test");
  ASSERT_TRUE(points) << describe(points.error());
  EXPECT_TRUE(std::isnan(points->mesh.points[0][0]));
  EXPECT_EQ(points->mesh.points[0][1], 1);
}

TEST(Points, LeaveFacesOut) {
  const auto points = parse_points("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Format::obj, "test");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->mesh.face_count(), 0U);
  ASSERT_EQ(points->notices.size(), 1U);
  EXPECT_NE(points->notices[0].find("1 face is left out"), std::string::npos);
}

TEST(Xyz, ComesBackBitForBit) {
  Mesh mesh;
  mesh.points = {{0.1, -1e-310, 1e300}, {1.0 / 3, 2, -0.0}};
  mesh.channels = {{"normal", {"nx", "ny", "nz"}, {0, 0.6, 0.8, 1, 0, 0}},
                   {"color", {"red", "green", "blue"}, {255, 0, 7, 1, 2, 3}, Storage::uint8}};
  EXPECT_EQ(written_and_read(mesh, {.format = Format::xyz}), mesh);
  std::vector<std::string> notes;
  Mesh triangle = unit_triangle();
  triangle.channels = {{"weight", {"weight"}, {1, 2, 3}}};
  (void)formatted(triangle, {.format = Format::xyz}, &notes);
  EXPECT_EQ(notes.size(), 2U);
}

TEST(Xyz, ColoursLoseTheirAlphaOnly) {
  Mesh mesh;
  mesh.points = {{1, 2, 3}, {4, 5, 6}};
  mesh.channels = {
      {"color", {"red", "green", "blue", "alpha"}, {255, 0, 7, 9, 1, 2, 3, 8}, Storage::uint8}};
  std::vector<std::string> notes;
  EXPECT_EQ(formatted(mesh, {.format = Format::xyz}, &notes), "1 2 3 255 0 7\n4 5 6 1 2 3\n");
  EXPECT_EQ(notes,
            std::vector<std::string>{"XYZ has no place for the alpha of colours; it is left out"});
}

TEST(Xyz, ByName) {
  EXPECT_EQ(format_of_path("a/b.XYZ"), Format::xyz);
  EXPECT_EQ(format_of_path("b.pwn"), Format::xyz);
  EXPECT_STREQ(name_of(Format::xyz), "xyz");
}

}  // namespace
}  // namespace surpass

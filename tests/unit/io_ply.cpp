#include <bit>
#include <cstring>

#include "unit/io_support.hpp"

namespace surpass {
namespace {

using Indices = std::vector<Index>;

// A number's bytes in the order asked for.
template <class T>
std::string bytes_of(T value, bool big_endian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  const bool swap = big_endian != (std::endian::native == std::endian::big);
  return swap ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

TEST(Ply, ReadsTextWithEveryKindOfElement) {
  const LoadedMesh loaded = parsed(
      "ply\nformat ascii 1.0\ncomment surpass scheme=loop boundary=hoppe\nobj_info none\n"
      "element face 2\nproperty uchar red\nproperty list uchar int vertex_index\n"
      "property uchar green\nproperty uchar blue\nproperty list uchar float texcoord\n"
      "property uchar hole\nproperty list uchar int scraps\n"
      "element vertex 4\nproperty float quality\nproperty double z\nproperty double y\n"
      "property double x\nproperty float sharpness\n"
      "element camera 1\nproperty int id\nproperty list uchar float path\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty float sharpness\n"
      "end_header\n"
      "10 3 0 1 2 20 30 6 0 0 1 0 0 1 0 0\n11 4 3 2 1 0 21 31 0 1 2 7 8\n"
      "0.5 3 2 1 0\n1.5 0 0 1 4\n2.5 0 1 0 0\n3.5 1 0 0 10\n"
      "7 2 0.5 0.25\n1 2 2.5\n",
      Format::ply);
  const Mesh& mesh = loaded.mesh;
  EXPECT_EQ(mesh.points, (std::vector<Point>{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.face_offsets, (Indices{0, 3, 7}));
  EXPECT_EQ(mesh.face_vertices, (Indices{0, 1, 2, 3, 2, 1, 0}));
  EXPECT_EQ(mesh.hole_faces, Indices{1});
  EXPECT_EQ(
      mesh.channels,
      (std::vector<Channel>{{"quality", {"quality"}, {0.5, 1.5, 2.5, 3.5}, Storage::float32}}));
  EXPECT_EQ(mesh.face_channels,
            (std::vector<FaceChannel>{
                {"color", {"red", "green", "blue"}, {10, 20, 30, 11, 21, 31}, Storage::uint8}}));
  EXPECT_EQ(mesh.corner_channels,
            (std::vector<CornerChannel>{
                {"texture", 2, {0, 0, 1, 0, 0, 1}, {0, 1, 2, kNone, kNone, kNone, kNone}}}));
  EXPECT_EQ(mesh.corners, (std::vector<Corner>{{1, 4}, {3, 10}}));
  EXPECT_EQ(mesh.creases, (std::vector<Crease>{{{1, 2}, 2.5F}}));
  EXPECT_EQ(mesh.annotation("boundary"), "hoppe");
  EXPECT_EQ(loaded.notices, (std::vector<std::string>{"the list scraps of element face is skipped",
                                                      "1 rows of element camera are skipped"}));
}

TEST(Ply, GroupsPropertiesThatBelongTogether) {
  const Mesh mesh = parsed(
                        "ply\nformat ascii 1.0\nelement vertex 1\nproperty uchar blue\n"
                        "property float nx\nproperty float ny\nproperty float x\nproperty float y\n"
                        "property float z\nproperty float nz\nproperty uchar red\n"
                        "property uchar green\nproperty short u\nproperty int8 alpha\n"
                        "property double v\nend_header\n1 0 0.5 9 8 7 1 2 3 4 5 6\n",
                        Format::ply)
                        .mesh;
  const std::vector<Channel> expected = {
      {"color", {"red", "green", "blue", "alpha"}, {2, 3, 1, 5}, Storage::float64},
      {"normal", {"nx", "ny", "nz"}, {0, 0.5, 1}, Storage::float32},
      {"texture", {"u", "v"}, {4, 6}, Storage::float64}};
  EXPECT_EQ(mesh.channels, expected);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{9, 8, 7}}));
}

TEST(Ply, ReadsBothByteOrdersAndAllTypes) {
  for (const bool big : {false, true}) {
    std::string text = std::string("ply\r\nformat ") +
                       (big ? "binary_big_endian" : "binary_little_endian") +
                       " 1.0\r\nelement vertex 3\r\nproperty float32 x\r\nproperty int16 y\r\n"
                       "property uint32 z\r\nproperty int8 a\r\nproperty uint16 b\r\n"
                       "element face 1\r\nproperty list uint16 uint8 vertex_indices\r\n"
                       "end_header\r\n";
    for (int v = 0; v < 3; ++v) {
      text += bytes_of(0.25F * static_cast<float>(v), big);
      text += bytes_of(static_cast<std::int16_t>(-300 - v), big);
      text += bytes_of(4000000000U, big);
      text += bytes_of(static_cast<std::int8_t>(-7), big);
      text += bytes_of(std::uint16_t{60000}, big);
    }
    text += bytes_of(std::uint16_t{3}, big) + std::string("\x02\x00\x01", 3);
    const Mesh mesh = parsed(text, Format::automatic).mesh;
    EXPECT_EQ(mesh.points,
              (std::vector<Point>{{0, -300, 4e9}, {0.25, -301, 4e9}, {0.5, -302, 4e9}}));
    EXPECT_EQ(mesh.face_vertices, (Indices{2, 0, 1}));
    EXPECT_EQ(mesh.channels.at(0).values, (std::vector<double>{-7, -7, -7}));
    EXPECT_EQ(mesh.channels.at(1).values, (std::vector<double>{60000, 60000, 60000}));
    EXPECT_EQ(mesh.channels.at(1).storage, Storage::uint16);
  }
}

TEST(Ply, ReadsTriangleStrips) {
  const Mesh mesh = parsed(
                        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                        "property float y\nproperty float z\nelement tristrips 1\n"
                        "property list int int vertex_indices\nend_header\n"
                        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n11 0 1 2 3 3 4 -1 4 2 1 0\n",
                        Format::ply)
                        .mesh;
  EXPECT_EQ(mesh.face_vertices, (Indices{0, 1, 2, 2, 1, 3, 4, 2, 1, 1, 2, 0}));
}

TEST(Ply, ChannelsGoBackToTheirTypeWhereValuesFit) {
  Mesh mesh = unit_triangle();
  mesh.channels = {{"a", {"a"}, {0, 255, 3}, Storage::uint8},
                   {"b", {"b"}, {0, 256, 3}, Storage::uint8},
                   {"c", {"c"}, {0.5, 1, 2}, Storage::float32},
                   {"d", {"d"}, {0.1, 1, 2}, Storage::float32},
                   {"e", {"e"}, {-0.0, 1, 2}, Storage::int32}};
  const std::string text = formatted(mesh, {.format = Format::ply, .encoding = Encoding::ascii});
  EXPECT_EQ(text,
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
            "property double z\nproperty uchar a\nproperty double b\nproperty float c\n"
            "property double d\nproperty double e\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0 0 0 0.5 0.1 -0\n1 0 0 255 256 1 1 1\n0 1 0 3 3 2 2 2\n3 0 1 2\n");
}

TEST(Ply, LittleEndianDoublesUnlessTold) {
  Mesh mesh = unit_triangle();
  mesh.points[1][0] = 0.1;
  EXPECT_NE(formatted(mesh, {.format = Format::ply})
                .find("format binary_little_endian 1.0\nelement vertex 3\nproperty double x\n"),
            std::string::npos);
  for (const Encoding encoding : {Encoding::ascii, Encoding::little_endian, Encoding::big_endian}) {
    const WriteOptions options = {
        .format = Format::ply, .encoding = encoding, .single_precision = true};
    EXPECT_EQ(written_and_read(mesh, options).points,
              stored_positions(mesh.points, Format::ply, true));
  }
  EXPECT_EQ(stored_positions(mesh.points, Format::ply, true)[1][0], double{0.1F});
  EXPECT_EQ(stored_positions(mesh.points, Format::ply, false), mesh.points);
  EXPECT_EQ(stored_positions(mesh.points, Format::obj, true), mesh.points);
  EXPECT_EQ(stored_positions(mesh.points, Format::stl, false)[1][0], double{0.1F});
}

TEST(Ply, LongPolygonsGetLongLists) {
  Mesh mesh;
  std::vector<Index> face;
  for (Index v = 0; v < 300; ++v) {
    mesh.points.push_back({1.0 * v, 0.5 * v * v, 0});
    face.push_back(v);
  }
  mesh.add_face(face);
  for (const Encoding encoding : {Encoding::ascii, Encoding::little_endian, Encoding::big_endian}) {
    EXPECT_EQ(written_and_read(mesh, {.format = Format::ply, .encoding = encoding}), mesh);
  }
}

TEST(Ply, SaysWhatItCannotHold) {
  Mesh mesh = unit_triangle();
  mesh.tags = {"t interpolateboundary 1/0/0 2"};
  mesh.face_sets = {{FaceSet::Kind::group, "a", {0}}};
  mesh.material_libraries = {"a.mtl"};
  mesh.corner_channels = {{"texture", 2, {0, 0}, {0, kNone, 0}}};
  mesh.channels = {{"pair", {"a", "b"}, {1, 2, 3, 4, 5, 6}}, {"x", {"x"}, {1, 2, 3}}};
  std::vector<std::string> notes;
  (void)formatted(mesh, {.format = Format::ply}, &notes);
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "PLY has no place for OpenSubdiv's tags; 1 left out",
                       "PLY has no place for groups, objects and materials; 1 left out",
                       "PLY has no place for material libraries; 1 left out",
                       "the 2 columns of channel 'pair' become single properties of PLY",
                       "PLY has no place for the channel 'x'; it is left out",
                       "PLY has no place for the corner channel 'texture'; it is left out"}));
}

}  // namespace
}  // namespace surpass

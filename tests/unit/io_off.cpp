#include "unit/io_support.hpp"

namespace surpass {
namespace {

Mesh read_off(std::string_view text) { return parsed(text, Format::off).mesh; }

TEST(Off, HeaderVariantsGiveTheSameMesh) {
  const Mesh plain = unit_triangle();
  for (const char* text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "OFF3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
        "3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
        "# a\n\nOFF # b\n# c\n3 1\n\n0 0 0#d\n1 0 0\n\n0 1 0\n# e\n3 0 1 2 # f",
        "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", "OFF\n3 1 0\n0 0\n0 1 0 0 0\n1 0\n3 0\n1 2\n"}) {
    EXPECT_EQ(read_off(text), plain) << text;
  }
}

TEST(Off, PolygonsOnOneLineNeedNoLineEnds) {
  const Mesh mesh = read_off("OFF 4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3");
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
}

TEST(Off, ColoursNormalsAndTextureOfVertices) {
  const Mesh mesh = read_off(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 128 0 0.5\n1 0 0 0 0 1 0 255 0 128 1 0\n"
      "0 1 0 0 0 1 0 0 255 128 0 1\n3 0 1 2\n");
  const std::vector<Channel> expected = {
      {"normal", {"nx", "ny", "nz"}, {0, 0, 1, 0, 0, 1, 0, 0, 1}},
      {"color",
       {"red", "green", "blue", "alpha"},
       {255, 0, 0, 128, 0, 255, 0, 128, 0, 0, 255, 128},
       Storage::uint8},
      {"texture", {"s", "t"}, {0, 0.5, 1, 0, 0, 1}}};
  EXPECT_EQ(mesh.channels, expected);
  EXPECT_EQ(written_and_read(mesh, {.format = Format::off}), mesh);
}

TEST(Off, FaceColoursAsFractionsOrBytes) {
  const Mesh fractions =
      read_off("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 0 0.5\n3 2 1 0 0 0 1\n");
  EXPECT_EQ(fractions.face_channels,
            (std::vector<FaceChannel>{{"color", {"red", "green", "blue"}, {1, 0, 0.5, 0, 0, 1}}}));
  EXPECT_EQ(written_and_read(fractions, {.format = Format::off}), fractions);
  const Mesh bytes = read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 255 7\n");
  EXPECT_EQ(bytes.face_channels,
            (std::vector<FaceChannel>{
                {"color", {"red", "green", "blue", "alpha"}, {1, 0, 255, 7}, Storage::uint8}}));
  EXPECT_EQ(written_and_read(bytes, {.format = Format::off}), bytes);
}

TEST(Off, WholeFractionsStayFractions) {
  Mesh mesh = unit_triangle();
  mesh.face_channels = {{"color", {"red", "green", "blue"}, {1, 0, 1}}};
  EXPECT_EQ(formatted(mesh, {.format = Format::off}),
            "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 0.0 1.0\n");
}

TEST(Off, FaceColoursOfSomeFacesAreLeftOutWithANotice) {
  const LoadedMesh loaded =
      parsed("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 0\n3 2 1 0\nrest", Format::off);
  EXPECT_TRUE(loaded.mesh.face_channels.empty());
  EXPECT_EQ(loaded.notices,
            (std::vector<std::string>{"text behind the last face is not used",
                                      "1 of 2 faces have a colour; these colours are left out"}));
}

TEST(Off, SaysThatItHasNoCreases) {
  Mesh mesh = unit_triangle();
  mesh.creases = {{{0, 1}, 2}};
  mesh.corners = {{2, 3}};
  mesh.hole_faces = {0};
  std::vector<std::string> notes;
  (void)formatted(mesh, {.format = Format::off}, &notes);
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "OFF has no place for creases; 1 left out",
                       "OFF has no place for sharp corners; 1 left out",
                       "OFF has no place for hole faces; 1 are like other faces there"}));
}

}  // namespace
}  // namespace surpass

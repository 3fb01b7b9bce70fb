// What is refused, where, and in which words. Each case is a small file written out here.
#include <surpass/io.hpp>
#include <surpass/topology.hpp>

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace surpass {
namespace {

using namespace std::string_literals;

struct Case {
  Format format;
  std::string text;
  ErrorCode code;
  std::string sentence;
};

void expect_refused(const std::vector<Case>& cases) {
  for (const Case& wanted : cases) {
    const auto loaded = parse_mesh(wanted.text, wanted.format, "f");
    ASSERT_FALSE(loaded) << wanted.text;
    EXPECT_STREQ(name_of(loaded.error().code), name_of(wanted.code)) << wanted.text;
    EXPECT_EQ(describe(loaded.error()), wanted.sentence) << wanted.text;
  }
}

constexpr const char* kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Refused, ObjNumbers) {
  constexpr Format f = Format::obj;
  expect_refused({
      {f, "v 0 0 0\r\nv 1d0 0 0\n", ErrorCode::bad_number,
       "f:2:3: an x coordinate is written '1d0' with a Fortran exponent; write e in the place of "
       "d"},
      {f, "v 0\t1,5 0\n", ErrorCode::bad_number,
       "f:1:5: a y coordinate is written '1,5'; use a decimal point, and blanks between numbers, "
       "in "
       "the place of commas"},
      {f, "v 0 0 0\rv 0 0 -NaN\r", ErrorCode::not_finite,
       "f:2:7: a z coordinate is '-NaN'; only finite numbers can be used, correct or remove it"},
      {f, "v inf 0 0\n", ErrorCode::not_finite,
       "f:1:3: an x coordinate is 'inf'; only finite numbers can be used, correct or remove it"},
      {f, "v 1e400 0 0\n", ErrorCode::bad_number,
       "f:1:3: an x coordinate is '1e400', too large for a floating-point number; scale the model "
       "down"},
      {f, "v 1 2 3.1+e2\n", ErrorCode::bad_number,
       "f:1:7: expected a z coordinate, but '3.1+e2' is not a number"},
      {f, "v 0 +-1 0\n", ErrorCode::bad_number,
       "f:1:5: expected a y coordinate, but '+-1' is not a number"},
      {f, "v 0 0 # 0\n", ErrorCode::syntax,
       "f:1:7: the line ends before a z coordinate; a number is missing"},
      {f, "v 0 0", ErrorCode::unexpected_end, "f:1:6: the file ends before a z coordinate"},
      {f, "v 0 0 0 1 2\n", ErrorCode::syntax,
       "f:1:9: a vertex is x y z, with a weight or a colour of 3 or 4 numbers behind; this line "
       "has "
       "another count of numbers"},
      {f, "v 0 0 0 nan 0 0\n", ErrorCode::not_finite,
       "f:1:9: a weight or colour is 'nan'; only finite numbers can be used, correct or remove it"},
  });
}

TEST(Refused, ObjFaces) {
  constexpr Format f = Format::obj;
  expect_refused({
      {f, kThree + "f 1 2 4\n"s, ErrorCode::index_out_of_range,
       "f:4:7: vertex 4 (counted from 1) is named here, but the file has 3"},
      {f, kThree + "f 1 0 2\n"s, ErrorCode::index_out_of_range,
       "f:4:5: OBJ counts from 1; there is no vertex 0"},
      {f, kThree + "f 1 2 \\\n -4\n"s, ErrorCode::index_out_of_range,
       "f:5:2: vertex -4 is asked for, but only 3 came before this line"},
      {f, kThree + "f 1 2 99999999999999999999\n"s, ErrorCode::index_out_of_range,
       "f:4:7: there cannot be so many: vertex '99999999999999999999'"},
      {f, kThree + "vt 0 0\nf 1/1 2/2 3/1\n"s, ErrorCode::index_out_of_range,
       "f:5:9: texture coordinate 2 (counted from 1) is named here, but the file has 1"},
      {f, kThree + "f 1 2 x\n"s, ErrorCode::syntax,
       "f:4:7: expected the number of a vertex, but found 'x'"},
      {f, kThree + "f 1 2 3.0\n"s, ErrorCode::syntax,
       "f:4:8: expected a blank before '.0'; corners are written v, v/vt, v//vn or v/vt/vn"},
      {f, kThree + "f\n"s, ErrorCode::syntax, "f:4:2: the face has no vertices; remove the line"},
      {f, "what is this\n", ErrorCode::syntax,
       "f:1:1: the file has no vertices, and this line is none of OBJ's; is it another kind of "
       "file?"},
  });
}

TEST(Refused, ObjTags) {
  constexpr Format f = Format::obj;
  expect_refused({
      {f, kThree + "t crease 2/1/0 0 3 1\n"s, ErrorCode::index_out_of_range,
       "f:4:18: vertex 4 (counted from 1) is named here, but the file has 3"},
      {f, kThree + "t corner 1/1/0 0 -1\n"s, ErrorCode::syntax,
       "f:4:18: a sharpness is negative; give 0 for smooth, up to 10 for infinitely sharp"},
      {f, kThree + "t corner 1/1/0 0 nan\n"s, ErrorCode::not_finite,
       "f:4:18: a sharpness is 'nan'; only finite numbers can be used, correct or remove it"},
      {f, kThree + "t crease 3/1/0 0 1 2 5\n"s, ErrorCode::syntax,
       "f:4:2: a crease is named by pairs of vertices; one has no partner"},
      {f, kThree + "t crease 2 0 1 5\n"s, ErrorCode::syntax,
       "f:4:10: expected the tag's argument counts, such as 2/1/0, but found '2'"},
      {f, kThree + "t crease 4/3/0 0 1 1 2 5 5 5\n"s, ErrorCode::syntax,
       "f:4:2: the tag names 2 edges or vertices and 3 sharpnesses; give one sharpness for all, or "
       "one each"},
      {f, kThree + "t hole 1/0/0 0\n"s, ErrorCode::index_out_of_range,
       "f:4:14: face 1 (counted from 1) is named here, but the file has 0"},
      {f, kThree + "t corner 1/1/0 0 1 7\n"s, ErrorCode::syntax,
       "f:4:20: '7' is more than this line may hold; remove it"},
  });
}

TEST(Refused, Off) {
  constexpr Format f = Format::off;
  expect_refused({
      {f, "4OFF\n1 0 0\n0 0 0 1\n", ErrorCode::unsupported,
       "f:1:1: '4OFF' is not a surface in three dimensions; only OFF with the prefixes ST, C and N "
       "can be read"},
      {f, "OFF BINARY\n\1\2", ErrorCode::unsupported,
       "f:1:5: binary OFF files do not tell their byte order and cannot be read; save the mesh as "
       "text OFF or as binary PLY"},
      {f, "hello\n", ErrorCode::syntax,
       "f:1:1: an OFF file begins with OFF, COFF, NOFF or the like, but this one with 'hello'"},
      {f, "OFF\n-3 1 0\n", ErrorCode::syntax,
       "f:2:1: expected the number of vertices, a whole number from 0, but found '-3'"},
      {f, "OFF\n2000000000 5 0\n0 0 0\n", ErrorCode::unexpected_end,
       "f:2:12: 2000000000 vertices and 5 faces are announced, more than the 7 bytes that follow "
       "can "
       "hold; the file is damaged or cut off"},
      {f, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ErrorCode::index_out_of_range,
       "f:6:7: vertex 3 is named here, but the file has 3, counted from 0"},
      {f, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n", ErrorCode::index_out_of_range,
       "f:6:5: vertex -1 is named here, but the file has 3, counted from 0"},
      {f, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n20000000 0 1 2\n", ErrorCode::unexpected_end,
       "f:6:1: a face of 20000000 vertices is announced, more than the rest of the file can hold; "
       "it "
       "is damaged or cut off"},
      {f, "OFF\n3 1 0\n0 0 0,\n1 0 0,\n0 1 0,\n3 0 1 2\n", ErrorCode::bad_number,
       "f:3:5: a z coordinate is written '0,'; use a decimal point, and blanks between numbers, in "
       "the place of commas"},
      {f, "OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", ErrorCode::syntax,
       "f:3:1: the vertex has 4 numbers where the file's keyword asks for 3; COFF announces "
       "colours, "
       "NOFF normals, STOFF texture coordinates"},
      {f, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n0\n3 0 1 2\n", ErrorCode::syntax,
       "f:6:1: the face has no vertices; remove it"},
      {f, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 1\n", ErrorCode::syntax,
       "f:6:9: behind the vertices of a face only a colour of 1, 3 or 4 numbers may stand"},
      {f, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 5\n3 0 1 2\n", ErrorCode::syntax,
       "f:5:7: '5' is more than this line may hold; remove it"},
      {f, "OFF\n3 2 0\n0.0 0.0 0.0\n1 0 0\n0 1 0\n3 0 1 2\n", ErrorCode::unexpected_end,
       "f:7:1: the file ends before a face's number of vertices"},
  });
}

const std::string kVertexHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n";
const std::string kFaceHeader =
    "element face 1\nproperty list char int vertex_indices\nend_header\n";

TEST(Refused, PlyHeaders) {
  constexpr Format f = Format::ply;
  expect_refused({
      {f, "plx\n", ErrorCode::syntax,
       "f:1:1: a PLY file begins with a line 'ply', this one does not"},
      {f, "ply\nformat ascii 2.0\n", ErrorCode::unsupported,
       "f:2:14: PLY version '2.0' is not known, only 1.0; save the mesh again as PLY 1.0"},
      {f, "ply\nformat morse 1.0\n", ErrorCode::syntax,
       "f:2:8: 'morse' is no PLY format; there are ascii, binary_little_endian and "
       "binary_big_endian"},
      {f, "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n", ErrorCode::unexpected_end,
       "f:5:1: the file ends inside its header, before the line 'end_header'"},
      {f, "ply\nformat ascii 1.0\nelement vertex -3\n", ErrorCode::syntax,
       "f:3:16: expected the element's count, a whole number from 0, but found '-3'"},
      {f, "ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n", ErrorCode::syntax,
       "f:4:10: 'quad' is no PLY type; there are char, uchar, short, ushort, int, uint, float, "
       "double, and int8 to float64"},
      {f,
       kVertexHeader + "element tristrips 1\nproperty list int int vertex_indices\n" + kFaceHeader +
           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n",
       ErrorCode::unsupported,
       "f:7:1: the file has faces and triangle strips; save it with faces only"},
      {f, kVertexHeader + "property float x\n", ErrorCode::syntax,
       "f:7:16: property 'x' is there twice"},
      {f, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
       ErrorCode::syntax,
       "f:3:1: element vertex has no single-valued property 'y'; without it there is no mesh"},
      {f, kVertexHeader + "element face 1\nproperty int a\nend_header\n0 0 0\n1 0 0\n0 1 0\n7\n",
       ErrorCode::syntax,
       "f:7:1: element face has no list 'vertex_indices'; without it there is no mesh"},
      {f, "ply\nend_header\n", ErrorCode::syntax,
       "f: the PLY header has no line 'format ascii 1.0' or the like"},
  });
}

TEST(Refused, PlyText) {
  constexpr Format f = Format::ply;
  const std::string head = kVertexHeader + kFaceHeader;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_refused({
      {f, head + points + "3 0 1 3\n", ErrorCode::index_out_of_range,
       "f:13:7: vertex 3 is named here, but the file has 3, counted from 0"},
      {f, head + points + "-3 0 1 2\n", ErrorCode::syntax,
       "f:13:1: the list vertex_indices has a negative length"},
      {f, head + points + "0\n", ErrorCode::syntax, "f:13:2: the face has no vertices; remove it"},
      {f, head + points + "300 0 1 2\n", ErrorCode::bad_number,
       "f:13:1: vertex_indices is no whole number that fits the header's type char"},
      {f, head + points + "3 0 1.5 2\n", ErrorCode::bad_number,
       "f:13:5: vertex_indices is no whole number that fits the header's type int"},
      {f, head + points + "100 0 1 2\n", ErrorCode::unexpected_end,
       "f:13:1: the list vertex_indices announces 100 values, more than the file has bytes for; it "
       "is damaged or cut off"},
      {f, head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n", ErrorCode::syntax,
       "f:10:4: the line ends before z; a number is missing"},
      {f, head + "0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n", ErrorCode::syntax,
       "f:10:7: the line holds more values than the header announces; correct the header or the "
       "line"},
      {f, head + "0 0 0\n", ErrorCode::unexpected_end,
       "f:10:1: the header announces 3 rows of element vertex, at least 6 bytes each, but only 6 "
       "bytes follow; the file is damaged or cut off"},
      {f, kVertexHeader + "property float sharpness\nend_header\n0 0 0 0\n1 0 0 -1\n0 1 0 0\n",
       ErrorCode::syntax, "f:10:1: the vertex has a negative sharpness; 0 is smooth"},
      {f,
       kVertexHeader +
           "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
           "property float sharpness\nend_header\n" +
           points + "0 3 1\n",
       ErrorCode::index_out_of_range,
       "f:15:1: vertex 3 is named here, but the file has 3, counted from 0"},
      {f,
       kVertexHeader +
           "element face 1\nproperty list uchar int vertex_indices\n"
           "property list uchar float texcoord\nend_header\n" +
           points + "3 0 1 2 4 0 0 1 1\n",
       ErrorCode::syntax,
       "f:14:1: the list texcoord has 4 numbers for a face of 3 corners; two each are expected, or "
       "none at all"},
  });
}

TEST(Refused, PlyBytes) {
  constexpr Format f = Format::ply;
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar y\n"
      "property float x\nproperty uchar z\nelement face 1\n"
      "property list char char vertex_indices\nend_header\n";
  const std::string vertex("\1\0\0\0\0\2", 6);
  const std::size_t body = head.size();
  const auto at = [&](std::size_t byte) { return "f:byte " + std::to_string(body + byte) + ": "; };
  expect_refused({
      {f, head + vertex + "\3\0\0\1"s, ErrorCode::index_out_of_range,
       at(9) + "vertex 1 is named here, but the file has 1, counted from 0"},
      {f, head + vertex + "\3\0\xFF\0"s, ErrorCode::index_out_of_range,
       at(8) + "vertex -1 is named here, but the file has 1, counted from 0"},
      {f, head + vertex + "\xFF"s, ErrorCode::syntax,
       at(6) + "the list vertex_indices has a negative length"},
      {f, head + vertex + "\3\0\0"s, ErrorCode::unexpected_end,
       at(6) +
           "the list vertex_indices announces 3 values, more than the file has bytes for; it is "
           "damaged or cut off"},
      {f, head + "\1\0\0\xC0\x7F\2\1\0"s, ErrorCode::not_finite,
       at(1) + "x is NaN; only finite numbers can be used, correct or remove it"},
      {f, head + "\1\0\0\x80\xFF\2\1\0"s, ErrorCode::not_finite,
       at(1) + "x is infinite; only finite numbers can be used, correct or remove it"},
      {f, head + "\1\0\0"s, ErrorCode::unexpected_end,
       at(0) + "the header announces 1 rows of element vertex, at least 6 bytes each, but only 3 "
               "bytes follow; the file is damaged or cut off"},
  });
}

TEST(Refused, Stl) {
  constexpr Format f = Format::stl;
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  std::string nan = binary;
  nan.replace(84 + 12 + 8, 4, "\0\0\xC0\x7F"s);
  std::string many = binary;
  many.replace(80, 4, "\xFF\xFF\xFF\xFF");
  expect_refused({
      {f, binary + "more", ErrorCode::syntax,
       "f:byte 80: 1 triangles are announced, which take 134 bytes, but the file has 138; it is "
       "damaged, export it again"},
      {f, many, ErrorCode::unexpected_end,
       "f:byte 80: 4294967295 triangles are announced, which take 214748364834 bytes, but the file "
       "has 134; it is damaged, export it again"},
      {f, nan, ErrorCode::not_finite,
       "f:byte 104: a coordinate is NaN or infinite; export the mesh again"},
      {f, "short", ErrorCode::unexpected_end,
       "f: this is no STL file: text begins with 'solid', and binary has at least 84 bytes"},
      {f, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex", ErrorCode::bad_number,
       "f:5:1: expected a z coordinate, but 'vertex' is not a number"},
      {f, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop", ErrorCode::syntax,
       "f:5:1: expected 'vertex', but found 'endloop'"},
      {f, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", ErrorCode::unexpected_end,
       "f:5:1: the file ends before 'vertex'; it is cut off"},
      {f, "solid a\n", ErrorCode::unexpected_end,
       "f:2:1: the file ends before 'endsolid'; it is cut off"},
  });
}

TEST(Refused, WholeFiles) {
  for (const Format format :
       {Format::automatic, Format::obj, Format::ply, Format::off, Format::stl}) {
    expect_refused({{format, "", ErrorCode::unexpected_end, "f: the file is empty"},
                    {format, "\xFE\xFF\0v\0 "s, ErrorCode::unsupported,
                     "f:byte 0: the text is encoded in UTF-16; save it as UTF-8"}});
  }
  expect_refused({
      {Format::automatic, "1 2 3\n", ErrorCode::unknown_format,
       "f: neither the name nor the first bytes show a format that is known (OBJ, PLY, OFF, STL; "
       "XYZ by its name)"},
      {Format::obj, "# nothing\n", ErrorCode::empty_mesh, "f: there are no vertices in the file"},
      {Format::off, "OFF\n0 0 0\n", ErrorCode::empty_mesh, "f: there are no vertices in the file"},
      {Format::stl, "solid a\nendsolid a", ErrorCode::empty_mesh,
       "f: there are no vertices in the file"},
      {Format::stl, std::string(84, '\0'), ErrorCode::empty_mesh,
       "f: there are no vertices in the file"},
  });
}

// Faces that are no polygons are read all the same: they are the mesh's fault, and can be mended.
TEST(Refused, DegenerateFacesByTheTopologyOnly) {
  for (const char* face : {"f 1 2\n", "f 3\n", "f 1 2 2\n", "f 1 2 3 1\n"}) {
    const auto loaded = parse_mesh(kThree + std::string(face), Format::obj, "f");
    ASSERT_TRUE(loaded) << face;
    EXPECT_EQ(loaded->mesh.face_count(), 1U);
    const auto topology = Topology::build(loaded->mesh);
    ASSERT_FALSE(topology) << face;
    EXPECT_GE(topology.error().code, ErrorCode::empty_mesh);
  }
}

}  // namespace
}  // namespace surpass

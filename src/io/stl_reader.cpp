// STL, the StereoLithography Interface Specification of 3D Systems, 1989. Triangles name no
// vertices, so equal coordinates become one vertex. Normals follow from the triangles and are not
// read.
#include <algorithm>

#include <fmt/format.h>

#include "io/annotations.hpp"
#include "io/face_sets.hpp"
#include "io/point_table.hpp"
#include "io/readers.hpp"
#include "io/stl_format.hpp"
#include "io/storage.hpp"

namespace surpass::io {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view found, std::string_view wanted) {
  return std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(),
                    [](char a, char b) { return lower(a) == b; });
}

// Binary files may begin with "solid" too, but text has no zero bytes.
bool is_text(std::string_view bytes) {
  constexpr std::size_t kLook = 512;
  Scanner scan(bytes, "");
  scan.skip_space();
  return same_word(scan.word(), "solid") && bytes.substr(0, kLook).find('\0') == bytes.npos;
}

std::uint64_t announced_size(const char* bytes) {
  return stl::kPrelude +
         std::uint64_t{stl::kFacet} * load<std::uint32_t, stl::kSwap>(bytes + stl::kHeader);
}

class StlReader {
 public:
  StlReader(Scanner& scan, LoadedMesh& out) : scan_(scan), out_(out), mesh_(out.mesh) {}

  bool read_binary();
  bool read_text();

 private:
  bool check_binary_size();
  bool read_binary_facet();
  bool read_solid();
  bool read_text_facet();
  bool expect(std::string_view keyword);
  bool add_triangle(const std::array<Point, 3>& triangle, const char* place);

  Scanner& scan_;
  LoadedMesh& out_;
  Mesh& mesh_;
  PointTable table_;
  FaceSetBuilder solids_;
  bool attributes_ = false;
};

bool StlReader::check_binary_size() {
  if (scan_.left() < stl::kPrelude) {
    return scan_.fail_as_a_whole(
        ErrorCode::unexpected_end,
        "this is no STL file: text begins with 'solid', and binary has at least 84 bytes");
  }
  const std::uint64_t announced = announced_size(scan_.at());
  if (announced == scan_.left()) return true;
  return scan_.fail_at_byte(
      announced > scan_.left() ? ErrorCode::unexpected_end : ErrorCode::syntax,
      fmt::format("{} triangles are announced, which take {} bytes, but the file has {}; it is "
                  "damaged, export it again",
                  (announced - stl::kPrelude) / stl::kFacet, announced, scan_.left()),
      scan_.at() + stl::kHeader);
}

bool StlReader::read_binary() {
  if (!check_binary_size()) return false;
  const std::string_view header(scan_.at(), stl::kHeader);
  read_annotations(header.substr(0, header.find('\0')), mesh_);
  scan_.advance(stl::kPrelude);
  mesh_.face_vertices.reserve(3 * (scan_.left() / stl::kFacet));
  mesh_.face_offsets.reserve(1 + scan_.left() / stl::kFacet);
  while (!scan_.done()) {
    if (!read_binary_facet()) return false;
  }
  if (attributes_) {
    out_.notices.emplace_back(
        "attribute bytes of the triangles (colours, in some programs) are skipped");
  }
  return true;
}

bool StlReader::read_binary_facet() {
  const char* facet = scan_.at();
  std::array<Point, 3> triangle;
  const char* place = facet + stl::kFacetPositions;
  for (Point& corner : triangle) {
    for (double& coordinate : corner) {
      coordinate = static_cast<double>(load<float, stl::kSwap>(place));
      if (!std::isfinite(coordinate)) {
        return scan_.fail_at_byte(ErrorCode::not_finite,
                                  "a coordinate is NaN or infinite; export the mesh again", place);
      }
      place += sizeof(float);
    }
  }
  attributes_ = attributes_ || load<std::uint16_t, stl::kSwap>(facet + stl::kFacetAttribute) != 0;
  scan_.advance(stl::kFacet);
  return add_triangle(triangle, facet);
}

bool StlReader::add_triangle(const std::array<Point, 3>& triangle, const char* place) {
  if (mesh_.face_vertices.size() >= kNone - 3) {
    return scan_.fail_at_byte(ErrorCode::too_large, "more than 1431655764 triangles", place);
  }
  std::array<Index, 3> vertices = {};
  for (std::size_t k = 0; k < 3; ++k) vertices[k] = table_.find_or_add(triangle[k], mesh_.points);
  mesh_.add_face(vertices);
  return true;
}

bool StlReader::read_text() {
  for (scan_.skip_space(); !scan_.done(); scan_.skip_space()) {
    if (!read_solid()) return false;
  }
  mesh_.face_sets = solids_.finish(mesh_.face_count());
  return true;
}

bool StlReader::read_solid() {
  if (!expect("solid")) return false;
  const std::string_view name = scan_.rest_of_line();
  std::vector<std::string_view> names;
  if (!name.empty() && !read_annotations(name, mesh_)) names.push_back(name);
  solids_.select(FaceSet::Kind::object, names, mesh_.face_count());
  for (;;) {
    scan_.skip_space();
    const char* start = scan_.at();
    if (scan_.done()) return expect("endsolid");
    if (same_word(scan_.word(), "endsolid")) break;
    scan_.move_to(start);
    if (!read_text_facet()) return false;
  }
  scan_.skip_line();  // the name may be repeated
  return true;
}

bool StlReader::read_text_facet() {
  if (!expect("facet") || !expect("normal")) return false;
  const char* place = scan_.at();
  for (int k = 0; k < 3; ++k) {
    scan_.skip_space();
    (void)scan_.word();
  }
  if (!expect("outer") || !expect("loop")) return false;
  std::array<Point, 3> triangle;
  for (Point& corner : triangle) {
    if (!expect("vertex")) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      scan_.skip_space();
      if (!scan_.number(corner[k], kCoordinates[k])) return false;
    }
  }
  return expect("endloop") && expect("endfacet") && add_triangle(triangle, place);
}

bool StlReader::expect(std::string_view keyword) {
  scan_.skip_space();
  const char* start = scan_.at();
  if (scan_.done()) {
    return scan_.fail(ErrorCode::unexpected_end,
                      fmt::format("the file ends before '{}'; it is cut off", keyword));
  }
  const std::string_view found = scan_.word();
  return same_word(found, keyword) ||
         scan_.fail(ErrorCode::syntax,
                    fmt::format("expected '{}', but found {}", keyword, quoted(found)), start);
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= stl::kPrelude && announced_size(bytes.data()) == bytes.size();
}

bool read_stl(Scanner& scan, LoadedMesh& out) {
  const std::string_view bytes(scan.at(), scan.left());
  StlReader reader(scan, out);
  return is_text(bytes) && !is_binary_stl(bytes) ? reader.read_text() : reader.read_binary();
}

}  // namespace surpass::io

// Wavefront OBJ: polygons, colours at vertices, texture coordinates, normals, groups, and
// OpenSubdiv's tags. Free-form curves and surfaces, points and lines are skipped with a notice.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/annotations.hpp"
#include "io/face_sets.hpp"
#include "io/obj_tags.hpp"
#include "io/optional_rows.hpp"
#include "io/readers.hpp"
#include "mesh/wording.hpp"

namespace surpass::io {
namespace {

// Statements beyond these are counted together, so that a file of another kind gives few notices.
constexpr std::size_t kNamedKinds = 12;

class ObjReader {
 public:
  ObjReader(Scanner& scan, LoadedMesh& out) : scan_(scan), out_(out), mesh_(out.mesh) {}

  bool read() {
    while (!scan_.done()) {
      scan_.skip_blanks();
      if (!read_line()) return false;
    }
    return finish();
  }

 private:
  // Rows of `vt` or `vn`, and the row that each face corner names.
  struct CornerTable {
    Numbered rows;
    std::size_t width;
    std::vector<double> values = {};
    std::vector<Index> indices = {};
  };

  struct Skipped {
    std::string keyword;
    std::size_t count;
  };

  // A file's rows are much alike, so the first of them tell how many will come. What is reserved in
  // vain is never touched.
  static constexpr std::size_t kSample = 1024;
  [[nodiscard]] std::size_t rows_to_come(const char* first_row) const {
    return scan_.left() / (1 + static_cast<std::size_t>(scan_.at() - first_row) / kSample);
  }

  bool read_line();
  bool read_statement();
  bool read_vertex();
  bool read_vertex_extras();
  bool read_texture();
  bool read_normal();
  bool read_face();
  bool read_plain_face();
  bool read_corner_references();
  bool read_index(Numbered& numbered, Index& index);
  bool read_names(FaceSet::Kind kind, std::string_view keyword);
  bool read_comment();
  bool skip(std::string_view keyword);

  bool finish();
  bool check(const Numbered& numbered);
  bool take_normals_of_points();
  void finish_corners(CornerTable& table, const char* name);
  void finish_notices();

  Scanner& scan_;
  LoadedMesh& out_;
  Mesh& mesh_;
  Numbered vertices_{"vertex"};
  Numbered faces_{"face"};
  CornerTable texture_{{"texture coordinate"}, 0};
  CornerTable normal_{{"normal"}, 3};
  FaceSetBuilder sets_;
  OptionalRows colours_;
  std::size_t weighted_ = 0;
  std::vector<Skipped> skipped_;
  const char* first_skipped_ = nullptr;
  const char* first_vertex_ = nullptr;
  const char* first_face_ = nullptr;
};

bool ObjReader::read_line() {
  const char first = scan_.peek();
  const char second = scan_.peek(1);
  if (second == ' ' || second == '\t') {  // the two that nearly every line is
    if (first == 'v') {
      scan_.advance(1);
      return read_vertex();
    }
    if (first == 'f') {
      scan_.advance(1);
      return read_face();
    }
  }
  return read_statement();
}

bool ObjReader::read_statement() {
  const char* start = scan_.at();
  const std::string_view keyword = scan_.word();
  if (keyword.empty()) return scan_.peek() == '#' ? read_comment() : scan_.end_line();
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  if (keyword == "vt") return read_texture();
  if (keyword == "vn") return read_normal();
  if (keyword == "g") return read_names(FaceSet::Kind::group, keyword);
  if (keyword == "o") return read_names(FaceSet::Kind::object, keyword);
  if (keyword == "usemtl") return read_names(FaceSet::Kind::material, keyword);
  if (keyword == "s") return read_names(FaceSet::Kind::smoothing, keyword);
  if (keyword == "t") return read_obj_tag(scan_, vertices_, faces_, mesh_, out_.notices);
  if (keyword == "mtllib") {
    mesh_.material_libraries.emplace_back(scan_.rest_of_line());
    return scan_.end_line();
  }
  if (first_skipped_ == nullptr) first_skipped_ = start;
  return skip(keyword);
}

bool ObjReader::read_vertex() {
  if (vertices_.count == 0) first_vertex_ = scan_.at();
  if (vertices_.count == kSample) mesh_.points.reserve(kSample + rows_to_come(first_vertex_));
  Point point = {};
  if (!scan_.plain_decimals(point)) {
    for (std::size_t k = 0; k < 3; ++k) {
      scan_.skip_blanks();
      if (!scan_.number(point[k], kCoordinates[k])) return false;
    }
  }
  mesh_.points.push_back(point);
  ++vertices_.count;
  if (!scan_.at_line_end() && !read_vertex_extras()) return false;
  return scan_.end_line();
}

// `w`, `r g b`, or `r g b a` behind the position.
bool ObjReader::read_vertex_extras() {
  const char* start = scan_.at();
  double extras[4] = {};
  std::size_t count = 0;
  for (; count < 4 && !scan_.at_line_end(); ++count) {
    if (!scan_.number(extras[count], "a weight or colour")) return false;
  }
  if (count == 2 || !scan_.at_line_end()) {
    return scan_.fail(ErrorCode::syntax,
                      "a vertex is x y z, with a weight or a colour of 3 or 4 numbers behind; "
                      "this line has another count of numbers",
                      start);
  }
  if (count == 1) {
    if (extras[0] != 1) ++weighted_;
    return true;
  }
  colours_.add(std::span(extras, count));
  return true;
}

bool ObjReader::read_texture() {
  double row[3] = {};
  std::size_t count = 0;
  do {
    scan_.skip_blanks();
    if (!scan_.number(row[count], "a texture coordinate")) return false;
    ++count;
  } while (count < 3 && !scan_.at_line_end());
  if (count > texture_.width) {  // what earlier rows left out is 0
    std::vector<double> wider(texture_.rows.count * count, 0.0);
    for (std::size_t r = 0; r < texture_.rows.count; ++r) {
      std::copy_n(&texture_.values[r * texture_.width], texture_.width, &wider[r * count]);
    }
    texture_.values = std::move(wider);
    texture_.width = count;
  }
  texture_.values.insert(texture_.values.end(), row, row + texture_.width);
  ++texture_.rows.count;
  return scan_.end_line();
}

bool ObjReader::read_normal() {
  for (int k = 0; k < 3; ++k) {
    scan_.skip_blanks();
    if (!scan_.number(normal_.values.emplace_back(), "a normal's component")) return false;
  }
  ++normal_.rows.count;
  return scan_.end_line();
}

bool ObjReader::read_face() {
  const char* start = scan_.at();
  if (faces_.count == 0) first_face_ = start;
  if (faces_.count == kSample) {
    const std::size_t more = rows_to_come(first_face_);
    mesh_.face_offsets.reserve(1 + kSample + more);
    mesh_.face_vertices.reserve(mesh_.face_vertices.size() * (1 + more / kSample));
  }
  if (read_plain_face()) return true;
  while (!scan_.at_line_end()) {
    const char* corner = scan_.at();
    if (std::uint64_t number = 0; scan_.plain_index(number)) {
      vertices_.name_it(number - 1, corner);
      mesh_.face_vertices.push_back(static_cast<Index>(number - 1));
      continue;
    }
    Index vertex = 0;
    if (!read_index(vertices_, vertex)) return false;
    mesh_.face_vertices.push_back(vertex);
    if (scan_.peek() == '/' && !read_corner_references()) return false;
    if (!scan_.ends_word(scan_.at())) {
      const char* place = scan_.at();
      return scan_.fail(ErrorCode::syntax,
                        fmt::format("expected a blank before {}; corners are written v, v/vt, "
                                    "v//vn or v/vt/vn",
                                    quoted(scan_.word())),
                        place);
    }
  }
  if (mesh_.face_offsets.back() == mesh_.face_vertices.size()) {
    return scan_.fail(ErrorCode::syntax, "the face has no vertices; remove the line", start);
  }
  if (mesh_.face_vertices.size() >= kNone) {
    return scan_.fail(ErrorCode::too_large, "more than 4294967294 face corners", start);
  }
  mesh_.face_offsets.push_back(static_cast<Index>(mesh_.face_vertices.size()));
  ++faces_.count;
  return scan_.end_line();
}

// A face that is vertices and nothing else, in the usual way. False, and nothing is read, for
// others.
bool ObjReader::read_plain_face() {
  std::array<PlainIndex, 4> corners;
  const std::size_t count = scan_.plain_indices(corners);
  if (count == 0 || mesh_.face_vertices.size() + count >= kNone) return false;
  for (std::size_t k = 0; k < count; ++k) {
    const Index vertex = corners[k].number - 1;
    vertices_.name_it(vertex, corners[k].place);
    mesh_.face_vertices.push_back(vertex);
  }
  mesh_.face_offsets.push_back(static_cast<Index>(mesh_.face_vertices.size()));
  ++faces_.count;
  return true;
}

// `/vt`, `//vn`, `/vt/vn` behind a vertex; `/` and `//` with nothing behind are accepted.
bool ObjReader::read_corner_references() {
  const std::size_t corner = mesh_.face_vertices.size() - 1;
  for (CornerTable* table : {&texture_, &normal_}) {
    if (scan_.peek() != '/') break;
    scan_.advance(1);
    if (scan_.ends_word(scan_.at()) || scan_.peek() == '/') continue;
    Index row = 0;
    if (!read_index(table->rows, row)) return false;
    table->indices.resize(corner, kNone);
    table->indices.push_back(row);
  }
  return true;
}

// A number from 1, or from -1 backwards from the last row so far. Numbers of rows that come later
// are legal, so the upper bound is checked at the end.
bool ObjReader::read_index(Numbered& numbered, Index& index) {
  const char* start = scan_.at();
  const bool relative = scan_.peek() == '-';
  if (relative) scan_.advance(1);
  std::uint64_t number = 0;
  if (!scan_.digits(number)) {
    scan_.move_to(start);
    return scan_.fail(ErrorCode::syntax,
                      fmt::format("expected the number of a {}, but found {}", numbered.name,
                                  quoted(scan_.word())),
                      start);
  }
  if (number == 0 || (relative && number > numbered.count)) {
    return scan_.fail(ErrorCode::index_out_of_range,
                      number == 0
                          ? fmt::format("OBJ counts from 1; there is no {} 0", numbered.name)
                          : fmt::format("{} -{} is asked for, but only {} came before this line",
                                        numbered.name, number, numbered.count),
                      start);
  }
  if (number >= kNone) {
    return scan_.fail(ErrorCode::index_out_of_range,
                      fmt::format("there cannot be so many: {} {}", numbered.name,
                                  quoted({start, static_cast<std::size_t>(scan_.at() - start)})),
                      start);
  }
  number = relative ? numbered.count - number : number - 1;
  numbered.name_it(number, start);
  index = static_cast<Index>(number);
  return true;
}

bool ObjReader::read_names(FaceSet::Kind kind, std::string_view keyword) {
  std::vector<std::string_view> names;
  if (kind == FaceSet::Kind::group) {  // `g` may name several, the others take the whole line
    while (!scan_.at_line_end()) names.push_back(scan_.word());
  } else if (const std::string_view name = scan_.rest_of_line(); !name.empty()) {
    names.push_back(name);
  }
  const bool smoothing_off =
      keyword == "s" && !names.empty() && (names[0] == "off" || names[0] == "0");
  if (smoothing_off) names.clear();
  sets_.select(kind, names, mesh_.face_count());
  return scan_.end_line();
}

bool ObjReader::read_comment() {
  scan_.advance(1);
  const char* start = scan_.at();
  scan_.skip_line();
  read_annotations({start, static_cast<std::size_t>(scan_.at() - start)}, mesh_);
  return true;
}

bool ObjReader::skip(std::string_view keyword) {
  scan_.skip_statement();
  for (Skipped& known : skipped_) {
    if (known.keyword == keyword) {
      ++known.count;
      return true;
    }
  }
  if (skipped_.size() == kNamedKinds) keyword = "...";
  if (skipped_.size() > kNamedKinds) {
    ++skipped_.back().count;
  } else {
    skipped_.push_back({std::string(keyword), 1});
  }
  return true;
}

bool ObjReader::check(const Numbered& numbered) {
  if (numbered.count >= kNone) {
    return scan_.fail_as_a_whole(
        ErrorCode::too_large, fmt::format("more than 4294967294 rows of kind {}", numbered.name));
  }
  if (numbered.needed <= numbered.count) return true;
  return scan_.fail(ErrorCode::index_out_of_range,
                    fmt::format("{} {} (counted from 1) is named here, but the file has {}",
                                numbered.name, numbered.needed, numbered.count),
                    numbered.needed_at);
}

bool ObjReader::finish() {
  if (vertices_.count == 0 && first_skipped_ != nullptr) {
    return scan_.fail(ErrorCode::syntax,
                      "the file has no vertices, and this line is none of OBJ's; is it another "
                      "kind of file?",
                      first_skipped_);
  }
  if (!check(vertices_) || !check(faces_)) return false;
  for (const CornerTable* table : {&texture_, &normal_}) {  // a file without any is read without
    if (table->rows.count != 0 && !check(table->rows)) return false;
  }
  std::sort(mesh_.hole_faces.begin(), mesh_.hole_faces.end());
  mesh_.hole_faces.erase(std::unique(mesh_.hole_faces.begin(), mesh_.hole_faces.end()),
                         mesh_.hole_faces.end());
  if (colours_.complete(mesh_.points.size(), "vertices", out_.notices)) {
    mesh_.channels.push_back({"color", colours_.colour_parts(), std::move(colours_.values())});
  }
  finish_corners(texture_, "texture");
  if (!take_normals_of_points()) finish_corners(normal_, "normal");
  mesh_.face_sets = sets_.finish(mesh_.face_count());
  finish_notices();
  return true;
}

// Without faces nothing names a normal: in clouds of points, each belongs to the point of its
// number.
bool ObjReader::take_normals_of_points() {
  const std::size_t count = normal_.rows.count;
  if (mesh_.face_count() > 0 || count == 0) return false;
  if (count != mesh_.points.size()) {
    out_.notices.push_back(
        fmt::format("there are no faces to name normals, and their count ({}) is not that of the "
                    "vertices ({}): they belong to none",
                    count, mesh_.points.size()));
    return false;
  }
  mesh_.channels.push_back({"normal", {"nx", "ny", "nz"}, std::move(normal_.values)});
  return true;
}

void ObjReader::finish_corners(CornerTable& table, const char* name) {
  if (table.rows.count == 0) {
    if (table.rows.needed != 0) {
      out_.notices.push_back(fmt::format(
          "faces name {0}s, but the file has none; the {0}s are left out", table.rows.name));
    }
    return;
  }
  table.indices.resize(mesh_.face_vertices.size(), kNone);
  mesh_.corner_channels.push_back(
      {name, table.width, std::move(table.values), std::move(table.indices)});
}

void ObjReader::finish_notices() {
  if (weighted_ != 0) {
    out_.notices.push_back(fmt::format("{} a weight other than 1; positions are kept as they stand",
                                       counted(weighted_, "vertex has", "vertices have")));
  }
  for (const Skipped& skipped : skipped_) {
    out_.notices.push_back(fmt::format("{} '{}' statement{} skipped; only faces are read",
                                       skipped.count, skipped.keyword,
                                       skipped.count == 1 ? "" : "s"));
  }
}

}  // namespace

bool read_obj(Scanner& scan, LoadedMesh& out) { return ObjReader(scan, out).read(); }

}  // namespace surpass::io

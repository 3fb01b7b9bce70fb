// OFF after the Geomview manual: [ST][C][N]OFF, counts, vertices, faces. Tokens may stand on any
// lines, but what follows the vertices of a face on its line is the face's colour.
#include <algorithm>

#include <fmt/format.h>

#include "io/annotations.hpp"
#include "io/optional_rows.hpp"
#include "io/readers.hpp"

namespace surpass::io {
namespace {

class OffReader {
 public:
  OffReader(Scanner& scan, LoadedMesh& out) : scan_(scan), out_(out), mesh_(out.mesh) {}

  bool read() {
    return read_keyword() && read_counts() && read_vertices() && read_faces() && finish();
  }

 private:
  // Numbers behind the position of a vertex, and whether each is a number without sign and point.
  struct Columns {
    std::size_t width = 0;
    std::vector<double> values = {};
    bool whole = true;
  };

  void skip_head_space();
  bool read_keyword();
  bool read_counts();
  bool find_layout();
  bool read_vertices();
  bool read_columns(Columns& columns, const char* what);
  bool read_faces();
  bool read_face();
  bool read_index(Index& index);
  bool read_face_colour();
  bool finish();
  void add_channel(const char* name, std::vector<std::string> parts, Columns& columns);
  bool is_whole(const char* place) const {
    return std::all_of(place, scan_.at(), [](char c) { return c >= '0' && c <= '9'; });
  }

  Scanner& scan_;
  LoadedMesh& out_;
  Mesh& mesh_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  bool has_colours_ = false;
  bool one_line_ = false;         // numbers follow the counts on their line: lines mean nothing
  bool vertex_per_line_ = false;  // then each vertex must fill its line exactly
  Columns normals_;
  Columns colours_;
  Columns texture_;
  OptionalRows face_colours_;
  bool face_colours_whole_ = true;
};

// Annotations are looked for before the counts only.
void OffReader::skip_head_space() {
  for (;;) {
    if (!scan_.at_line_end() || scan_.done()) return;
    const char* comment = scan_.at() + 1;
    const bool is_comment = scan_.peek() == '#';
    scan_.skip_line();
    if (is_comment) {
      read_annotations({comment, static_cast<std::size_t>(scan_.at() - comment)}, mesh_);
    }
  }
}

bool OffReader::read_keyword() {
  skip_head_space();
  const char* start = scan_.at();
  const std::string_view word = scan_.word();
  const std::size_t off = word.find("OFF");
  if (off == std::string_view::npos) {  // the keyword may be missing
    scan_.move_to(start);
    const bool number = !word.empty() && word.find_first_not_of("+-0123456789") == word.npos;
    return number || scan_.fail(ErrorCode::syntax,
                                fmt::format("an OFF file begins with OFF, COFF, NOFF or the like, "
                                            "but this one with {}",
                                            quoted(word)));
  }
  std::string_view prefix = word.substr(0, off);
  const auto take = [&prefix](std::string_view letters) {
    const bool has = prefix.substr(0, letters.size()) == letters;
    if (has) prefix.remove_prefix(letters.size());
    return has;
  };
  if (take("ST")) texture_.width = 2;
  has_colours_ = take("C");
  if (take("N")) normals_.width = 3;
  if (!prefix.empty()) {
    return scan_.fail(ErrorCode::unsupported,
                      fmt::format("{} is not a surface in three dimensions; only OFF with the "
                                  "prefixes ST, C and N can be read",
                                  quoted(word)),
                      start);
  }
  scan_.move_to(start + off + 3);  // counts may follow without a blank
  scan_.skip_blanks();
  const char* next = scan_.at();
  if (scan_.word() == "BINARY") {
    return scan_.fail(ErrorCode::unsupported,
                      "binary OFF files do not tell their byte order and cannot be read; save the "
                      "mesh as text OFF or as binary PLY",
                      next);
  }
  scan_.move_to(next);
  return true;
}

bool OffReader::read_counts() {
  skip_head_space();
  if (!scan_.whole(vertices_, "the number of vertices")) return false;
  skip_head_space();
  const char* place = scan_.at();
  if (!scan_.whole(faces_, "the number of faces")) return false;
  std::uint64_t edges = 0;  // the third count says nothing; some files leave it out
  if (!scan_.at_line_end() && !scan_.whole(edges, "the number of edges")) return false;
  one_line_ = !scan_.at_line_end();
  if (vertices_ == 0) return true;
  // A vertex takes at least 6 bytes, a face 4, blanks and line ends included.
  const std::uint64_t bytes = std::uint64_t{scan_.left()} + 1;
  if (vertices_ > bytes / 6 || faces_ > (bytes - 6 * vertices_) / 4) {
    return scan_.fail(ErrorCode::unexpected_end,
                      fmt::format("{} vertices and {} faces are announced, more than the {} bytes "
                                  "that follow can hold; the file is damaged or cut off",
                                  vertices_, faces_, scan_.left()),
                      place);
  }
  if (vertices_ < kNone) return true;
  return scan_.fail(ErrorCode::too_large, "more than 4294967294 vertices", place);
}

// Colours have three or four numbers; the first vertex shows how many.
bool OffReader::find_layout() {
  scan_.skip_space();
  const char* start = scan_.at();
  std::size_t found = 0;
  for (; !scan_.at_line_end(); ++found) (void)scan_.word();
  scan_.move_to(start);
  const std::size_t expected = 3 + normals_.width + texture_.width;
  if (has_colours_) colours_.width = 4;
  if (one_line_ || found < expected) return true;
  const std::size_t more = found - expected;
  if (has_colours_ ? more != 3 && more != 4 : more != 0) {
    return scan_.fail(ErrorCode::syntax,
                      fmt::format("the vertex has {} numbers where the file's keyword asks for "
                                  "{}; COFF announces colours, NOFF normals, STOFF texture "
                                  "coordinates",
                                  found,
                                  has_colours_ ? fmt::format("{} or {}", expected + 3, expected + 4)
                                               : fmt::format("{}", expected)),
                      start);
  }
  colours_.width = more;
  vertex_per_line_ = true;
  return true;
}

bool OffReader::read_columns(Columns& columns, const char* what) {
  for (std::size_t k = 0; k < columns.width; ++k) {
    scan_.skip_space();
    const char* place = scan_.at();
    if (!scan_.number(columns.values.emplace_back(), what)) return false;
    columns.whole = columns.whole && is_whole(place);
  }
  return true;
}

bool OffReader::read_vertices() {
  if (vertices_ == 0) return true;
  if (!find_layout()) return false;
  mesh_.points.reserve(static_cast<std::size_t>(vertices_));
  for (std::uint64_t v = 0; v < vertices_; ++v) {
    Point& point = mesh_.points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      scan_.skip_space();
      if (!scan_.number(point[k], kCoordinates[k])) return false;
    }
    if (!read_columns(normals_, "a normal's component") || !read_columns(colours_, "a colour") ||
        !read_columns(texture_, "a texture coordinate")) {
      return false;
    }
    if (vertex_per_line_ && !scan_.end_line()) return false;
  }
  return true;
}

bool OffReader::read_faces() {
  if (vertices_ == 0) return true;
  mesh_.face_offsets.reserve(static_cast<std::size_t>(faces_) + 1);
  for (std::uint64_t f = 0; f < faces_; ++f) {
    if (!read_face()) return false;
  }
  return true;
}

bool OffReader::read_face() {
  scan_.skip_space();
  const char* start = scan_.at();
  std::uint64_t corners = 0;
  if (!scan_.whole(corners, "a face's number of vertices")) return false;
  if (corners == 0) {
    return scan_.fail(ErrorCode::syntax, "the face has no vertices; remove it", start);
  }
  if (corners > scan_.left() / 2) {
    return scan_.fail(ErrorCode::unexpected_end,
                      fmt::format("a face of {} vertices is announced, more than the rest of the "
                                  "file can hold; it is damaged or cut off",
                                  corners),
                      start);
  }
  for (std::uint64_t k = 0; k < corners; ++k) {
    if (!read_index(mesh_.face_vertices.emplace_back())) return false;
  }
  if (mesh_.face_vertices.size() >= kNone) {
    return scan_.fail(ErrorCode::too_large, "more than 4294967294 face corners", start);
  }
  mesh_.face_offsets.push_back(static_cast<Index>(mesh_.face_vertices.size()));
  return one_line_ || read_face_colour();
}

bool OffReader::read_index(Index& index) {
  scan_.skip_space();
  const char* start = scan_.at();
  const bool negative = scan_.peek() == '-';
  if (negative) scan_.advance(1);
  std::uint64_t number = 0;
  if (!scan_.whole(number, "a vertex of the face")) return false;
  if (negative || number >= vertices_) {
    return scan_.fail(ErrorCode::index_out_of_range,
                      fmt::format("vertex {}{} is named here, but the file has {}, counted from 0",
                                  negative ? "-" : "", number, vertices_),
                      start);
  }
  index = static_cast<Index>(number);
  return true;
}

bool OffReader::read_face_colour() {
  scan_.skip_blanks();
  const char* start = scan_.at();
  double colour[4] = {};
  std::size_t count = 0;
  for (; count < 4 && !scan_.at_line_end(); ++count) {
    const char* place = scan_.at();
    if (!scan_.number(colour[count], "a face's colour")) return false;
    face_colours_whole_ = face_colours_whole_ && is_whole(place);
  }
  if (count == 2 || !scan_.at_line_end()) {
    return scan_.fail(ErrorCode::syntax,
                      "behind the vertices of a face only a colour of 1, 3 or 4 numbers may stand",
                      start);
  }
  if (count != 0) face_colours_.add(std::span(colour, count));
  return scan_.end_line();
}

void OffReader::add_channel(const char* name, std::vector<std::string> parts, Columns& columns) {
  if (columns.width == 0) return;
  mesh_.channels.push_back({name, std::move(parts), std::move(columns.values)});
}

bool OffReader::finish() {
  scan_.skip_space();
  if (!scan_.done()) out_.notices.emplace_back("text behind the last face is not used");
  if (vertices_ == 0) return true;
  add_channel("normal", {"nx", "ny", "nz"}, normals_);
  if (colours_.width != 0) {
    OptionalRows names;  // only for the names of its columns
    names.add(std::span(colours_.values).first(colours_.width));
    add_channel("color", names.colour_parts(), colours_);
    if (colours_.whole) mesh_.channels.back().storage = Storage::uint8;
  }
  add_channel("texture", {"s", "t"}, texture_);
  if (face_colours_.complete(mesh_.face_count(), "faces", out_.notices)) {
    mesh_.face_channels.push_back({"color", face_colours_.colour_parts(),
                                   std::move(face_colours_.values()),
                                   face_colours_whole_ ? Storage::uint8 : Storage::float64});
  }
  return true;
}

}  // namespace

bool read_off(Scanner& scan, LoadedMesh& out) { return OffReader(scan, out).read(); }

}  // namespace surpass::io

#include "io/ply_header.hpp"

#include <fmt/format.h>

#include "io/annotations.hpp"
#include "io/storage.hpp"

namespace surpass::io {
namespace {

bool next_word(Scanner& scan, std::string_view& word, const char* what) {
  if (scan.at_line_end()) {
    return scan.fail(ErrorCode::syntax,
                     fmt::format("the line ends before {}; a word is missing", what));
  }
  word = scan.word();
  return true;
}

bool read_format(Scanner& scan, PlyHeader& header) {
  std::string_view name;
  std::string_view version;
  if (!next_word(scan, name, "the format's name")) return false;
  const char* place = name.data();
  if (name == "ascii") {
    header.encoding = Encoding::ascii;
  } else if (name == "binary_little_endian") {
    header.encoding = Encoding::little_endian;
  } else if (name == "binary_big_endian") {
    header.encoding = Encoding::big_endian;
  } else {
    return scan.fail(ErrorCode::syntax,
                     fmt::format("{} is no PLY format; there are ascii, binary_little_endian and "
                                 "binary_big_endian",
                                 quoted(name)),
                     place);
  }
  if (!next_word(scan, version, "the format's version")) return false;
  if (version != "1.0") {
    return scan.fail(ErrorCode::unsupported,
                     fmt::format("PLY version {} is not known, only 1.0; save the mesh again as "
                                 "PLY 1.0",
                                 quoted(version)),
                     version.data());
  }
  return true;
}

bool read_element(Scanner& scan, PlyHeader& header, const char* line) {
  std::string_view name;
  if (!next_word(scan, name, "the element's name")) return false;
  if (header.find(name) != nullptr) {
    return scan.fail(ErrorCode::syntax, fmt::format("element {} is there twice", quoted(name)),
                     line);
  }
  PlyElement& element = header.elements.emplace_back();
  element.name = name;
  element.place = line;
  scan.skip_blanks();
  return scan.whole(element.count, "the element's count");
}

bool read_type(Scanner& scan, std::string_view name, Storage& type) {
  const std::optional<Storage> known = storage_named(name);
  if (!known) {
    return scan.fail(ErrorCode::syntax,
                     fmt::format("{} is no PLY type; there are char, uchar, short, ushort, int, "
                                 "uint, float, double, and int8 to float64",
                                 quoted(name)),
                     name.data());
  }
  type = *known;
  return true;
}

bool read_property(Scanner& scan, PlyHeader& header, const char* line) {
  if (header.elements.empty()) {
    return scan.fail(ErrorCode::syntax, "a property comes before the first element", line);
  }
  PlyProperty property;
  std::string_view word;
  if (!next_word(scan, word, "the property's type")) return false;
  if (word == "list") {
    property.count_type = Storage::uint8;
    if (!next_word(scan, word, "the type of the list's length") ||
        !read_type(scan, word, *property.count_type)) {
      return false;
    }
    if (is_floating(*property.count_type)) {
      return scan.fail(ErrorCode::syntax, "the length of a list must be of a whole-number type",
                       word.data());
    }
    if (!next_word(scan, word, "the type of the list's values")) return false;
  }
  if (!read_type(scan, word, property.type)) return false;
  if (!next_word(scan, word, "the property's name")) return false;
  property.name = word;
  PlyElement& element = header.elements.back();
  if (element.find(word)) {
    return scan.fail(ErrorCode::syntax, fmt::format("property {} is there twice", quoted(word)),
                     word.data());
  }
  element.properties.push_back(std::move(property));
  return true;
}

// Sets `ended` at the end of the header.
bool read_header_line(Scanner& scan, PlyHeader& header, Mesh& mesh, bool& ended) {
  if (scan.done()) {
    return scan.fail(ErrorCode::unexpected_end,
                     "the file ends inside its header, before the line 'end_header'");
  }
  if (scan.at_line_end()) return scan.end_line();
  const char* line = scan.at();
  const std::string_view keyword = scan.word();
  if (keyword == "comment" || keyword == "obj_info") {
    const char* start = scan.at();
    scan.skip_line();
    read_annotations({start, static_cast<std::size_t>(scan.at() - start)}, mesh);
    return true;
  }
  if (keyword == "end_header") {
    ended = true;
    return scan.end_line();
  }
  if (keyword == "format") return read_format(scan, header) && scan.end_line();
  if (keyword == "element") return read_element(scan, header, line) && scan.end_line();
  if (keyword == "property") return read_property(scan, header, line) && scan.end_line();
  return scan.fail(ErrorCode::syntax,
                   fmt::format("{} is none of format, comment, element, property and end_header",
                               quoted(keyword)),
                   line);
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k].name == property) return k;
  }
  return std::nullopt;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const PlyElement& known : elements) {
    if (known.name == element) return &known;
  }
  return nullptr;
}

bool read_ply_header(Scanner& scan, PlyHeader& header, Mesh& mesh) {
  const char* start = scan.at();
  if (scan.word() != "ply") {
    return scan.fail(ErrorCode::syntax, "a PLY file begins with a line 'ply', this one does not",
                     start);
  }
  if (!scan.end_line()) return false;
  bool ended = false;
  while (!ended) {
    if (!read_header_line(scan, header, mesh, ended)) return false;
  }
  if (header.encoding == Encoding::automatic) {
    return scan.fail_as_a_whole(ErrorCode::syntax,
                                "the PLY header has no line 'format ascii 1.0' or the like");
  }
  return true;
}

}  // namespace surpass::io

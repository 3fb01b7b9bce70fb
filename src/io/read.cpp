#include <surpass/io.hpp>

#include <fmt/format.h>

#include "io/bytes.hpp"
#include "io/formats.hpp"
#include "io/readers.hpp"
#include "mesh/wording.hpp"

namespace surpass {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

bool is_utf16(std::string_view bytes) {
  return !io::is_binary_stl(bytes) &&
         (bytes.substr(0, 2) == "\xFE\xFF" || bytes.substr(0, 2) == "\xFF\xFE");
}

// What the bytes show goes before what the name says.
Result<Format> detect(std::string_view bytes, const std::string& name,
                      std::vector<std::string>& notices) {
  const Format by_name = format_of_path(name);
  const Format by_bytes = io::format_of_bytes(bytes);
  if (by_name == Format::automatic && by_bytes == Format::automatic) {
    return fail(ErrorCode::unknown_format,
                "neither the name nor the first bytes show a format that is known (OBJ, PLY, OFF, "
                "STL; XYZ by its name)",
                {.file = name});
  }
  if (by_bytes == Format::automatic) return by_name;
  if (by_name != Format::automatic && by_name != by_bytes) {
    notices.push_back(fmt::format("the name says {}, but the content is {}, and was read as such",
                                  name_of(by_name), name_of(by_bytes)));
  }
  return by_bytes;
}

bool read_format(Format format, io::Scanner& scan, LoadedMesh& out) {
  switch (format) {
    case Format::obj: return io::read_obj(scan, out);
    case Format::ply: return io::read_ply(scan, out);
    case Format::off: return io::read_off(scan, out);
    case Format::stl: return io::read_stl(scan, out);
    case Format::xyz: return io::read_xyz(scan, out);
    case Format::automatic: break;
  }
  return scan.fail_as_a_whole(ErrorCode::unknown_format, "no format is named");
}

Result<LoadedMesh> parse(std::string_view bytes, Format format, const std::string& name,
                         bool points_only) {
  if (bytes.empty()) {
    return fail(ErrorCode::unexpected_end, "the file is empty", {.file = name});
  }
  if (is_utf16(bytes)) {
    return fail(ErrorCode::unsupported, "the text is encoded in UTF-16; save it as UTF-8",
                {.file = name, .byte = 0});
  }
  LoadedMesh out;
  const bool marked = bytes.substr(0, kUtf8Mark.size()) == kUtf8Mark;
  const std::size_t skipped = marked ? kUtf8Mark.size() : 0;
  if (format == Format::automatic) {
    const Result<Format> detected = detect(bytes.substr(skipped), name, out.notices);
    if (!detected) return tl::make_unexpected(detected.error());
    format = *detected;
  }
  out.format = format;
  const bool has_comments = format == Format::obj || format == Format::off || format == Format::xyz;
  io::Scanner scan(bytes, name, has_comments ? '#' : '\n');
  scan.advance(skipped);
  if (points_only) scan.allow_not_finite();
  if (!read_format(format, scan, out)) return tl::make_unexpected(scan.error());
  if (out.mesh.points.empty()) {
    return fail(ErrorCode::empty_mesh, "there are no vertices in the file", {.file = name});
  }
  return out;
}

// What lies on faces goes with them.
void keep_points_only(LoadedMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  if (mesh.face_count() > 0) {
    loaded.notices.push_back(fmt::format("only the points are used; {} left out",
                                         counted(mesh.face_count(), "face is", "faces are")));
  }
  Mesh points;
  points.points = std::move(mesh.points);
  points.channels = std::move(mesh.channels);
  mesh = std::move(points);
}

std::string name_in_errors(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

}  // namespace

Result<LoadedMesh> parse_mesh(std::string_view bytes, Format format, const std::string& name) {
  return parse(bytes, format, name, false);
}

Result<LoadedMesh> parse_points(std::string_view bytes, Format format, const std::string& name) {
  Result<LoadedMesh> loaded = parse(bytes, format, name, true);
  if (loaded) keep_points_only(*loaded);
  return loaded;
}

Result<LoadedMesh> read_points(const std::string& path, Format format) {
  const Result<io::Bytes> bytes = io::read_bytes(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return parse_points(bytes->view(), format, name_in_errors(path));
}

Result<LoadedMesh> read_mesh(const std::string& path, Format format) {
  const Result<io::Bytes> bytes = io::read_bytes(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return parse_mesh(bytes->view(), format, name_in_errors(path));
}

Result<std::string> read_file(const std::string& path) {
  const Result<io::Bytes> bytes = io::read_bytes(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return std::string(bytes->view());
}

}  // namespace surpass

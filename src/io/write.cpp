#include <surpass/io.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "io/storage.hpp"
#include "io/writers.hpp"

namespace surpass {
namespace {

Result<void> malformed(const std::string& message) {
  return fail(ErrorCode::invalid_argument, "the mesh to be written is malformed: " + message);
}

Result<void> check_faces(const Mesh& mesh) {
  const auto& offsets = mesh.face_offsets;
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != mesh.face_vertices.size() ||
      std::adjacent_find(offsets.begin(), offsets.end(), std::greater_equal<>()) != offsets.end()) {
    return malformed("face_offsets must rise from 0 to the number of face corners, at each face");
  }
  const auto exists = [&](Index v) { return v < mesh.points.size(); };
  if (!std::all_of(mesh.face_vertices.begin(), mesh.face_vertices.end(), exists)) {
    return malformed("a face names a vertex that does not exist");
  }
  return {};
}

Result<void> check_sharpness(const Mesh& mesh) {
  const auto vertex_exists = [&](Index v) { return v < mesh.points.size(); };
  for (const Crease& crease : mesh.creases) {
    if (!vertex_exists(crease.vertices[0]) || !vertex_exists(crease.vertices[1])) {
      return malformed("a crease names a vertex that does not exist");
    }
  }
  for (const Corner& corner : mesh.corners) {
    if (!vertex_exists(corner.vertex)) {
      return malformed("a corner names a vertex that does not exist");
    }
  }
  return {};
}

Result<void> check_face_lists(const Mesh& mesh) {
  const auto face_exists = [&](Index f) { return f < mesh.face_count(); };
  if (!std::all_of(mesh.hole_faces.begin(), mesh.hole_faces.end(), face_exists)) {
    return malformed("a hole names a face that does not exist");
  }
  for (const FaceSet& set : mesh.face_sets) {
    if (!std::all_of(set.faces.begin(), set.faces.end(), face_exists)) {
      return malformed("a set of faces names a face that does not exist");
    }
  }
  return {};
}

Result<void> check_channels(const Mesh& mesh) {
  for (const Channel& channel : mesh.channels) {
    if (channel.values.size() != mesh.points.size() * channel.width()) {
      return malformed(fmt::format("channel '{}' has the wrong size", channel.name));
    }
  }
  for (const FaceChannel& channel : mesh.face_channels) {
    if (channel.values.size() != mesh.face_count() * channel.parts.size()) {
      return malformed(fmt::format("face channel '{}' has the wrong size", channel.name));
    }
  }
  for (const CornerChannel& channel : mesh.corner_channels) {
    const auto exists = [&](Index row) {
      return row == kNone || std::size_t{row} * channel.width < channel.values.size();
    };
    if (channel.width == 0 || channel.values.size() % channel.width != 0 ||
        channel.indices.size() != mesh.face_vertices.size() ||
        !std::all_of(channel.indices.begin(), channel.indices.end(), exists)) {
      return malformed(fmt::format("corner channel '{}' has the wrong size", channel.name));
    }
  }
  return {};
}

Result<void> check_finite(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    for (const double x : mesh.points[v]) {
      if (!std::isfinite(x)) {
        return fail(ErrorCode::not_finite, "a position to be written is not finite", {.vertex = v});
      }
    }
  }
  return {};
}

// Writers rely on sizes and numbers, so that a mesh put together by hand cannot lead them astray.
Result<void> check(const Mesh& mesh) {
  for (const auto& part :
       {check_faces, check_sharpness, check_face_lists, check_channels, check_finite}) {
    if (auto result = part(mesh); !result) return result;
  }
  return {};
}

Result<void> write_format(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                          io::Notes& notes) {
  switch (options.format) {
    case Format::obj: return io::write_obj(mesh, options, bytes, notes);
    case Format::ply: return io::write_ply(mesh, options, bytes, notes);
    case Format::off: return io::write_off(mesh, options, bytes, notes);
    case Format::stl: return io::write_stl(mesh, options, bytes, notes);
    case Format::xyz: return io::write_xyz(mesh, options, bytes, notes);
    case Format::automatic: break;
  }
  return fail(ErrorCode::unknown_format,
              "no format to write is known; end the name in .obj, .ply, .off or .stl, or name the "
              "format");
}

}  // namespace

Result<void> check_faces(const Mesh& mesh, Format format) {
  for (Index f = 0; format == Format::stl && f < mesh.face_count(); ++f) {
    const std::size_t corners = mesh.face(f).size();
    if (corners == 3) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("STL holds triangles only, and this face has {} corners; "
                            "write triangles, or another format",
                            corners),
                {.face = f});
  }
  return {};
}

Result<std::vector<std::string>> format_mesh(const Mesh& mesh, const WriteOptions& options,
                                             std::string& bytes) {
  io::Notes notes;
  if (auto checked = check(mesh); !checked) return tl::make_unexpected(checked.error());
  if (auto done = write_format(mesh, options, bytes, notes); !done) {
    return tl::make_unexpected(done.error());
  }
  return notes;
}

Result<std::vector<std::string>> write_mesh(const Mesh& mesh, const std::string& path,
                                            const WriteOptions& options) {
  WriteOptions named = options;
  if (named.format == Format::automatic) named.format = format_of_path(path);
  std::string bytes;
  Result<std::vector<std::string>> notes = format_mesh(mesh, named, bytes);
  if (!notes) {
    Error error = notes.error();
    error.place.file = path;
    return tl::make_unexpected(std::move(error));
  }
  if (auto written = write_file(path, bytes); !written) {
    return tl::make_unexpected(written.error());
  }
  return notes;
}

bool rounds_positions(Format format, bool single_precision) {
  return format == Format::stl || (format == Format::ply && single_precision);
}

std::vector<Point> stored_positions(std::span<const Point> points, Format format,
                                    bool single_precision) {
  std::vector<Point> stored(points.begin(), points.end());
  if (!rounds_positions(format, single_precision)) return stored;
  for (Point& point : stored) {
    for (double& x : point) x = io::rounded_to_float(x);
  }
  return stored;
}

}  // namespace surpass

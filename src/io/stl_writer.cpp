#include <algorithm>
#include <cmath>

#include "io/annotations.hpp"
#include "io/stl_format.hpp"
#include "io/storage.hpp"
#include "io/text.hpp"
#include "io/writers.hpp"

namespace surpass::io {
namespace {

constexpr const char* kStl = "STL";

using Triangle = std::array<std::array<float, 3>, 3>;

Triangle triangle_of(const Mesh& mesh, Index f) {
  Triangle triangle = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& point = mesh.points[mesh.face(f)[k]];
    for (std::size_t d = 0; d < 3; ++d) triangle[k][d] = static_cast<float>(point[d]);
  }
  return triangle;
}

// Zero where the triangle has no area.
std::array<float, 3> normal_of(const Mesh& mesh, Index f) {
  const std::span<const Index> face = mesh.face(f);
  const Point& a = mesh.points[face[0]];
  const Point& b = mesh.points[face[1]];
  const Point& c = mesh.points[face[2]];
  const double longest = bounding_box(std::array{a, b, c}).side();  // keeps products in range
  if (longest == 0) return {};
  Point u = {};
  Point v = {};
  for (std::size_t d = 0; d < 3; ++d) {
    u[d] = b[d] / longest - a[d] / longest;
    v[d] = c[d] / longest - a[d] / longest;
  }
  const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

void write_binary(const Mesh& mesh, const std::string& annotation, std::string& out) {
  std::string header =
      annotation.empty() ? "binary STL, lengths in the model's own unit" : annotation;
  header.resize(stl::kHeader, '\0');
  out += header;
  append(out, static_cast<std::uint32_t>(mesh.face_count()), stl::kSwap);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (const float x : normal_of(mesh, f)) append(out, x, stl::kSwap);
    for (const auto& corner : triangle_of(mesh, f)) {
      for (const float x : corner) append(out, x, stl::kSwap);
    }
    append(out, std::uint16_t{0}, stl::kSwap);
  }
}

// Digits of the float's value as a double: every reader, of floats or doubles, finds the same.
void append_facet(const Mesh& mesh, Index f, std::string& out) {
  out += "facet normal";
  for (const float x : normal_of(mesh, f)) append_spaced(out, x);
  out += "\nouter loop\n";
  for (const Index v : mesh.face(f)) {
    out += "vertex";
    for (const double x : mesh.points[v]) append_spaced(out, rounded_to_float(x));
    out += '\n';
  }
  out += "endloop\nendfacet\n";
}

// The name of the solid that each face belongs to, if the mesh's objects can be solids: named so
// that a line holds it, and no face in two of them.
std::vector<std::string_view> solid_names(const Mesh& mesh, Notes& notes) {
  std::vector<std::string_view> names(mesh.face_count());
  for (const FaceSet& set : mesh.face_sets) {
    bool held = set.kind == FaceSet::Kind::object &&
                set.name.find_first_of("\r\n\\\t") == set.name.npos &&
                set.name.find_first_not_of(' ') == 0 && set.name.back() != ' ';
    for (const Index f : set.faces) held = held && names[f].empty();
    if (!held) {
      note_lost(kStl, "set of faces", set.name, notes);
      continue;
    }
    for (const Index f : set.faces) names[f] = set.name;
  }
  return names;
}

void write_text(const Mesh& mesh, const std::string& annotation,
                const std::vector<std::string_view>& names, std::string& out) {
  const auto open = [&](std::string_view name) {
    out += "solid ";
    out += name.empty() ? annotation : name;
    out += '\n';
  };
  open(names.empty() ? std::string_view() : names.front());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (f > 0 && names[f] != names[f - 1]) {
      out += "endsolid\n";
      open(names[f]);
    }
    append_facet(mesh, f, out);
  }
  out += "endsolid\n";
}

Result<void> check_positions(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    for (const double x : mesh.points[v]) {
      if (std::isfinite(static_cast<float>(x))) continue;
      return fail(ErrorCode::unsuitable_for_scheme,
                  "the position is too large for STL's 32-bit numbers; scale the mesh down",
                  {.vertex = v});
    }
  }
  return {};
}

void note_isolated(const Mesh& mesh, Notes& notes) {
  std::vector<bool> used(mesh.points.size());
  for (const Index v : mesh.face_vertices) used[v] = true;
  std::size_t isolated = 0;
  for (const bool is_used : used) isolated += is_used ? 0 : 1;
  if (isolated != 0) {
    notes.push_back(fmt::format("STL holds no vertices without faces; {} left out", isolated));
  }
}

void note_channels(const Mesh& mesh, Notes& notes) {
  for (const Channel& channel : mesh.channels) note_lost(kStl, "channel", channel.name, notes);
  for (const CornerChannel& channel : mesh.corner_channels) {
    note_lost(kStl, "corner channel", channel.name, notes);
  }
  for (const FaceChannel& channel : mesh.face_channels) {
    note_lost(kStl, "face channel", channel.name, notes);
  }
  note_isolated(mesh, notes);
}

}  // namespace

Result<void> write_stl(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                       Notes& notes) {
  if (auto triangles = check_faces(mesh, Format::stl); !triangles) return triangles;
  if (auto positions = check_positions(mesh); !positions) return positions;
  const bool text = options.encoding == Encoding::ascii;
  std::string annotation = annotation_comment(mesh, notes);
  std::vector<std::string_view> names;
  if (text) names = solid_names(mesh, notes);
  const bool has_name = !names.empty() && std::any_of(names.begin(), names.end(),
                                                      [](auto name) { return !name.empty(); });
  const bool held = !has_name && annotation.size() <= stl::kHeader;
  if (!held) annotation.clear();
  note_losses(mesh, {.format = kStl, .face_sets = text, .annotations = held}, notes);
  note_channels(mesh, notes);
  if (text) {
    write_text(mesh, annotation, names, bytes);
  } else {
    write_binary(mesh, annotation, bytes);
  }
  return {};
}

}  // namespace surpass::io

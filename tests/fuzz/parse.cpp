#include "fuzz/parse.hpp"

namespace surpass {
namespace {

std::string complaint_about_error(const Error& error, std::string_view bytes) {
  if (error.message.empty()) return "an error without a sentence";
  if (error.place.file != "fuzz") return "an error without a file";
  if (error.place.byte && *error.place.byte > bytes.size()) return "an error beyond the file";
  if (error.place.column && *error.place.column > bytes.size() + 1)
    return "a column beyond the file";
  return {};
}

std::string complaint_about_round_trip(const Mesh& mesh, Format format) {
  std::string first;
  if (!format_mesh(mesh, {.format = format}, first)) return "a mesh that was read is not written";
  const auto again = parse_mesh(first, format, "again");
  if (!again) return "a written mesh is refused: " + describe(again.error());
  if (again->mesh.points != mesh.points) return "positions change";
  if (again->mesh.face_vertices != mesh.face_vertices) return "faces change";
  if (again->mesh.face_offsets != mesh.face_offsets) return "polygons change";
  std::string second;
  if (!format_mesh(again->mesh, {.format = format}, second)) return "the second writing fails";
  return first == second ? "" : "the second writing differs from the first";
}

}  // namespace

std::string complaint_about(std::string_view bytes, Format format) {
  const auto loaded = parse_mesh(bytes, format, "fuzz");
  if (!loaded) return complaint_about_error(loaded.error(), bytes);
  for (const Format target : {Format::ply, Format::obj}) {
    const std::string complaint = complaint_about_round_trip(loaded->mesh, target);
    if (!complaint.empty()) return std::string(name_of(target)) + ": " + complaint;
  }
  return {};
}

}  // namespace surpass

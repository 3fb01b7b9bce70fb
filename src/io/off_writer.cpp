#include "io/annotations.hpp"
#include "io/storage.hpp"
#include "io/text.hpp"
#include "io/writers.hpp"

namespace surpass::io {
namespace {

constexpr const char* kOff = "OFF";

// The reader tells whole-number colours (0 to 255) from fractions (0 to 1) by the point.
void append_colour(std::string& out, double value, bool whole) {
  const std::size_t start = out.size() + 1;
  append_spaced(out, value);
  if (!whole && out.find_first_of(".e", start) == out.npos) out += ".0";
}

template <class AnyChannel>
bool is_whole_colour(const AnyChannel& channel) {
  return channel.storage == Storage::uint8 && fits(channel.values, Storage::uint8);
}

struct Columns {
  const Channel* normal = nullptr;
  const Channel* colour = nullptr;
  const Channel* texture = nullptr;
};

void append_row(std::string& out, const Channel* channel, std::size_t row) {
  if (channel == nullptr) return;
  const std::size_t width = channel->width();
  for (std::size_t k = 0; k < width; ++k) append_spaced(out, channel->values[row * width + k]);
}

Columns choose_columns(const Mesh& mesh, Notes& notes) {
  const Columns columns = {find_channel(mesh, "normal", 3, 3), find_channel(mesh, "color", 3, 4),
                           find_channel(mesh, "texture", 2, 2)};
  for (const Channel& channel : mesh.channels) {
    const bool held =
        &channel == columns.normal || &channel == columns.colour || &channel == columns.texture;
    if (!held) note_lost(kOff, "channel", channel.name, notes);
  }
  return columns;
}

const FaceChannel* choose_face_colour(const Mesh& mesh, Notes& notes) {
  const FaceChannel* chosen = nullptr;
  for (const FaceChannel& channel : mesh.face_channels) {
    const bool colour =
        channel.name == "color" && (channel.parts.size() == 3 || channel.parts.size() == 4);
    if (colour && chosen == nullptr) {
      chosen = &channel;
    } else {
      note_lost(kOff, "face channel", channel.name, notes);
    }
  }
  return chosen;
}

void write_vertices(const Mesh& mesh, const Columns& columns, std::string& out) {
  const bool whole = columns.colour != nullptr && is_whole_colour(*columns.colour);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append_number(out, mesh.points[v][0]);
    append_spaced(out, mesh.points[v][1]);
    append_spaced(out, mesh.points[v][2]);
    append_row(out, columns.normal, v);
    const std::size_t width = columns.colour == nullptr ? 0 : columns.colour->width();
    for (std::size_t k = 0; k < width; ++k) {
      append_colour(out, columns.colour->values[v * width + k], whole);
    }
    append_row(out, columns.texture, v);
    out += '\n';
  }
}

void write_faces(const Mesh& mesh, const FaceChannel* colour, std::string& out) {
  const bool whole = colour != nullptr && is_whole_colour(*colour);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const std::span<const Index> face = mesh.face(f);
    append_number(out, face.size());
    for (const Index v : face) append_spaced(out, v);
    const std::size_t width = colour == nullptr ? 0 : colour->parts.size();
    for (std::size_t k = 0; k < width; ++k) {
      append_colour(out, colour->values[f * width + k], whole);
    }
    out += '\n';
  }
}

}  // namespace

Result<void> write_off(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                       Notes& notes) {
  note_losses(mesh, {.format = kOff}, notes);
  for (const CornerChannel& channel : mesh.corner_channels) {
    note_lost(kOff, "corner channel", channel.name, notes);
  }
  const Columns columns = choose_columns(mesh, notes);
  const FaceChannel* face_colour = choose_face_colour(mesh, notes);
  bytes += columns.texture != nullptr ? "ST" : "";
  bytes += columns.colour != nullptr ? "C" : "";
  bytes += columns.normal != nullptr ? "N" : "";
  bytes += "OFF\n";
  append_comment(bytes, "#", annotation_comment(mesh, notes));
  for (const std::string& comment : options.comments) append_comment(bytes, "#", comment);
  bytes += fmt::format("{} {} 0\n", mesh.points.size(), mesh.face_count());
  write_vertices(mesh, columns, bytes);
  write_faces(mesh, face_colour, bytes);
  return {};
}

}  // namespace surpass::io

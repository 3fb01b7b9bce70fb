// XYZ: a line a point, x y z and, where there are normals, nx ny nz, then red green blue.
#include <fmt/format.h>

#include "io/text.hpp"
#include "io/writers.hpp"

namespace surpass::io {

Result<void> write_xyz(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                       Notes& notes) {
  note_losses(mesh, {.format = "XYZ", .annotations = false}, notes);
  if (mesh.face_count() > 0) {
    notes.push_back(fmt::format("XYZ has no place for faces; {} left out", mesh.face_count()));
  }
  const Channel* written[] = {find_channel(mesh, "normal", 3, 3),
                              find_channel(mesh, "color", 3, 4)};
  for (const Channel& channel : mesh.channels) {
    if (&channel != written[0] && &channel != written[1]) {
      note_lost("XYZ", "channel", channel.name, notes);
    }
  }
  if (written[1] != nullptr && written[1]->width() == 4) {
    notes.emplace_back("XYZ has no place for the alpha of colours; it is left out");
  }
  for (const std::string& line : options.comments) append_comment(bytes, "#", line);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append_number(bytes, mesh.points[v][0]);
    append_spaced(bytes, mesh.points[v][1]);
    append_spaced(bytes, mesh.points[v][2]);
    for (const Channel* channel : written) {
      for (std::size_t k = 0; channel != nullptr && k < 3; ++k) {
        append_spaced(bytes, channel->values[channel->width() * v + k]);
      }
    }
    bytes += '\n';
  }
  return {};
}

}  // namespace surpass::io

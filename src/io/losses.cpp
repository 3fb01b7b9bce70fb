#include <fmt/format.h>

#include "io/writers.hpp"

namespace surpass::io {

const Channel* find_channel(const Mesh& mesh, std::string_view name, std::size_t least_width,
                            std::size_t most_width) {
  for (const Channel& channel : mesh.channels) {
    if (channel.name == name && channel.width() >= least_width && channel.width() <= most_width) {
      return &channel;
    }
  }
  return nullptr;
}

void note_lost(const char* format, const char* kind, const std::string& name, Notes& notes) {
  notes.push_back(
      fmt::format("{} has no place for the {} '{}'; it is left out", format, kind, name));
}

void note_losses(const Mesh& mesh, const Holds& holds, Notes& notes) {
  const auto note = [&](bool held, std::size_t count, const char* what) {
    if (held || count == 0) return;
    notes.push_back(fmt::format("{} has no place for {}; {} left out", holds.format, what, count));
  };
  note(holds.sharpness, mesh.creases.size(), "creases");
  note(holds.sharpness, mesh.corners.size(), "sharp corners");
  if (!holds.holes && !mesh.hole_faces.empty()) {
    notes.push_back(fmt::format("{} has no place for hole faces; {} are like other faces there",
                                holds.format, mesh.hole_faces.size()));
  }
  note(holds.tags, mesh.tags.size(), "OpenSubdiv's tags");
  note(holds.face_sets, mesh.face_sets.size(), "groups, objects and materials");
  note(holds.materials, mesh.material_libraries.size(), "material libraries");
  note(holds.annotations, mesh.annotations.size(), "scheme and boundary beside solid names");
}

}  // namespace surpass::io

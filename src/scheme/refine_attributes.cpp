#include "scheme/refine_attributes.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "scheme/sharpness.hpp"

namespace surpass {

void inherit_creases(const Mesh& mesh, const Topology& topology, Mesh& refined) {
  const Index n = topology.vertex_count();
  for (const Crease& crease : mesh.creases) {
    const float sharpness = child_sharpness(crease.sharpness);
    const auto [a, b] = crease.vertices;
    const Index middle = n + topology.find_edge(a, b);
    if (sharpness <= 0) continue;
    refined.creases.push_back({{a, middle}, sharpness});
    refined.creases.push_back({{b, middle}, sharpness});
  }
  for (const Corner& corner : mesh.corners) {
    const float sharpness = child_sharpness(corner.sharpness);
    if (sharpness > 0) refined.corners.push_back({corner.vertex, sharpness});
  }
  refined.tags = mesh.tags;
  refined.annotations = mesh.annotations;
  refined.material_libraries = mesh.material_libraries;
}

void inherit_face_attributes(const Mesh& mesh, const std::vector<Index>& children, Mesh& refined) {
  std::vector<Index> first(children.size() + 1, 0);
  std::partial_sum(children.begin(), children.end(), first.begin() + 1);
  const auto expand = [&](const std::vector<Index>& faces) {
    std::vector<Index> expanded;
    for (const Index f : faces) {
      for (Index c = first[f]; c < first[f + 1]; ++c) expanded.push_back(c);
    }
    return expanded;
  };
  refined.hole_faces = expand(mesh.hole_faces);
  for (const FaceSet& set : mesh.face_sets) {
    refined.face_sets.push_back({set.kind, set.name, expand(set.faces)});
  }
  for (const FaceChannel& channel : mesh.face_channels) {
    FaceChannel& out = refined.face_channels.emplace_back(
        FaceChannel{channel.name, channel.parts, {}, channel.storage});
    const std::size_t width = channel.parts.size();
    for (std::size_t f = 0; f < children.size(); ++f) {
      const auto row = channel.values.begin() + static_cast<std::ptrdiff_t>(f * width);
      for (Index c = 0; c < children[f]; ++c) {
        out.values.insert(out.values.end(), row, row + static_cast<std::ptrdiff_t>(width));
      }
    }
  }
}

void refine_corner_channels_of_triangles(const Mesh& mesh, Mesh& refined) {
  for (const CornerChannel& channel : mesh.corner_channels) {
    CornerChannel& out = refined.corner_channels.emplace_back(channel);
    out.indices.clear();
    out.indices.reserve(4 * channel.indices.size());
    std::unordered_map<std::uint64_t, Index> middles;
    const auto middle = [&](Index a, Index b) {
      if (a == kNone || b == kNone) return kNone;
      const auto key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
      const auto next = static_cast<Index>(out.values.size() / channel.width);
      const auto [at, added] = middles.try_emplace(key, next);
      for (std::size_t c = 0; added && c < channel.width; ++c) {
        out.values.push_back(
            (channel.values[a * channel.width + c] + channel.values[b * channel.width + c]) / 2);
      }
      return at->second;
    };
    for (std::size_t h = 0; h < channel.indices.size(); h += 3) {
      const Index* i = channel.indices.data() + h;
      const Index m[3] = {middle(i[0], i[1]), middle(i[1], i[2]), middle(i[2], i[0])};
      out.indices.insert(out.indices.end(), {i[0], m[0], m[2], m[0], i[1], m[1],  //
                                             m[2], m[1], i[2], m[0], m[1], m[2]});
    }
  }
}

}  // namespace surpass

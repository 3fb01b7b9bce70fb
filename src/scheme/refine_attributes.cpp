#include "scheme/refine_attributes.hpp"

#include <algorithm>
#include <array>
#include <span>
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

void inherit_face_attributes(const Mesh& mesh, const std::function<Index(Index f)>& first_child,
                             Mesh& refined) {
  const auto expand = [&](const std::vector<Index>& faces) {
    std::vector<Index> expanded;
    for (const Index f : faces) {
      for (Index c = first_child(f); c < first_child(f + 1); ++c) expanded.push_back(c);
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
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto row = channel.values.begin() + static_cast<std::ptrdiff_t>(f * width);
      for (Index c = first_child(f); c < first_child(f + 1); ++c) {
        out.values.insert(out.values.end(), row, row + static_cast<std::ptrdiff_t>(width));
      }
    }
  }
}

namespace {

// Rows of a corner channel that are means of given rows; corners that have no value give none.
class MeanRows {
 public:
  explicit MeanRows(CornerChannel& channel) : channel_(channel) {}

  /// The middle of two rows, the same whenever they come together again.
  Index middle(Index a, Index b) {
    if (a == kNone || b == kNone) return kNone;
    const auto key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, added] = middles_.try_emplace(key, 0);
    if (added) {
      const std::array<Index, 2> both = {a, b};
      at->second = mean(both);
    }
    return at->second;
  }

  Index mean(std::span<const Index> rows) {
    if (std::find(rows.begin(), rows.end(), kNone) != rows.end()) return kNone;
    std::vector<double>& values = channel_.values;
    const std::size_t width = channel_.width;
    const std::size_t next = values.size() / width;
    for (std::size_t c = 0; c < width; ++c) {
      double sum = 0;
      for (const Index row : rows) sum += values[row * width + c];
      values.push_back(sum / static_cast<double>(rows.size()));
    }
    return static_cast<Index>(next);
  }

 private:
  CornerChannel& channel_;
  std::unordered_map<std::uint64_t, Index> middles_;
};

}  // namespace

void refine_corner_channels_of_triangles(const Mesh& mesh, Mesh& refined) {
  for (const CornerChannel& channel : mesh.corner_channels) {
    CornerChannel& out = refined.corner_channels.emplace_back(channel);
    out.indices.clear();
    out.indices.reserve(4 * channel.indices.size());
    MeanRows rows(out);
    for (std::size_t h = 0; h < channel.indices.size(); h += 3) {
      const Index* i = channel.indices.data() + h;
      const Index m[3] = {rows.middle(i[0], i[1]), rows.middle(i[1], i[2]),
                          rows.middle(i[2], i[0])};
      out.indices.insert(out.indices.end(), {i[0], m[0], m[2], m[0], i[1], m[1],  //
                                             m[2], m[1], i[2], m[0], m[1], m[2]});
    }
  }
}

void refine_corner_channels_to_quads(const Mesh& mesh, Mesh& refined) {
  for (const CornerChannel& channel : mesh.corner_channels) {
    CornerChannel& out = refined.corner_channels.emplace_back(channel);
    out.indices.clear();
    out.indices.reserve(4 * channel.indices.size());
    MeanRows rows(out);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Index begin = mesh.face_offsets[f];
      const std::span corners =
          std::span(channel.indices).subspan(begin, mesh.face_offsets[f + 1] - begin);
      const std::size_t m = corners.size();
      const Index center = rows.mean(corners);
      for (std::size_t j = 0; j < m; ++j) {
        const Index before = rows.middle(corners[(j + m - 1) % m], corners[j]);
        const Index after = rows.middle(corners[j], corners[(j + 1) % m]);
        out.indices.insert(out.indices.end(), {corners[j], after, center, before});
      }
    }
  }
}

}  // namespace surpass

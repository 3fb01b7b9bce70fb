#include "interpolate/dummy_ring.hpp"

#include <utility>

#include "mesh/select.hpp"

namespace surpass {
namespace {

// Faces without corner rows, and with what the face beside them has.
void extend_attributes(Mesh& mesh, const std::vector<Index>& beside) {
  for (CornerChannel& channel : mesh.corner_channels) {
    channel.indices.resize(channel.indices.size() + 4 * beside.size(), kNone);
  }
  for (FaceChannel& channel : mesh.face_channels) {
    const std::size_t width = channel.parts.size();
    for (const Index f : beside) {
      for (std::size_t c = 0; c < width; ++c)
        channel.values.push_back(channel.values[f * width + c]);
    }
  }
}

// The sharpness of the only crease that leads from each vertex into the surface, or 0.
std::vector<float> lone_creases(const Mesh& given, const Topology& topology) {
  std::vector<float> found(given.points.size(), 0.0F);
  std::vector<unsigned char> count(given.points.size(), 0);
  std::vector<std::pair<Index, float>> sharp;  // by edge; the last of several holds
  for (const Crease& crease : given.creases) {
    const auto [a, b] = crease.vertices;
    if (a >= found.size() || b >= found.size()) continue;
    const Index e = topology.find_edge(a, b);
    if (e != kNone && !topology.is_boundary_edge(e)) sharp.emplace_back(e, crease.sharpness);
  }
  std::stable_sort(sharp.begin(), sharp.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < sharp.size(); ++i) {
    if (i + 1 < sharp.size() && sharp[i + 1].first == sharp[i].first) continue;
    if (!(sharp[i].second > 0)) continue;
    for (const Index v : topology.edge_vertices(sharp[i].first)) {
      found[v] = count[v] == 0 ? sharp[i].second : 0.0F;
      count[v] = 1;
    }
  }
  return found;
}

}  // namespace

ExtendedMesh with_dummy_ring(const Mesh& given, const Topology& topology) {
  ExtendedMesh extended{given, {}};
  Mesh& mesh = extended.mesh;
  mesh.channels.clear();
  const std::vector<float> creases = lone_creases(given, topology);
  std::vector<Index> beside;
  for (const std::vector<Index>& loop : boundary_loops(topology)) {
    const auto first = static_cast<Index>(mesh.points.size());
    for (const Index h : loop) {
      const Index v = topology.tail(h);
      const auto dummy = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(given.points[v]);
      extended.at.push_back(v);
      if (creases[v] > 0) mesh.creases.push_back({{v, dummy}, creases[v]});
    }
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index dummy = first + static_cast<Index>(k);
      const Index next = first + static_cast<Index>((k + 1) % loop.size());
      mesh.add_face(std::array{topology.head(loop[k]), topology.tail(loop[k]), dummy, next});
      beside.push_back(topology.face(loop[k]));
    }
  }
  extend_attributes(mesh, beside);
  return extended;
}

DummyParts without_outer_ring(Mesh refined, const Mesh& given) {
  // Corner c of the extended mesh has become face c; of a dummy face, two corners are given.
  const Index surface = given.corner_count();
  const std::vector<Index> own_holes = std::exchange(refined.hole_faces, {});
  for (Index f = surface; f < refined.face_count(); ++f) {
    if ((f - surface) % 4 >= 2) refined.hole_faces.push_back(f);
  }
  Selection selection = visible_part(refined, given.vertex_count());
  refined.hole_faces = own_holes;
  DummyParts parts;
  parts.kept = selection.vertex_source;
  parts.mesh = select(refined, std::move(selection));
  parts.sampled.assign(parts.mesh.face_count(), 0);
  for (Index f = 0; f < parts.mesh.face_count(); ++f) {
    parts.sampled[f] = f < surface ? 1 : 0;
    if (f >= surface) parts.mesh.hole_faces.push_back(f);
  }
  return parts;
}

}  // namespace surpass

#include "mesh/select.hpp"

#include <algorithm>
#include <numeric>

namespace surpass {
namespace {

using Edge = std::array<Index, 2>;

Edge sorted_edge(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// The rows of a table of the given width, in the order of `source`.
std::vector<double> rows(const std::vector<double>& values, std::size_t width,
                         const std::vector<Index>& source) {
  std::vector<double> chosen;
  chosen.reserve(source.size() * width);
  for (const Index row : source) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(row * width);
    chosen.insert(chosen.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
  }
  return chosen;
}

// Lists of old faces, ascending, turned into lists of the new faces that come from them.
class FaceLists {
 public:
  FaceLists(Index old_faces, const std::vector<Index>& face_source)
      : begin_(static_cast<std::size_t>(old_faces) + 1, 0) {
    for (const Index f : face_source) ++begin_[f + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  }
  [[nodiscard]] std::vector<Index> follow(const std::vector<Index>& old) const {
    std::vector<Index> faces;
    for (const Index f : old) {
      if (f + std::size_t{1} >= begin_.size()) continue;
      for (Index g = begin_[f]; g < begin_[f + 1]; ++g) faces.push_back(g);
    }
    return faces;
  }

 private:
  std::vector<Index> begin_;  // the new faces of f are begin_[f]..begin_[f + 1], as they ascend
};

// The new edges with a copied end, each with the old edge that it was.
struct CopiedEdge {
  Edge old;
  Edge now;
  bool operator==(const CopiedEdge&) const = default;
  bool operator<(const CopiedEdge& other) const {
    return old != other.old ? old < other.old : now < other.now;
  }
};

bool is_copy(const Selection& s, Index v) { return s.vertex_image[s.vertex_source[v]] != v; }

std::vector<CopiedEdge> copied_edges(const Selection& s) {
  std::vector<CopiedEdge> edges;
  for (std::size_t f = 0; f + 1 < s.face_offsets.size(); ++f) {
    Index a = s.face_vertices[s.face_offsets[f + 1] - 1];
    for (Index c = s.face_offsets[f]; c < s.face_offsets[f + 1]; ++c) {
      const Index b = s.face_vertices[c];
      if (is_copy(s, a) || is_copy(s, b)) {
        edges.push_back({sorted_edge(s.vertex_source[a], s.vertex_source[b]), sorted_edge(a, b)});
      }
      a = b;
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Crease> follow_creases(const Mesh& mesh, const Selection& s) {
  std::vector<Crease> creases;
  if (mesh.creases.empty()) return creases;
  const auto copied = copied_edges(s);
  for (const Crease& crease : mesh.creases) {
    const auto [a, b] = crease.vertices;
    if (a >= s.vertex_image.size() || b >= s.vertex_image.size()) continue;
    const Edge now = {s.vertex_image[a], s.vertex_image[b]};
    if (now[0] != kNone && now[1] != kNone && now[0] != now[1]) {
      creases.push_back({now, crease.sharpness});
    }
    const Edge old = sorted_edge(a, b);
    for (auto e = std::lower_bound(copied.begin(), copied.end(), CopiedEdge{old, {0, 0}});
         e != copied.end() && e->old == old; ++e) {
      creases.push_back({e->now, crease.sharpness});
    }
  }
  return creases;
}

std::vector<Corner> follow_corners(const Mesh& mesh, const Selection& s) {
  std::vector<Corner> corners;
  if (mesh.corners.empty()) return corners;
  std::vector<Edge> copies;  // old vertex, its copy
  for (Index v = 0; v < s.vertex_source.size(); ++v) {
    if (is_copy(s, v)) copies.push_back({s.vertex_source[v], v});
  }
  std::sort(copies.begin(), copies.end());
  for (const Corner& corner : mesh.corners) {
    if (corner.vertex >= s.vertex_image.size()) continue;
    const Index now = s.vertex_image[corner.vertex];
    if (now != kNone) corners.push_back({now, corner.sharpness});
    for (auto c = std::lower_bound(copies.begin(), copies.end(), Edge{corner.vertex, 0});
         c != copies.end() && (*c)[0] == corner.vertex; ++c) {
      corners.push_back({(*c)[1], corner.sharpness});
    }
  }
  return corners;
}

}  // namespace

Selection Selection::of_all_vertices(const Mesh& mesh) {
  Selection s;
  s.vertex_image.resize(mesh.points.size());
  std::iota(s.vertex_image.begin(), s.vertex_image.end(), Index{0});
  s.vertex_source = s.vertex_image;
  s.face_source.reserve(mesh.face_count());
  s.face_offsets.reserve(mesh.face_offsets.size());
  s.corner_source.reserve(mesh.face_vertices.size());
  s.face_vertices.reserve(mesh.face_vertices.size());
  return s;
}

Selection Selection::of_vertices(const std::vector<unsigned char>& used) {
  Selection s;
  s.vertex_image.assign(used.size(), kNone);
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] != 0) s.vertex_image[v] = s.add_copy(v);
  }
  return s;
}

Index Selection::add_copy(Index v) {
  vertex_source.push_back(v);
  return static_cast<Index>(vertex_source.size() - 1);
}

Mesh select(const Mesh& mesh, Selection s) {
  Mesh out;
  out.points.reserve(s.vertex_source.size());
  for (const Index v : s.vertex_source) out.points.push_back(mesh.points[v]);
  out.creases = follow_creases(mesh, s);
  out.corners = follow_corners(mesh, s);

  const FaceLists lists(mesh.face_count(), s.face_source);
  out.hole_faces = lists.follow(mesh.hole_faces);
  for (const FaceSet& set : mesh.face_sets) {
    out.face_sets.push_back({set.kind, set.name, lists.follow(set.faces)});
  }
  out.channels = mesh.channels;
  for (Channel& c : out.channels) c.values = rows(c.values, c.width(), s.vertex_source);
  out.face_channels = mesh.face_channels;
  for (FaceChannel& c : out.face_channels) c.values = rows(c.values, c.parts.size(), s.face_source);
  for (const CornerChannel& c : mesh.corner_channels) {
    CornerChannel& to =
        out.corner_channels.emplace_back(CornerChannel{c.name, c.width, c.values, {}});
    to.indices.reserve(s.corner_source.size());
    for (const Index corner : s.corner_source) to.indices.push_back(c.indices[corner]);
  }
  out.material_libraries = mesh.material_libraries;
  out.tags = mesh.tags;
  out.annotations = mesh.annotations;
  out.face_offsets = std::move(s.face_offsets);
  out.face_vertices = std::move(s.face_vertices);
  return out;
}

}  // namespace surpass

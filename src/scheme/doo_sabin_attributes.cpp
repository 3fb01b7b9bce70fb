#include "scheme/doo_sabin_attributes.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>

#include "scheme/sharpness.hpp"

namespace surpass::doo_sabin {
namespace {

std::span<const NewCorner> corners_of(const NewFaces& faces, Index f) {
  return std::span(faces.corners).subspan(faces.offsets[f], faces.size(f));
}

// Numbers of the face sets that a face is in, ascending.
std::vector<std::vector<Index>> sets_of_faces(const Mesh& mesh) {
  std::vector<std::vector<Index>> sets(mesh.face_count());
  for (Index s = 0; s < mesh.face_sets.size(); ++s) {
    for (const Index f : mesh.face_sets[s].faces) sets[f].push_back(s);
  }
  return sets;
}

void inherit_face_sets(const Mesh& mesh, const Topology& topology, const NewFaces& faces,
                       Mesh& refined) {
  for (const FaceSet& set : mesh.face_sets) refined.face_sets.push_back({set.kind, set.name, {}});
  if (mesh.face_sets.empty()) return;
  const auto sets = sets_of_faces(mesh);
  for (Index f = 0; f < faces.count(); ++f) {
    const auto corners = corners_of(faces, f);
    for (const Index s : sets[topology.face(corners[0].at)]) {
      const bool all = std::all_of(corners.begin(), corners.end(), [&](const NewCorner& c) {
        const auto& own = sets[topology.face(c.at)];
        return std::binary_search(own.begin(), own.end(), s);
      });
      if (all) refined.face_sets[s].faces.push_back(f);
    }
  }
}

void inherit_face_channels(const Mesh& mesh, const Topology& topology, const NewFaces& faces,
                           Mesh& refined) {
  for (const FaceChannel& channel : mesh.face_channels) {
    FaceChannel& out = refined.face_channels.emplace_back(
        FaceChannel{channel.name, channel.parts, {}, channel.storage});
    const auto width = static_cast<std::ptrdiff_t>(channel.parts.size());
    for (Index f = 0; f < faces.count(); ++f) {
      const auto row = channel.values.begin() + width * topology.face(corners_of(faces, f)[0].at);
      out.values.insert(out.values.end(), row, row + width);
    }
  }
}

// One corner channel on its way through a refinement step.
class ChannelRefiner {
 public:
  ChannelRefiner(const CornerChannel& channel, const Topology& topology, const WeightTable& table)
      : given_(channel),
        topology_(topology),
        out_{channel.name, channel.width, {}, {}},
        row_of_corner_(topology.corner_count(), kNone) {
    for (Index f = 0; f < topology.face_count(); ++f) add_face_rows(f, table);
  }

  CornerChannel refine(const NewFaces& faces) && {
    for (Index f = 0; f < faces.count(); ++f) {
      const auto corners = corners_of(faces, f);
      const bool has_values = is_continuous(corners);
      for (const NewCorner& c : corners) out_.indices.push_back(has_values ? row(c) : kNone);
    }
    return std::move(out_);
  }

 private:
  Index add_row() {
    const auto row = static_cast<Index>(out_.values.size() / given_.width);
    out_.values.resize(out_.values.size() + given_.width, 0.0);
    return row;
  }
  void add(Index row, double weight, Index given_row) {
    for (std::size_t c = 0; c < given_.width; ++c) {
      out_.values[row * given_.width + c] += weight * given_.values[given_row * given_.width + c];
    }
  }

  void add_face_rows(Index f, const WeightTable& table) {
    const Index begin = topology_.face_begin(f);
    const Index m = topology_.face_degree(f);
    const auto rows = std::span(given_.indices).subspan(begin, m);
    if (std::find(rows.begin(), rows.end(), kNone) != rows.end()) return;
    const auto w = table.of(m);
    for (Index i = 0; i < m; ++i) {
      const Index row = row_of_corner_[begin + i] = add_row();
      for (Index k = 0; k < m; ++k) add(row, w[(k + m - i) % m], rows[k]);
    }
  }

  // Corners of a new face that came out of one vertex follow each other; their values must be one.
  bool is_continuous(std::span<const NewCorner> corners) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index a = corners[i].at;
      const Index b = corners[(i + 1) % corners.size()].at;
      if (row_of_corner_[a] == kNone) return false;
      if (topology_.tail(a) == topology_.tail(b) && given_.indices[a] != given_.indices[b]) {
        return false;
      }
    }
    return true;
  }

  // Corners with the same given values share their new row.
  Index row(const NewCorner& c) {
    if (c.toward == kNone) return row_of_corner_[c.at];
    const Index near = given_.indices[c.at];
    const Index far = given_.indices[c.toward];
    const auto key = std::uint64_t{near} << 32 | far;
    const auto [at, added] = row_of_curve_.try_emplace(key, kNone);
    if (added) {
      at->second = add_row();
      add(at->second, 3.0 / 4, near);
      add(at->second, 1.0 / 4, far);
    }
    return at->second;
  }

  const CornerChannel& given_;
  const Topology& topology_;
  CornerChannel out_;
  std::vector<Index> row_of_corner_;
  std::unordered_map<std::uint64_t, Index> row_of_curve_;
};

}  // namespace

void inherit_creases(const Mesh& mesh, const Layout& layout, const NewMesh& fresh, Mesh& refined) {
  const Topology& topology = layout.topology();
  for (const Index e : layout.curve_edges()) {
    if (topology.is_boundary_edge(e)) continue;
    const Index h = topology.edge_halfedge(e);
    const Index tail = layout.tail_curve_point(h);
    const Index head = layout.head_curve_point(h);
    refined.creases.push_back({{tail, head}, kInfinitelySharp});
    const auto [a, b] = topology.edge_vertices(e);
    if (layout.kind(a) == VertexKind::kept) {
      refined.creases.push_back({{layout.kept_point(a), tail}, kInfinitelySharp});
    }
    if (layout.kind(b) == VertexKind::kept) {
      refined.creases.push_back({{layout.kept_point(b), head}, kInfinitelySharp});
    }
  }
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (layout.kind(v) != VertexKind::curve || topology.is_boundary(v)) continue;
    const auto sector = corners_of(fresh.faces, fresh.vertex_face[v]);
    refined.creases.push_back({{sector.front().point, sector.back().point}, kInfinitelySharp});
  }
  for (const Corner& corner : mesh.corners) {
    if (!is_infinite(corner.sharpness) || layout.kind(corner.vertex) != VertexKind::kept) continue;
    refined.corners.push_back({layout.kept_point(corner.vertex), corner.sharpness});
  }
  refined.tags = mesh.tags;
  refined.annotations = mesh.annotations;
  refined.material_libraries = mesh.material_libraries;
}

std::vector<Index> inherited_holes(const Mesh& mesh, const Topology& topology,
                                   const NewFaces& faces) {
  std::vector<Index> holes;
  const auto& given = mesh.hole_faces;
  for (Index f = 0; f < faces.count() && !given.empty(); ++f) {
    const auto corners = corners_of(faces, f);
    const bool all = std::all_of(corners.begin(), corners.end(), [&](const NewCorner& c) {
      return std::binary_search(given.begin(), given.end(), topology.face(c.at));
    });
    if (all) holes.push_back(f);
  }
  return holes;
}

void inherit_face_attributes(const Mesh& mesh, const Topology& topology, const NewFaces& faces,
                             Mesh& refined) {
  refined.hole_faces = inherited_holes(mesh, topology, faces);
  inherit_face_sets(mesh, topology, faces, refined);
  inherit_face_channels(mesh, topology, faces, refined);
}

void refine_corner_channels(const Mesh& mesh, const Topology& topology, const WeightTable& table,
                            const NewFaces& faces, Mesh& refined) {
  for (const CornerChannel& channel : mesh.corner_channels) {
    refined.corner_channels.push_back(ChannelRefiner(channel, topology, table).refine(faces));
  }
}

}  // namespace surpass::doo_sabin

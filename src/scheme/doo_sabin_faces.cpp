#include "scheme/doo_sabin_faces.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace surpass::doo_sabin {
namespace {

NewCorner corner_point(Index h) { return {h, h, kNone}; }

NewCorner tail_curve_point(const Layout& layout, Index h) {
  return {layout.tail_curve_point(h), h, layout.topology().next(h)};
}

NewCorner head_curve_point(const Layout& layout, Index h) {
  return {layout.head_curve_point(h), layout.topology().next(h), h};
}

NewCorner kept_point(const Layout& layout, Index h) {
  return {layout.kept_point(layout.topology().tail(h)), h, h};
}

// The triangles around a tip, between each two consecutive points.
void append_tip(const Layout& layout, const std::vector<NewCorner>& path, NewFaces& faces) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    faces.corners.push_back(kept_point(layout, path[i].at));
    faces.corners.push_back(path[i]);
    faces.corners.push_back(path[i + 1]);
    faces.end_face();
  }
}

// The new points around v from one curve edge to the next, or once around: then first and last are
// the same.
void append_region(const Layout& layout, Index v, std::vector<NewCorner> path, NewFaces& faces) {
  const bool around = path.front().point == path.back().point;
  if (around && path.size() == 3) return;  // two points have no face between them
  const bool kept = layout.kind(v) == VertexKind::kept;
  if (kept && around) return append_tip(layout, path, faces);
  if (kept) faces.corners.push_back(kept_point(layout, path.front().at));
  if (around) path.pop_back();
  faces.corners.insert(faces.corners.end(), path.begin(), path.end());
  faces.end_face();
}

std::vector<Index> fan_from(const Topology& topology, Index start) {
  std::vector<Index> fan;
  for (Index h = start; h != kNone && (fan.empty() || h != start); h = topology.rotate(h)) {
    fan.push_back(h);
  }
  return fan;
}

void append_fan(const Layout& layout, Index v, Index start, NewFaces& faces) {
  const Topology& topology = layout.topology();
  std::vector<Index> fan = fan_from(topology, start);
  const auto on_curve = [&](Index h) { return layout.is_curve(topology.edge(h)); };
  const auto first = std::find_if(fan.begin(), fan.end(), on_curve);
  const bool smooth = first == fan.end();
  if (!smooth) std::rotate(fan.begin(), first, fan.end());

  std::vector<NewCorner> path;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (!smooth && path.empty()) path.push_back(tail_curve_point(layout, fan[i]));
    path.push_back(corner_point(fan[i]));
    const bool last = i + 1 == fan.size();
    if (smooth || !(last || on_curve(fan[i + 1]))) continue;
    path.push_back(head_curve_point(layout, topology.previous(fan[i])));
    append_region(layout, v, std::move(path), faces);
    path.clear();
  }
  if (!smooth) return;
  path.push_back(path.front());
  append_region(layout, v, std::move(path), faces);
}

void append_curve_side(const Layout& layout, Index h, NewFaces& faces) {
  const Index next = layout.topology().next(h);
  const NewCorner quad[] = {corner_point(h), tail_curve_point(layout, h),
                            head_curve_point(layout, h), corner_point(next)};
  faces.corners.insert(faces.corners.end(), std::begin(quad), std::end(quad));
  faces.end_face();
}

}  // namespace

void append_edge_faces(const Layout& layout, Index e, NewFaces& faces) {
  const Topology& topology = layout.topology();
  const Index h = topology.edge_halfedge(e);
  const Index g = topology.opposite(h);
  if (layout.is_curve(e)) {
    append_curve_side(layout, h, faces);
    if (g != kNone) append_curve_side(layout, g, faces);
    return;
  }
  for (const auto& [near, far] : {std::pair{h, g}, std::pair{g, h}}) {
    faces.corners.push_back(corner_point(near));
    if (layout.is_lens(near)) faces.corners.push_back(kept_point(layout, near));
    faces.corners.push_back(corner_point(topology.next(far)));
  }
  faces.end_face();
}

void append_vertex_faces(const Layout& layout, Index v, NewFaces& faces) {
  const Topology& topology = layout.topology();
  if (topology.is_isolated(v)) return;
  if (layout.kind(v) == VertexKind::smooth) {  // nearly all: append_fan's polygon without its lists
    topology.for_each_outgoing(v, [&](Index h) { faces.corners.push_back(corner_point(h)); });
    faces.end_face();
    return;
  }
  append_fan(layout, v, topology.outgoing(v), faces);
  if (!topology.is_bowtie(v)) return;
  for (const Index start : topology.further_fans(v)) append_fan(layout, v, start, faces);
}

NewMesh new_mesh(const Layout& layout) {
  const Topology& topology = layout.topology();
  NewMesh mesh;
  NewFaces& faces = mesh.faces;
  const Index h_count = topology.corner_count();
  faces.corners.reserve(std::size_t{4} * h_count);
  faces.offsets.reserve(std::size_t{2} + topology.face_count() + topology.edge_count() +
                        topology.vertex_count());
  for (Index f = 0; f < topology.face_count(); ++f) {
    for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
      faces.corners.push_back(corner_point(h));
    }
    faces.end_face();
  }
  for (Index e = 0; e < topology.edge_count(); ++e) {
    mesh.edge_face.push_back(faces.count());
    append_edge_faces(layout, e, faces);
  }
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    mesh.vertex_face.push_back(faces.count());
    append_vertex_faces(layout, v, faces);
  }
  return mesh;
}

Index edge_position(const NewFaces& faces, Index f, Index a, Index b) {
  const Index m = faces.size(f);
  for (Index i = 0; i < m; ++i) {
    const Index p = faces.corners[faces.offsets[f] + i].point;
    const Index q = faces.corners[faces.offsets[f] + (i + 1) % m].point;
    if ((p == a && q == b) || (p == b && q == a)) return i;
  }
  return kNone;
}

}  // namespace surpass::doo_sabin

#include "scheme/doo_sabin_step.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_attributes.hpp"

namespace surpass::doo_sabin {
namespace {

// A row per new point, in the order of their numbers.
void add_row(const Layout& layout, const WeightTable& table, Index i, RowTile& tile) {
  const Topology& topology = layout.topology();
  const Index curve = layout.first_curve_point();
  const Index kept = layout.first_kept_point();
  if (i >= kept) {
    const auto [columns, weights] = tile.add_row(1);
    columns[0] = layout.kept_vertices()[i - kept];
    weights[0] = 1;
  } else if (i >= curve) {
    const auto ends = topology.edge_vertices(layout.curve_edges()[(i - curve) / 2]);
    const Index near = (i - curve) % 2;
    const auto [columns, weights] = tile.add_row(2);
    columns[0] = ends[near];
    columns[1] = ends[1 - near];
    weights[0] = 3.0 / 4;
    weights[1] = 1.0 / 4;
  } else {
    const auto w = table.of(topology.face_degree(topology.face(i)));
    const auto [columns, weights] = tile.add_row(w.size());
    std::copy(w.begin(), w.end(), weights.begin());
    Index h = i;
    for (Index& column : columns) {
      column = topology.tail(h);
      h = topology.next(h);
    }
  }
}

// The half-edge between the two corner points of a doublet, in the face of one of its edges.
Index doublet_edge(const Layout& layout, const NewMesh& fresh, Index v) {
  const Index h = layout.topology().outgoing(v);
  const Index f = fresh.edge_face[layout.topology().edge(h)];
  return fresh.faces.offsets[f] + edge_position(fresh.faces, f, h, layout.topology().rotate(h));
}

Site site_of_vertex(const Layout& layout, const NewMesh& fresh, Index v) {
  switch (layout.kind(v)) {
    case VertexKind::kept: return {Site::Kind::vertex, layout.kept_point(v)};
    case VertexKind::doublet: return {Site::Kind::edge, doublet_edge(layout, fresh, v)};
    case VertexKind::curve:
      return {Site::Kind::edge, fresh.faces.offsets[fresh.vertex_face[v] + 1] - 1};
    default: return {Site::Kind::face, fresh.vertex_face[v]};
  }
}

Result<Level> given_level(Mesh mesh, const Rules& rules, const Context& context) {
  auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  if (auto ok = require_suitable(scheme_of(Scheme::doo_sabin), *topology, rules); !ok) {
    return tl::make_unexpected(ok.error());
  }
  Level level;
  level.topology = std::make_unique<const Topology>(std::move(*topology));
  auto layout = Layout::build(mesh, *level.topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  level.layout = std::move(*layout);
  level.mesh = std::move(mesh);
  return level;
}

Result<Level> next_level(const Level& level, bool first, const Rules& rules, const Context& context,
                         Steps& steps) {
  NewMesh fresh;
  auto mesh = steps.take(level.mesh, context, [&](RowSink& sink) -> Result<Mesh> {
    auto step = refinement_step(level.mesh, level.layout, rules.weights, context, sink);
    if (!step) return tl::make_unexpected(step.error());
    fresh = std::move(step->fresh);
    return std::move(step->mesh);
  });
  if (!mesh) return tl::make_unexpected(mesh.error());
  auto next = given_level(std::move(*mesh), rules, context);
  if (!next) return next;
  if (first) {
    next->sites = sites_of_vertices(level.layout, fresh);
  } else {
    for (const Site& site : level.sites) {
      next->sites.push_back(child_site(level.layout, fresh, site));
    }
  }
  return next;
}

}  // namespace

Result<Step> refinement_step(const Mesh& mesh, const Layout& layout, Weights family,
                             const Context& context, RowSink& sink) {
  const Topology& topology = layout.topology();
  const std::uint64_t most_corners = std::uint64_t{8} * topology.corner_count();
  if (most_corners > kNone) {
    return fail(ErrorCode::too_large,
                fmt::format("the refined mesh would have up to {} face corners", most_corners));
  }
  const WeightTable table(topology, family);
  make_rows(context, layout.point_count(), sink,
            [&](Index i, RowTile& tile) { add_row(layout, table, i, tile); });
  Step step{{}, new_mesh(layout)};
  Mesh& out = step.mesh;
  const NewFaces& faces = step.fresh.faces;
  out.face_offsets = faces.offsets;
  out.face_vertices.reserve(faces.corners.size());
  for (const NewCorner& c : faces.corners) out.face_vertices.push_back(c.point);
  inherit_creases(mesh, layout, step.fresh, out);
  inherit_face_attributes(mesh, topology, faces, out);
  refine_corner_channels(mesh, topology, table, faces, out);
  return step;
}

Result<Mesh> DooSabin::refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                  const Context& context, RowSink& sink) const {
  const auto layout = Layout::build(mesh, topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  auto step = refinement_step(mesh, *layout, rules.weights, context, sink);
  if (!step) return tl::make_unexpected(step.error());
  return std::move(step->mesh);
}

std::vector<Site> sites_of_vertices(const Layout& layout, const NewMesh& fresh) {
  std::vector<Site> sites;
  for (Index v = 0; v < layout.topology().vertex_count(); ++v) {
    sites.push_back(site_of_vertex(layout, fresh, v));
  }
  return sites;
}

Site child_site(const Layout& layout, const NewMesh& fresh, const Site& site) {
  if (site.kind == Site::Kind::vertex) return {site.kind, layout.kept_point(site.at)};
  if (site.kind == Site::Kind::face) return site;  // faces come first in the refined mesh
  const Index e = layout.topology().edge(site.at);
  Index f = fresh.edge_face[e];
  if (!layout.is_curve(e)) return {Site::Kind::face, f};
  if (layout.topology().edge_halfedge(e) != site.at) ++f;  // the quad of the other side
  return {Site::Kind::edge, fresh.faces.offsets[f] + 1};
}

Result<Level> refined_level(Mesh mesh, const Rules& rules, int levels, const Context& context,
                            Steps& steps) {
  auto level = given_level(std::move(mesh), rules, context);
  for (int i = 0; i < levels && level; ++i) {
    if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while subdividing");
    context.report({.stage = "subdivide",
                    .fraction = static_cast<double>(i) / levels,
                    .iteration = static_cast<std::uint64_t>(i)});
    level = next_level(*level, i == 0, rules, context, steps);
  }
  return level;
}

}  // namespace surpass::doo_sabin

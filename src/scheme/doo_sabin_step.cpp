#include "scheme/doo_sabin_step.hpp"

#include <fmt/format.h>

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_attributes.hpp"

namespace surpass::doo_sabin {
namespace {

// A row per new point, in the order of their numbers.
SparseRows stencil(const Layout& layout, const WeightTable& table, const Context& context) {
  const Topology& topology = layout.topology();
  const Index curve = layout.first_curve_point();
  const Index kept = layout.first_kept_point();
  return SparseRows::build(
      context, layout.point_count(),
      [&](Index i) -> Index {
        if (i < curve) return topology.face_degree(topology.face(i));
        return i < kept ? 2 : 1;
      },
      [&](Index i, std::span<Index> columns, std::span<double> weights) {
        if (i >= kept) {
          columns[0] = layout.kept_vertices()[i - kept];
          weights[0] = 1;
        } else if (i >= curve) {
          const auto ends = topology.edge_vertices(layout.curve_edges()[(i - curve) / 2]);
          const Index near = (i - curve) % 2;
          columns[0] = ends[near];
          columns[1] = ends[1 - near];
          weights[0] = 3.0 / 4;
          weights[1] = 1.0 / 4;
        } else {
          const auto w = table.of(static_cast<Index>(columns.size()));
          Index h = i;
          for (std::size_t j = 0; j < columns.size(); ++j, h = topology.next(h)) {
            columns[j] = topology.tail(h);
            weights[j] = w[j];
          }
        }
      });
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

Result<Level> next_level(const Level& level, bool first, const Rules& rules,
                         const Context& context) {
  auto step = refinement_step(level.mesh, level.layout, rules.weights, context);
  if (!step) return tl::make_unexpected(step.error());
  apply_stencil(level.mesh, step->refinement, context);
  auto next = given_level(std::move(step->refinement.mesh), rules, context);
  if (!next) return next;
  if (first) {
    next->sites = sites_of_vertices(level.layout, step->fresh);
  } else {
    for (const Site& site : level.sites) {
      next->sites.push_back(child_site(level.layout, step->fresh, site));
    }
  }
  return next;
}

}  // namespace

Result<Step> refinement_step(const Mesh& mesh, const Layout& layout, Weights family,
                             const Context& context) {
  const Topology& topology = layout.topology();
  const std::uint64_t most_corners = std::uint64_t{8} * topology.corner_count();
  if (most_corners > kNone) {
    return fail(ErrorCode::too_large,
                fmt::format("the refined mesh would have up to {} face corners", most_corners));
  }
  const WeightTable table(topology, family);
  Step step{{{}, stencil(layout, table, context)}, new_mesh(layout)};
  Mesh& out = step.refinement.mesh;
  const NewFaces& faces = step.fresh.faces;
  out.face_offsets = faces.offsets;
  out.face_vertices.reserve(faces.corners.size());
  for (const NewCorner& c : faces.corners) out.face_vertices.push_back(c.point);
  inherit_creases(mesh, layout, step.fresh, out);
  inherit_face_attributes(mesh, topology, faces, out);
  refine_corner_channels(mesh, topology, table, faces, out);
  return step;
}

Result<Refinement> DooSabin::refinement(const Mesh& mesh, const Topology& topology,
                                        const Rules& rules, const Context& context) const {
  const auto layout = Layout::build(mesh, topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  auto step = refinement_step(mesh, *layout, rules.weights, context);
  if (!step) return tl::make_unexpected(step.error());
  return std::move(step->refinement);
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

Result<Level> refined_level(Mesh mesh, const Rules& rules, int levels, const Context& context) {
  auto level = given_level(std::move(mesh), rules, context);
  for (int i = 0; i < levels && level; ++i) {
    if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while subdividing");
    context.report({.stage = "subdivide",
                    .fraction = static_cast<double>(i) / levels,
                    .iteration = static_cast<std::uint64_t>(i)});
    level = next_level(*level, i == 0, rules, context);
  }
  return level;
}

}  // namespace surpass::doo_sabin

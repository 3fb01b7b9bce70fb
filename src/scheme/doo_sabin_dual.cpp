#include "scheme/doo_sabin_dual.hpp"

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_attributes.hpp"
#include "scheme/doo_sabin_sites.hpp"

namespace surpass::doo_sabin {

Dual::Dual(const Level& level)
    : level_(level),
      layout_(level.layout),
      topology_(*level.topology),
      of_face_(topology_.face_count(), kNone),
      of_curve_edge_(layout_.curve_edges().size(), kNone),
      of_kept_(layout_.kept_vertices().size(), kNone) {
  for (const Site& site : level.sites) add(site);
  for (Index f = 0; f < topology_.face_count(); ++f) add({Site::Kind::face, f});
  for (const Index e : layout_.curve_edges()) {
    add({Site::Kind::edge, topology_.edge_halfedge(e)});
  }
  for (const Index v : layout_.kept_vertices()) add({Site::Kind::vertex, v});
}

std::vector<Index> Dual::put_faces(Mesh& mesh) const {
  NewFaces faces;
  std::vector<Index> vertices;
  for (Index v = 0; v < topology_.vertex_count(); ++v) {
    append_vertex_faces(layout_, v, faces);
    vertices.resize(faces.count(), v);
  }
  mesh.face_offsets = {0};
  mesh.face_vertices.clear();
  for (Index f = 0; f < faces.count(); ++f) {
    const Index m = faces.size(f);
    for (Index i = 0; i < m; ++i) {
      const NewCorner& corner = faces.corners[faces.offsets[f] + i];
      const NewCorner& next = faces.corners[faces.offsets[f] + (i + 1) % m];
      mesh.face_vertices.push_back(number(corner));
      const Index between = point_between(corner, next);
      if (between != kNone) mesh.face_vertices.push_back(between);
    }
    mesh.face_offsets.push_back(mesh.corner_count());
  }
  mesh.hole_faces = inherited_holes(level_.mesh, topology_, faces);
  return vertices;
}

Index& Dual::number(const Site& site) {
  if (site.kind == Site::Kind::face) return of_face_[site.at];
  if (site.kind == Site::Kind::vertex) return of_kept_[layout_.kept_rank(site.at)];
  const Index e = topology_.edge(site.at);
  if (layout_.is_curve(e)) return of_curve_edge_[layout_.curve_rank(e)];
  return of_smooth_edge_.try_emplace(e, kNone).first->second;
}

void Dual::add(const Site& site) {
  Index& n = number(site);
  if (n != kNone) return;
  n = static_cast<Index>(sites_.size());
  sites_.push_back(site);
}

Index Dual::number(const NewCorner& corner) const {
  if (corner.toward == kNone) return of_face_[topology_.face(corner.at)];
  if (corner.toward == corner.at) return of_kept_[layout_.kept_rank(topology_.tail(corner.at))];
  return of_curve_edge_[(corner.point - layout_.first_curve_point()) / 2];
}

Index Dual::point_between(const NewCorner& a, const NewCorner& b) const {
  if (a.toward != kNone || b.toward != kNone) return kNone;
  const auto on_edge = of_smooth_edge_.find(topology_.edge(b.at));
  if (on_edge != of_smooth_edge_.end()) return on_edge->second;
  if (!layout_.is_lens(topology_.opposite(b.at))) return kNone;
  return of_kept_[layout_.kept_rank(topology_.head(b.at))];
}

SparseRows Dual::limit_rows(Weights family, const Context& context) const {
  return SparseRows::build(
      context, static_cast<Index>(sites_.size()),
      [&](Index i) -> Index {
        Index length = 0;
        add_site_limit(layout_, family, sites_[i], [&](Index, double) { ++length; });
        return length;
      },
      [&](Index i, std::span<Index> columns, std::span<double> weights) {
        std::size_t k = 0;
        add_site_limit(layout_, family, sites_[i], [&](Index v, double w) {
          columns[k] = v;
          weights[k++] = w;
        });
      });
}

namespace {

// What has no place on the dual's faces and corners.
Mesh without_face_data(Mesh mesh) {
  mesh.corner_channels.clear();
  mesh.face_channels.clear();
  mesh.face_sets.clear();
  mesh.material_libraries.clear();
  mesh.tags.clear();
  return mesh;
}

}  // namespace

Result<Mesh> DooSabin::limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                  const Context& context, Steps& steps) const {
  // The given mesh itself can be moved; below that, the given vertices have no successors.
  if (levels <= 0) return SubdivisionScheme::limit_mesh(control, rules, levels, context, steps);
  const auto level = refined_level(without_face_data(control), rules, levels, context, steps);
  if (!level) return tl::make_unexpected(level.error());
  const Dual dual(*level);
  Mesh mesh = level->mesh;
  move_to_limit(mesh, dual.limit_rows(rules.weights, context),
                site_normals(*level, dual.sites(), rules.weights, context), context, steps);
  mesh.creases.clear();
  mesh.corners.clear();
  dual.put_faces(mesh);
  return mesh;
}

}  // namespace surpass::doo_sabin

// The limit mesh is the dual of the refined one: limit points are known at faces, on curve edges
// and at kept vertices, not at the refined vertices, and the dual's faces are what the refined
// mesh's vertices would turn into in the next step.
#include <unordered_map>

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_attributes.hpp"
#include "scheme/doo_sabin_sites.hpp"

namespace surpass::doo_sabin {
namespace {

class Dual {
 public:
  explicit Dual(const Level& level)
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

  [[nodiscard]] const std::vector<Site>& sites() const { return sites_; }

  // Faces of the dual, replacing those of `mesh`.
  void put_faces(Mesh& mesh) const {
    NewFaces faces;
    for (Index v = 0; v < topology_.vertex_count(); ++v) append_vertex_faces(layout_, v, faces);
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
  }

 private:
  Index& number(const Site& site) {
    if (site.kind == Site::Kind::face) return of_face_[site.at];
    if (site.kind == Site::Kind::vertex) return of_kept_[layout_.kept_rank(site.at)];
    const Index e = topology_.edge(site.at);
    if (layout_.is_curve(e)) return of_curve_edge_[layout_.curve_rank(e)];
    return of_smooth_edge_.try_emplace(e, kNone).first->second;
  }
  void add(const Site& site) {
    Index& n = number(site);
    if (n != kNone) return;
    n = static_cast<Index>(sites_.size());
    sites_.push_back(site);
  }

  [[nodiscard]] Index number(const NewCorner& corner) const {
    if (corner.toward == kNone) return of_face_[topology_.face(corner.at)];
    if (corner.toward == corner.at) {
      return of_kept_[layout_.kept_rank(topology_.tail(corner.at))];
    }
    return of_curve_edge_[(corner.point - layout_.first_curve_point()) / 2];
  }

  // The point on the edge between two consecutive faces around a vertex, if it has one: a doublet's
  // limit, or the kept vertex of a lens at its other end.
  [[nodiscard]] Index point_between(const NewCorner& a, const NewCorner& b) const {
    if (a.toward != kNone || b.toward != kNone) return kNone;
    const auto on_edge = of_smooth_edge_.find(topology_.edge(b.at));
    if (on_edge != of_smooth_edge_.end()) return on_edge->second;
    if (!layout_.is_lens(topology_.opposite(b.at))) return kNone;
    return of_kept_[layout_.kept_rank(topology_.head(b.at))];
  }

  const Level& level_;
  const Layout& layout_;
  const Topology& topology_;
  std::vector<Site> sites_;
  std::vector<Index> of_face_;
  std::vector<Index> of_curve_edge_;
  std::vector<Index> of_kept_;
  std::unordered_map<Index, Index> of_smooth_edge_;  // only where doublets were given
};

SparseRows limit_rows(const Level& level, const std::vector<Site>& sites, Weights family,
                      const Context& context) {
  return SparseRows::build(
      context, static_cast<Index>(sites.size()),
      [&](Index i) -> Index {
        Index length = 0;
        add_site_limit(level.layout, family, sites[i], [&](Index, double) { ++length; });
        return length;
      },
      [&](Index i, std::span<Index> columns, std::span<double> weights) {
        std::size_t k = 0;
        add_site_limit(level.layout, family, sites[i], [&](Index v, double w) {
          columns[k] = v;
          weights[k++] = w;
        });
      });
}

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
  move_to_limit(mesh, limit_rows(*level, dual.sites(), rules.weights, context),
                site_normals(*level, dual.sites(), rules.weights, context), context, steps);
  mesh.creases.clear();
  mesh.corners.clear();
  dual.put_faces(mesh);
  return mesh;
}

}  // namespace surpass::doo_sabin

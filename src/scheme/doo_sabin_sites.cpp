#include "scheme/doo_sabin_sites.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "scheme/doo_sabin.hpp"
#include "scheme/tangents.hpp"

namespace surpass::doo_sabin {
namespace {

using Vector = Eigen::Vector3d;

// Crossed left eigenvectors of the face rule, a circulant matrix: its cosine and sine of one turn.
Vector polygon_normal(std::span<const Vector> polygon) {
  const double step = 2 * std::numbers::pi / static_cast<double>(polygon.size());
  Vector cosine = Vector::Zero();
  Vector sine = Vector::Zero();
  for (std::size_t j = 0; j < polygon.size(); ++j) {
    // Differences, so that far from the origin nothing is lost.
    const Vector from_first = polygon[j] - polygon[0];
    cosine += std::cos(step * static_cast<double>(j)) * from_first;
    sine += std::sin(step * static_cast<double>(j)) * from_first;
  }
  return unit_cross(cosine, sine);
}

class NormalMaker {
 public:
  NormalMaker(const Level& level, const WeightTable& table)
      : mesh_(level.mesh), layout_(level.layout), topology_(*level.topology), table_(table) {}

  [[nodiscard]] Vector at(const Site& site) const {
    switch (site.kind) {
      case Site::Kind::face: return at_face(site.at);
      case Site::Kind::vertex: return at_vertex(site.at);
      default:
        return layout_.is_curve(topology_.edge(site.at)) ? at_curve(site.at)
                                                         : at_smooth_edge(site.at);
    }
  }

 private:
  [[nodiscard]] Vector tail(Index h) const {
    return Eigen::Map<const Vector>(mesh_.points[topology_.tail(h)].data());
  }

  [[nodiscard]] Vector corner_point(Index h) const {
    Vector sum = Vector::Zero();
    for (const double w : table_.of(topology_.face_degree(topology_.face(h)))) {
      sum += w * tail(h);
      h = topology_.next(h);
    }
    return sum;
  }

  [[nodiscard]] Vector at_face(Index f) const {
    std::vector<Vector> polygon;
    for (Index h = topology_.face_begin(f); h < topology_.face_end(f); ++h) {
      polygon.push_back(tail(h));
    }
    return polygon_normal(polygon);
  }

  // Across the curve, the midpoint of the two new corner points beside the edge keeps its
  // direction from the edge's midpoint; it comes closer by 1/4 in each step.
  [[nodiscard]] Vector beside_curve(Index h) const {
    const Index next = topology_.next(h);
    const Vector along = tail(next) - tail(h);
    const Vector middle = (tail(next) + tail(h)) / 2;
    const Vector inside = (corner_point(h) + corner_point(next)) / 2 - middle;
    return unit_cross(along, inside);
  }
  [[nodiscard]] Vector at_curve(Index h) const {
    const Index other = topology_.opposite(h);
    if (other == kNone) return beside_curve(h);
    return unit(beside_curve(h) + beside_curve(other));
  }

  // The quad that the edge makes in the next step.
  [[nodiscard]] Vector at_smooth_edge(Index h) const {
    const Index g = topology_.opposite(h);
    const Vector quad[] = {corner_point(h), corner_point(topology_.next(g)), corner_point(g),
                           corner_point(topology_.next(h))};
    return polygon_normal(quad);
  }

  [[nodiscard]] Vector at_vertex(Index v) const {
    return Eigen::Map<const Vector>(mean_face_normal(mesh_, topology_, v).data());
  }

  const Mesh& mesh_;
  const Layout& layout_;
  const Topology& topology_;
  const WeightTable& table_;
};

}  // namespace

std::vector<Point> site_normals(const Level& level, const std::vector<Site>& sites, Weights family,
                                const Context& context) {
  const WeightTable table(*level.topology, family);
  const NormalMaker maker(level, table);
  std::vector<Point> normals(sites.size());
  parallel::for_ranges(context, sites.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector n = maker.at(sites[i]);
      normals[i] = {n[0], n[1], n[2]};
    }
  });
  return normals;
}

Result<std::vector<Point>> DooSabin::limit_normals(const Mesh& mesh, const Topology&,
                                                   const Rules& rules,
                                                   const Context& context) const {
  Mesh bare;
  bare.points = mesh.points;
  bare.face_offsets = mesh.face_offsets;
  bare.face_vertices = mesh.face_vertices;
  bare.creases = mesh.creases;
  bare.corners = mesh.corners;
  const auto level = refined_level(std::move(bare), rules, 1, context);
  if (!level) return tl::make_unexpected(level.error());
  return site_normals(*level, level->sites, rules.weights, context);
}

}  // namespace surpass::doo_sabin

// The limit surface cut into patches, with positions and derivatives where they have a closed form.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <vector>

#include <Eigen/Core>

#include "scheme/sharpness.hpp"

namespace surpass {

/// What the surface is like at a sample.
enum class Spot : unsigned char {
  regular,        ///< a polynomial patch or several that meet smoothly: the jet is exact
  curve,          ///< on a boundary or crease with regular patches beside it: no jet
  extraordinary,  ///< elsewhere; curvature need not be bounded nearby
};

/// Position and derivatives in parameters (u, v) in which the regular faces of the refined mesh are
/// unit squares, or triangles with three edges of length 1. u runs along the first spoke of the
/// vertex, v is perpendicular to it, so the sum |uu|^2 + 2 |uv|^2 + |vv|^2 prefers no direction.
struct LimitJet {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d uu = Eigen::Vector3d::Zero();
  Eigen::Vector3d uv = Eigen::Vector3d::Zero();
  Eigen::Vector3d vv = Eigen::Vector3d::Zero();
};

/// Samples are the vertices of a refined mesh. A patch is a piece of the surface with one sample at
/// each corner, or with a single one at its centre; hole faces have none.
struct LimitSamples {
  Mesh mesh;                            ///< refined; its faces join neighbouring samples
  std::vector<Spot> spots;              ///< #V
  std::vector<LimitJet> jets;           ///< #V, meaningful at regular spots only
  std::vector<Index> patch_offsets{0};  ///< #P + 1: samples of patch p are offsets[p]..offsets[p+1]
  std::vector<Index> patch_samples;
  std::vector<double> patch_areas;  ///< #P areas of polygons inscribed in the limit surface
  double patch_measure = 1;         ///< area of a regular patch in the parameters of the jets

  [[nodiscard]] Index patch_count() const { return static_cast<Index>(patch_areas.size()); }
  [[nodiscard]] std::span<const Index> patch(Index p) const {
    return std::span(patch_samples)
        .subspan(patch_offsets[p], patch_offsets[p + 1] - patch_offsets[p]);
  }
  void add_patch(std::span<const Index> samples, double area) {
    patch_samples.insert(patch_samples.end(), samples.begin(), samples.end());
    patch_offsets.push_back(static_cast<Index>(patch_samples.size()));
    patch_areas.push_back(area);
  }
};

/// The spot of a vertex that is not plain: `smooth` faces in each sector make a crease regular,
/// `sharp` faces a corner (0: nothing does).
[[nodiscard]] Spot spot_on_curve(const Topology& topology, const Sharpness& sharpness, Index v,
                                 std::size_t smooth, std::size_t sharp);

/// The spot of a vertex among quads, where four quads are regular.
[[nodiscard]] Spot spot_among_quads(const Topology& topology, const Sharpness& sharpness, Index v);

/// Vertex, four spokes and the four vertices across, counterclockwise, of a regular spot among
/// quads: across[j] lies between spokes j and j + 1.
struct QuadRing {
  Eigen::Vector3d center;
  Eigen::Vector3d spokes[4];
  Eigen::Vector3d across[4];
};
[[nodiscard]] QuadRing quad_ring(const Mesh& mesh, const Topology& topology, Index v);

/// Second difference, taken so that far from the origin nothing is lost.
[[nodiscard]] inline Eigen::Vector3d bend(const Eigen::Vector3d& a, const Eigen::Vector3d& middle,
                                          const Eigen::Vector3d& b) {
  return (a - middle) + (b - middle);
}

[[nodiscard]] inline Eigen::Map<const Eigen::Vector3d> position_of(const Mesh& mesh, Index v) {
  return Eigen::Map<const Eigen::Vector3d>(mesh.points[v].data());
}

/// Length of the vector area: exact for plane polygons, never more than any surface they bound.
[[nodiscard]] double polygon_area(std::span<const Point> points, std::span<const Index> polygon);

}  // namespace surpass

// From tangent masks to normals, the same for every scheme that has such masks.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "parallel/parallel.hpp"
#include "scheme/ring.hpp"
#include "scheme/settle.hpp"

namespace surpass {

/// v / |v|, or zero; zero, too, if |v| is not a finite number.
[[nodiscard]] inline Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  const double length = v.stableNorm();
  const bool has_direction = length > 0 && length <= std::numeric_limits<double>::max();
  return has_direction ? Eigen::Vector3d(v / length) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// The unit vector along a x b, or zero where they have the same direction: for every finite a and
/// b, also those whose products are beyond the range of doubles. Zero if one of them is not finite.
[[nodiscard]] Eigen::Vector3d unit_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// A limit normal's ingredients in one smooth sector at a vertex: left eigenvectors of the local
/// subdivision matrix. Crossed in this order they point to the outside.
struct Tangents {
  Mask first;
  Mask second;
};

/// What decides the normal at a vertex: its ring after enough refinement, as masks over mesh
/// vertices, and the tangents there.
struct NormalMasks {
  std::vector<Index> columns;
  std::vector<Mask> weights;  ///< empty: the mesh vertices themselves
  std::vector<Tangents> sectors;
};

/// Of a ring that is_settled() and tangent_masks() understand, over the mesh vertices `columns`.
template <class R>
[[nodiscard]] NormalMasks normal_masks(std::vector<Index> columns, const R& ring) {
  if (is_settled(ring)) return {std::move(columns), {}, tangent_masks(ring)};
  auto settled = settle(ring, [](const R& r) { return is_settled(r); });
  return {std::move(columns), std::move(settled.weights), tangent_masks(settled.ring)};
}

/// One pair of tangents, or several, for each sector of a crease or corner ring: `curve` makes
/// those between the sharp spokes of a smooth curve, `corner` those at a fixed vertex.
template <class R, class Curve, class CornerPlane>
[[nodiscard]] std::vector<Tangents> sector_tangents(const R& ring, Curve&& curve,
                                                    CornerPlane&& corner) {
  std::vector<Tangents> tangents;
  for (const Sector& sector : sectors(ring)) {
    if (ring.rule() == VertexRule::crease) {
      tangents.push_back(curve(ring, sector));
      continue;
    }
    // There is no tangent plane at a corner of more than two faces: the mode of the faces inside
    // fades more slowly than the curves. The planes of the control faces stand in for it.
    const bool plane = sector.faces <= 2;
    for (std::size_t j = 0; j < (plane ? 1 : sector.faces); ++j) {
      tangents.push_back(corner(ring, plane ? sector : Sector{sector.begin + j, 1}));
    }
  }
  return tangents;
}

/// At a fixed vertex the curves leave along their first edges, and a sector of one or two faces
/// tends to the plane between them. Points of the ring are center, spokes, others.
template <class R>
[[nodiscard]] Tangents corner_tangents(const R& ring, const Sector& sector) {
  const std::size_t n = ring.size();
  Tangents t{Mask(ring.point_count(), 0.0), Mask(ring.point_count(), 0.0)};
  t.first[1 + sector.begin % n] = 1;
  t.second[1 + (sector.begin + sector.faces) % n] = 1;
  t.first[0] = t.second[0] = -1;
  return t;
}

/// The even tangent at a dart: the mode after the eigenvalue 1 of the subdivision matrix folded
/// about the crease. `masks` refine the points of the ring once (center, spokes, others), `image`
/// is the permutation that mirrors them, and the crease is spoke `end` of `spokes`. Positive along
/// it.
[[nodiscard]] Mask even_dart_tangent(const std::vector<Mask>& masks,
                                     const std::vector<std::size_t>& image, std::size_t end,
                                     std::size_t spokes);

/// The normalised mean of the sectors' normals; zero where no tangents differ.
[[nodiscard]] Point normal_of(const Mesh& mesh, const NormalMasks& masks);

/// The normalised mean of the normals of the faces at v.
[[nodiscard]] Point mean_face_normal(const Mesh& mesh, const Topology& topology, Index v);

/// masks_at(v) gives the NormalMasks of a vertex that is neither isolated nor a bow-tie.
template <class MasksAt>
[[nodiscard]] std::vector<Point> normals_from_tangents(const Mesh& mesh, const Topology& topology,
                                                       const Context& context, MasksAt&& masks_at) {
  std::vector<Point> normals(topology.vertex_count(), Point{});
  parallel::for_ranges(context, normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      if (topology.is_isolated(v)) continue;
      // Each fan of a bow-tie is a corner of its own.
      normals[i] = topology.is_bowtie(v) ? mean_face_normal(mesh, topology, v)
                                         : normal_of(mesh, masks_at(v));
    }
  });
  return normals;
}

}  // namespace surpass

// From tangent masks to normals, the same for every scheme that has such masks.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <span>
#include <vector>

#include "parallel/parallel.hpp"
#include "scheme/settle.hpp"

namespace surpass {

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

/// The normalised mean of the sectors' normals; zero where no tangents differ.
[[nodiscard]] Point normal_of(const Mesh& mesh, const NormalMasks& masks);

/// Each fan of a bow-tie is a corner of its own: the normalised mean of the faces' normals there.
[[nodiscard]] Point normal_at_bowtie(const Mesh& mesh, const Topology& topology, Index v);

/// masks_at(v) gives the NormalMasks of a vertex that is neither isolated nor a bow-tie.
template <class MasksAt>
[[nodiscard]] std::vector<Point> normals_from_tangents(const Mesh& mesh, const Topology& topology,
                                                       const Context& context, MasksAt&& masks_at) {
  std::vector<Point> normals(topology.vertex_count(), Point{});
  parallel::for_ranges(context, normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      if (topology.is_isolated(v)) continue;
      normals[i] = topology.is_bowtie(v) ? normal_at_bowtie(mesh, topology, v)
                                         : normal_of(mesh, masks_at(v));
    }
  });
  return normals;
}

}  // namespace surpass

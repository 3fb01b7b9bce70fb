// Sharp edges and corners of a triangle mesh.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <array>
#include <vector>

namespace surpass::reconstruction {

struct Features {
  std::vector<std::array<Index, 2>> creases;  ///< edges, by their end vertices
  std::vector<Index> corners;                 ///< on one curve that turns there, ascending
};

/// Edges at which normals differ by more than `degrees`, without curves of fewer than four such
/// edges, which scatter makes; and the vertices where a curve of them turns by more than that.
/// Where three and more of them meet the rules of creases make a corner anyway.
[[nodiscard]] Features find_features(const Mesh& mesh, const Topology& topology, double degrees);

}  // namespace surpass::reconstruction

// What a collapse must not do to the mesh.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "reconstruct/collapse_mesh.hpp"

namespace surpass::reconstruction {

class CollapseGuards {
 public:
  /// `boundary` (#V) marks vertices on the boundary; both must outlive the guards.
  CollapseGuards(CollapseMesh& mesh, const std::vector<Eigen::Vector3d>& points,
                 const std::vector<unsigned char>& boundary)
      : mesh_(mesh), points_(points), boundary_(boundary) {}

  void set_longest_edge(double length) { longest_edge_ = length; }

  /// Whether v, whose neighbours are known, may be merged into w, one of them.
  [[nodiscard]] bool allow(Index v, Index w, std::span<const Index> around_v);

 private:
  [[nodiscard]] bool keep_topology(Index v, Index w, std::span<const Index> around_v);
  [[nodiscard]] bool has_more_than_least_valence(Index v);
  [[nodiscard]] bool keep_shape(Index v, Index w) const;

  CollapseMesh& mesh_;
  const std::vector<Eigen::Vector3d>& points_;
  const std::vector<unsigned char>& boundary_;
  double longest_edge_ = 0;  // 0: any
  // Kept between calls for their memory.
  std::vector<Index> around_w_;
  std::vector<Index> around_apex_;
};

}  // namespace surpass::reconstruction

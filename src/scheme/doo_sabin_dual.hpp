// The dual of a refined mesh, inscribed in the limit surface: limit points are known at faces, on
// curve edges and at kept vertices, not at the refined vertices, and the dual's faces are what the
// refined mesh's vertices would turn into in the next step.
#pragma once

#include <unordered_map>

#include "scheme/doo_sabin_step.hpp"
#include "scheme/sparse_rows.hpp"

namespace surpass::doo_sabin {

class Dual {
 public:
  explicit Dual(const Level& level);

  /// Where the dual's vertices are on the refined mesh; those of the given vertices come first.
  [[nodiscard]] const std::vector<Site>& sites() const { return sites_; }

  /// A row per site over the refined vertices.
  [[nodiscard]] SparseRows limit_rows(Weights family, const Context& context) const;

  /// Faces of the dual, replacing those of `mesh`. Returns the refined vertex of each.
  std::vector<Index> put_faces(Mesh& mesh) const;

 private:
  Index& number(const Site& site);
  void add(const Site& site);
  [[nodiscard]] Index number(const NewCorner& corner) const;
  /// The point on the edge between two consecutive faces around a vertex, if it has one: a
  /// doublet's limit, or the kept vertex of a lens at its other end.
  [[nodiscard]] Index point_between(const NewCorner& a, const NewCorner& b) const;

  const Level& level_;
  const Layout& layout_;
  const Topology& topology_;
  std::vector<Site> sites_;
  std::vector<Index> of_face_;
  std::vector<Index> of_curve_edge_;
  std::vector<Index> of_kept_;
  std::unordered_map<Index, Index> of_smooth_edge_;  // only where doublets were given
};

}  // namespace surpass::doo_sabin

// The face rule: weights of a polygon's corners in the new point of one of them.
#pragma once

#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <span>
#include <vector>

namespace surpass::doo_sabin {

/// m weights, by offset from the corner whose point they make; w[j] = w[m - j], sum 1.
[[nodiscard]] std::vector<double> face_weights(Weights family, Index m);

/// Weights and smallest eigenvalues for every size of face in a mesh, so that no cosine is taken a
/// million times.
class WeightTable {
 public:
  WeightTable(const Topology& topology, Weights family);

  /// m: the size of a face of the mesh.
  [[nodiscard]] std::span<const double> of(Index m) const { return weights_[m]; }
  /// Smallest eigenvalue of the face rule, a symmetric circulant matrix.
  [[nodiscard]] double lowest_eigenvalue(Index m) const { return lowest_[m]; }
  [[nodiscard]] Weights family() const { return family_; }

 private:
  Weights family_;
  std::vector<std::vector<double>> weights_;  // by m; empty where no face has m vertices
  std::vector<double> lowest_;
};

/// Limit of the midpoint between corners i and i + 1 of a face, the share of this face: half of
/// the centroid of the new face that their edge makes. Calls add(corner, weight).
template <class Add>
void add_edge_limit(Weights family, Index m, Index i, Add&& add) {
  const std::vector<double> w = face_weights(family, m);
  for (Index k = 0; k < m; ++k) {
    const Index from_first = (k + m - i) % m;
    const Index from_second = (from_first + m - 1) % m;
    add(k, (w[from_first] + w[from_second]) / 4);
  }
}

}  // namespace surpass::doo_sabin

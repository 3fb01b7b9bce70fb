#include "scheme/doo_sabin_weights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surpass::doo_sabin {
namespace {

// cos(2 pi j / m), the same for j and m - j to the last bit.
double cosine(Index j, Index m) { return std::cos(2 * std::numbers::pi * std::min(j, m - j) / m); }

// Eigenvalue j of the averaging rule is 1/2 + cos(2 pi j / m) / 4 for j > 0, of the cosine rule 1/2
// for j = 1 and m - 1 and 1/4 in between.
double lowest(Weights family, Index m) {
  if (family == Weights::averaging) return 1.0 / 2 + cosine(m / 2, m) / 4;
  return m == 3 ? 1.0 / 2 : 1.0 / 4;
}

}  // namespace

std::vector<double> face_weights(Weights family, Index m) {
  const double share = 1.0 / (4.0 * m);
  std::vector<double> w(m, share);
  if (family == Weights::averaging) {
    w[0] += 1.0 / 2;
    w[1] += 1.0 / 8;
    w[m - 1] += 1.0 / 8;
    return w;
  }
  w[0] = 1.0 / 4 + 5 * share;
  for (Index j = 1; j < m; ++j) w[j] = (3 + 2 * cosine(j, m)) * share;
  return w;
}

WeightTable::WeightTable(const Topology& topology, Weights family) : family_(family) {
  Index most = 0;
  for (Index f = 0; f < topology.face_count(); ++f) most = std::max(most, topology.face_degree(f));
  weights_.resize(std::size_t{most} + 1);
  lowest_.resize(std::size_t{most} + 1);
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index m = topology.face_degree(f);
    if (!weights_[m].empty()) continue;
    weights_[m] = face_weights(family, m);
    lowest_[m] = lowest(family, m);
  }
}

}  // namespace surpass::doo_sabin

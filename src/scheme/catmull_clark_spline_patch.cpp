#include "scheme/catmull_clark_spline_patch.hpp"

namespace surpass::catmull_clark {
namespace {

using Four = std::array<double, 4>;

// Cubic B-spline weights in one parameter, and their derivatives.
struct Basis {
  Four value, first, second;
};

Basis uniform_basis(double t) {
  const double s = 1 - t;
  const double t2 = t * t;
  return {{s * s * s / 6, (t2 * (3 * t - 6) + 4) / 6, (3 * t * (1 + t * s) + 1) / 6, t2 * t / 6},
          {-s * s / 2, t * (3 * t - 4) / 2, (1 + t * (2 - 3 * t)) / 2, t2 / 2},
          {s, 3 * t - 2, 1 - 3 * t, t}};
}

// At a sharp edge the curve ends: what the row of points beyond would weigh goes to the edge's,
// twice, and from those inside. So the rules of boundaries come out.
void mirror(Four& weights, bool low, bool high) {
  if (low) {
    weights[1] += 2 * weights[0];
    weights[2] -= weights[0];
    weights[0] = 0;
  }
  if (high) {
    weights[2] += 2 * weights[3];
    weights[1] -= weights[3];
    weights[3] = 0;
  }
}

Basis basis(double t, bool low, bool high) {
  Basis b = uniform_basis(t);
  for (Four* weights : {&b.value, &b.first, &b.second}) mirror(*weights, low, high);
  return b;
}

// 4 by 4 points, u first; kNone beyond sharp edges.
using Grid = std::array<std::array<Index, 4>, 4>;

std::array<bool, 4> sharp_edges(const Neighbourhood& patch) {
  std::array<bool, 4> sharp = {};
  for (Index k = 0; k < 4; ++k) {
    sharp[k] = patch.sharpness().edge(patch.topology(), patch.topology().edge(k)) > 0;
  }
  return sharp;
}

Grid grid_points(const Topology& topology, const std::array<bool, 4>& sharp) {
  struct Step {
    int u, v;
  };
  constexpr std::array<Step, 4> kCorners = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  constexpr std::array<Step, 4> kBeyond = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};  // edge k
  Grid grid;
  for (auto& column : grid) column.fill(kNone);
  const auto put = [&](int u, int v, Index point) {
    grid[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)] = point;
  };
  for (Index k = 0; k < 4; ++k) {
    const Index before = (k + 3) % 4;
    const Step at = kCorners[k];
    const Step down = kBeyond[k];
    const Step back = kBeyond[before];
    put(at.u, at.v, topology.tail(k));
    if (!sharp[before]) {
      const Index across = topology.previous(topology.opposite(before));
      put(at.u + back.u, at.v + back.v, topology.tail(across));
    }
    if (sharp[k]) continue;
    const Index spoke = topology.next(topology.opposite(k));
    put(at.u + down.u, at.v + down.v, topology.head(spoke));
    if (sharp[before]) continue;
    const Index diagonal = topology.previous(topology.opposite(spoke));
    put(at.u + down.u + back.u, at.v + down.v + back.v, topology.tail(diagonal));
  }
  return grid;
}

}  // namespace

PlaceRows spline_patch_rows(const Neighbourhood& patch, double u, double v) {
  const std::array<bool, 4> sharp = sharp_edges(patch);
  const Grid grid = grid_points(patch.topology(), sharp);
  const Basis bu = basis(u, sharp[3], sharp[1]);
  const Basis bv = basis(v, sharp[0], sharp[2]);
  const auto product = [&](const Four& a, const Four& b) {
    Mask mask(patch.point_count(), 0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        if (grid[i][j] != kNone) mask[grid[i][j]] += a[i] * b[j];
      }
    }
    return mask;
  };
  PlaceRows rows;
  rows.position = product(bu.value, bv.value);
  rows.du = rows.tangent_u = product(bu.first, bv.value);
  rows.dv = rows.tangent_v = product(bu.value, bv.first);
  rows.duu = product(bu.second, bv.value);
  rows.duv = product(bu.first, bv.first);
  rows.dvv = product(bu.value, bv.second);
  return rows;
}

}  // namespace surpass::catmull_clark

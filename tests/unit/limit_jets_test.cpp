// Derivatives at samples: where the surface is a polynomial they are known exactly, and everywhere
// else refinement must not change them, apart from the change of parameters.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "quality/surface_curvature.hpp"
#include "scheme/subdivision_scheme.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

struct Quadratic {
  double a, b, c;  // z = a x^2 + b x y + c y^2
  [[nodiscard]] double at(double x, double y) const { return a * x * x + b * x * y + c * y * y; }
};

// The graph of a quadratic function as a surface of the scheme. B-splines and box splines reproduce
// it from its values less a constant, the function's mean over the basis function at 0: the second
// moments of (1, 4, 1) / 6, of the mask (6, 1, 1, 1, 1, 1, 1) / 12 and of (1, 6, 1) / 8 are 1/3,
// 1/4 and 1/4 in each direction.
Mesh graph_of(Scheme scheme, const Quadratic& q, Index n) {
  const double moment = scheme == Scheme::catmull_clark ? 1.0 / 3 : 1.0 / 4;
  Mesh mesh;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      double x = i - (n - 1) / 2.0;
      double y = j - (n - 1) / 2.0;
      if (scheme == Scheme::loop) {
        x += y / 2;  // a lattice of equilateral triangles
        y *= std::sqrt(3.0) / 2;
      }
      mesh.points.push_back({x, y, q.at(x, y) - moment * (q.a + q.c)});
    }
  }
  for (Index j = 0; j + 1 < n; ++j) {
    for (Index i = 0; i + 1 < n; ++i) {
      const Index v = j * n + i;
      if (scheme == Scheme::loop) {
        mesh.add_face(std::vector<Index>{v, v + 1, v + n});
        mesh.add_face(std::vector<Index>{v + 1, v + n + 1, v + n});
      } else {
        mesh.add_face(std::vector<Index>{v, v + 1, v + n + 1, v + n});
      }
    }
  }
  return mesh;
}

// Of the graph with the gradient (p, q): H = ((1 + q^2) r - 2 p q s + (1 + p^2) t) / (2 w^3) and
// K = (r t - s^2) / w^4, w^2 = 1 + p^2 + q^2.
std::pair<double, double> curvatures(const Quadratic& f, double x, double y) {
  const double p = 2 * f.a * x + f.b * y;
  const double q = f.b * x + 2 * f.c * y;
  const double r = 2 * f.a;
  const double s = f.b;
  const double t = 2 * f.c;
  const double w = std::sqrt(1 + p * p + q * q);
  const double mean = ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * w * w * w);
  const double gauss = (r * t - s * s) / (w * w * w * w);
  const double root = std::sqrt(mean * mean - gauss);
  return {mean - root, mean + root};
}

TEST(LimitJets, QuadraticGraphsHaveTheirExactCurvatures) {
  for (const Scheme scheme : all_schemes()) {
    for (const Quadratic q :
         {Quadratic{0.3, -0.2, 0.1}, {0.5, 0.7, -0.4}, {0, 1, 0}, {0.2, 0, 0}}) {
      const Mesh mesh = graph_of(scheme, q, 8);
      for (const int levels : {1, 2, 3}) {
        const auto samples = scheme_of(scheme).limit_samples(mesh, {scheme}, levels, {}).value();
        int regular = 0;
        for (std::size_t v = 0; v < samples.spots.size(); ++v) {
          if (samples.spots[v] != Spot::regular) continue;
          const Eigen::Vector3d& p = samples.jets[v].position;
          // Near the border the boundary rules bend the surface.
          if (std::abs(p[1]) > 1 || std::abs(p[0]) > 1) continue;
          EXPECT_NEAR(p[2], q.at(p[0], p[1]), 1e-13);
          const auto found = curvature_of(samples.jets[v]);
          ASSERT_TRUE(found);
          const auto [k1, k2] = curvatures(q, p[0], p[1]);
          EXPECT_NEAR(found->k1, k1, 1e-12) << name_of(scheme) << " level " << levels;
          EXPECT_NEAR(found->k2, k2, 1e-12) << name_of(scheme) << " level " << levels;
          const double slope = std::hypot(2 * q.a * p[0] + q.b * p[1], q.b * p[0] + 2 * q.c * p[1]);
          const double stretch = std::sqrt(1 + slope * slope);
          EXPECT_NEAR(found->area_element, stretch * std::ldexp(1, -2 * levels), 1e-14);
          EXPECT_NEAR(found->normal[2], 1 / stretch, 1e-13);
          ++regular;
        }
        EXPECT_GT(regular, 3 << levels) << name_of(scheme);
      }
    }
  }
}

// The jet at a vertex that stays in place, in the child's parameters: derivatives of order n shrink
// by 2^n. The first spoke need not be the same, so what does not depend on it is compared.
TEST(LimitJets, AreInvariantUnderRefinement) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    for (const int kind : {0, 1, 2, 3}) {
      const Mesh mesh = test::random_mesh_for(
          scheme, {.seed = 5, .kind = kind, .creases = 0.1, .semi_sharp = true});
      const auto coarse = scheme_of(scheme).limit_samples(mesh, {scheme}, 1, {}).value();
      const auto fine = scheme_of(scheme).limit_samples(mesh, {scheme}, 2, {}).value();
      int compared = 0;
      for (std::size_t v = 0; v < coarse.spots.size(); ++v) {
        if (coarse.spots[v] != Spot::regular) continue;
        ASSERT_EQ(fine.spots[v], Spot::regular);
        const LimitJet& a = coarse.jets[v];
        const LimitJet& b = fine.jets[v];
        EXPECT_LT((a.position - b.position).norm(), 1e-13);
        EXPECT_LT((a.u.cross(a.v) - 4 * b.u.cross(b.v)).norm(), 1e-13);
        EXPECT_LT((a.uu + a.vv - 4 * (b.uu + b.vv)).norm(), 1e-12);
        const auto square = [](const LimitJet& j) {
          return j.uu.squaredNorm() + 2 * j.uv.squaredNorm() + j.vv.squaredNorm();
        };
        EXPECT_NEAR(square(a), 16 * square(b), 1e-12);
        ++compared;
      }
      EXPECT_GT(compared, 10);
    }
  }
}

// A Doo-Sabin patch is a biquadratic polynomial, known by nine points of the deeply refined mesh:
// differences of these tend to its derivatives.
TEST(LimitJets, DooSabinJetsAreTheLimitOfDifferences) {
  const Mesh mesh = test::random_polygons({.seed = 8, .kind = 1});
  const Rules rules{Scheme::doo_sabin};
  const auto samples = scheme_of(rules.scheme).limit_samples(mesh, rules, 2, {}).value();
  const Topology topology = Topology::build(samples.mesh).value();
  int compared = 0;
  for (Index v = 0; v < topology.vertex_count() && compared < 40; ++v) {
    if (samples.spots[v] != Spot::regular) continue;
    // The nine control points by themselves, refined by the face rule of quads on a grid.
    const QuadRing ring = quad_ring(samples.mesh, topology, v);
    Eigen::Vector3d grid[3][3] = {{ring.across[2], ring.spokes[3], ring.across[3]},
                                  {ring.spokes[2], ring.center, ring.spokes[0]},
                                  {ring.across[1], ring.spokes[1], ring.across[0]}};
    // Where three intervals of the refined patch begin: the first step takes the four points around
    // the centre, each further one the three in the middle of six.
    constexpr int kSteps = 8;
    std::vector<std::vector<Eigen::Vector3d>> rows(3, std::vector<Eigen::Vector3d>(3));
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) rows[j][i] = grid[j][i];
    }
    const auto refined = [](const std::vector<Eigen::Vector3d>& p) {
      std::vector<Eigen::Vector3d> out;
      for (std::size_t k = 0; k + 1 < p.size(); ++k) {
        out.push_back((3 * p[k] + p[k + 1]) / 4);
        out.push_back((p[k] + 3 * p[k + 1]) / 4);
      }
      return out;
    };
    const auto transposed = [](const std::vector<std::vector<Eigen::Vector3d>>& m) {
      std::vector<std::vector<Eigen::Vector3d>> t(m[0].size());
      for (const auto& row : m) {
        for (std::size_t i = 0; i < row.size(); ++i) t[i].push_back(row[i]);
      }
      return t;
    };
    for (int step = 0; step < kSteps; ++step) {
      for (int side = 0; side < 2; ++side) {
        for (auto& row : rows) row = refined(row);
        rows = transposed(rows);
      }
    }
    // 2^steps + 2 points a side, the patch's own parameter from -1/2 to 1/2 between the second and
    // the last but one edge; an even number, so the centre lies between two of them.
    const std::size_t m = rows.size() / 2;
    const double h = std::ldexp(1, -kSteps);
    const Eigen::Vector3d& a = rows[m - 1][m - 1];
    const Eigen::Vector3d& b = rows[m - 1][m];
    const Eigen::Vector3d& c = rows[m][m - 1];
    const Eigen::Vector3d& d = rows[m][m];
    const LimitJet& jet = samples.jets[v];
    EXPECT_LT(((a + b + c + d) / 4 - jet.position).norm(), h * h);
    EXPECT_LT(((b + d - a - c) / (2 * h) - jet.u).norm(), 1e-10);
    EXPECT_LT(((c + d - a - b) / (2 * h) - jet.v).norm(), 1e-10);
    EXPECT_LT(((a + d - b - c) / (h * h) - jet.uv).norm(), 1e-8);
    // Second differences of a quadratic B-spline's control points are its derivatives.
    const auto second = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                            const Eigen::Vector3d& r) {
      return Eigen::Vector3d((p - 2 * q + r) / (h * h));
    };
    const Eigen::Vector3d uu =
        (second(rows[m - 1][m - 2], a, b) + second(a, b, rows[m - 1][m + 1]) +
         second(rows[m][m - 2], c, d) + second(c, d, rows[m][m + 1])) /
        4;
    EXPECT_LT((uu - jet.uu).norm(), 1e-8);
    ++compared;
  }
  EXPECT_EQ(compared, 40);
}

TEST(LimitJets, SpotsAreToldApart) {
  // 5 by 5 points: at level 1 a boundary of regular pieces with four corners.
  const Mesh grid = test::quad_grid(5, 5);
  const Rules rules{Scheme::catmull_clark};
  const auto samples = scheme_of(rules.scheme).limit_samples(grid, rules, 1, {}).value();
  EXPECT_EQ(std::count(samples.spots.begin(), samples.spots.end(), Spot::extraordinary), 0);
  EXPECT_EQ(std::count(samples.spots.begin(), samples.spots.end(), Spot::curve), 4 * 8);
  EXPECT_EQ(std::count(samples.spots.begin(), samples.spots.end(), Spot::regular), 7 * 7);

  const auto cube = scheme_of(rules.scheme).limit_samples(test::cube(), rules, 2, {}).value();
  EXPECT_EQ(std::count(cube.spots.begin(), cube.spots.end(), Spot::extraordinary), 8);
  Mesh creased = test::quad_grid(7, 7);
  creased.creases = {{{24, 25}, kInfinitelySharp}, {{25, 26}, kInfinitelySharp}};
  const auto darts = scheme_of(rules.scheme).limit_samples(creased, rules, 1, {}).value();
  EXPECT_EQ(std::count(darts.spots.begin(), darts.spots.end(), Spot::extraordinary), 2);
  EXPECT_EQ(darts.spots[25], Spot::curve);
}

}  // namespace
}  // namespace surpass

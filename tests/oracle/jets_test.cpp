// First and second derivatives at samples against OpenSubdiv's evaluator.
#include <cmath>

#include <gtest/gtest.h>

#include "osd.hpp"
#include "scheme/subdivision_scheme.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

Eigen::Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }

// The derivatives along a spoke and along the next one, from those along the first spoke and
// perpendicular to it.
test::OsdJet along(const LimitJet& jet, double from, double angle) {
  const auto point = [](const Eigen::Vector3d& v) { return Point{v[0], v[1], v[2]}; };
  const double c[2] = {std::cos(from), std::cos(from + angle)};
  const double s[2] = {std::sin(from), std::sin(from + angle)};
  const auto first = [&](int i) { return Eigen::Vector3d(c[i] * jet.u + s[i] * jet.v); };
  const auto second = [&](int i, int j) {
    return Eigen::Vector3d(c[i] * c[j] * jet.uu + (c[i] * s[j] + s[i] * c[j]) * jet.uv +
                           s[i] * s[j] * jet.vv);
  };
  return {.position = point(jet.position),
          .du = point(first(0)),
          .dv = point(first(1)),
          .duu = point(second(0, 0)),
          .duv = point(second(0, 1)),
          .dvv = point(second(1, 1))};
}

TEST(LimitJets, AreOpenSubdivs) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    const double angle = scheme == Scheme::loop ? M_PI / 3 : M_PI / 2;
    for (const int kind : {0, 1, 2, 3}) {
      const Mesh mesh = test::random_mesh_for(scheme, {.seed = 9, .kind = kind});
      const Rules rules{scheme};
      // Two levels, so that some faces have regular corners only.
      const auto samples = scheme_of(scheme).limit_samples(mesh, rules, 2, {}).value();
      const Topology topology = Topology::build(samples.mesh).value();
      int compared = 0;
      for (const test::OsdJet& theirs : test::osd_jets(samples.mesh, rules)) {
        const Index h = topology.face_begin(theirs.face);
        const Index v = topology.tail(h);
        if (!theirs.is_regular || samples.spots[v] != Spot::regular) continue;
        int spoke = 0;
        for (Index g = topology.outgoing(v); g != h; g = topology.rotate(g)) ++spoke;
        const test::OsdJet ours = along(samples.jets[v], spoke * angle, angle);
        EXPECT_LT((vector(ours.position) - vector(theirs.position)).norm(), 1e-12);
        EXPECT_LT((vector(ours.du) - vector(theirs.du)).norm(), 1e-12);
        EXPECT_LT((vector(ours.dv) - vector(theirs.dv)).norm(), 1e-12);
        EXPECT_LT((vector(ours.duu) - vector(theirs.duu)).norm(), 1e-12);
        EXPECT_LT((vector(ours.duv) - vector(theirs.duv)).norm(), 1e-12);
        EXPECT_LT((vector(ours.dvv) - vector(theirs.dvv)).norm(), 1e-12);
        ++compared;
      }
      EXPECT_GT(compared, 100) << name_of(scheme) << " " << kind;
    }
  }
}

}  // namespace
}  // namespace surpass

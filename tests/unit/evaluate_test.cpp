// The surface between its vertices: it is what refinement tends to, at vertices what their masks
// say, and derivatives go with the parameters.
#include <gtest/gtest.h>

#include "scheme/ring.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

constexpr std::array kBoundaries = {Boundary::edge_only, Boundary::edge_and_corner};

double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
Point times(double factor, const Point& p) { return {factor * p[0], factor * p[1], factor * p[2]}; }
double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Rules rules_with(Boundary boundary) { return {Scheme::catmull_clark, boundary}; }

template <class Use>
void for_each_sample(Use&& use) {
  for (const test::Sample& sample : test::polygon_samples()) {
    for (const Boundary boundary : kBoundaries) {
      SCOPED_TRACE(sample.name + ", " + name_of(boundary));
      use(sample.mesh, rules_with(boundary), sample.has_normals);
    }
  }
  for (const bool semi_sharp : {false, true}) {
    const test::RandomShape shape{.seed = 31, .kind = 3, .creases = 0.2, .semi_sharp = semi_sharp};
    SCOPED_TRACE(semi_sharp ? "semi-sharp" : "sharp");
    use(test::random_polygons(shape), rules_with(Boundary::edge_only), true);
  }
}

constexpr std::array<std::array<double, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

TEST(Evaluate, RefinedMeshesHaveTheSameLimitPoints) {
  for_each_sample([](const Mesh& mesh, const Rules& rules, bool) {
    const LimitSurface surface = LimitSurface::create(mesh, rules).value();
    // Quarter k of a face's quarter c, as refined twice.
    const Mesh once = refine(mesh, rules, 1).value();
    const Mesh twice = refine(once, rules, 1).value();
    const auto limits = limit_positions(twice, rules).value();
    std::vector<SurfacePlace> places;
    std::vector<Index> points;  // of `twice`
    for (Index face = 0; face < mesh.face_count(); ++face) {
      for (Index corner = 0; corner < mesh.face(face).size(); ++corner) {
        const Index child = mesh.face_offsets[face] + corner;
        for (Index k = 0; k < 4; ++k) {
          const auto& here = kCorners[k];
          const auto& next = kCorners[(k + 1) % 4];
          const auto fine = twice.face(4 * child + k);
          places.push_back({face, here[0], here[1], corner});
          points.push_back(fine[0]);
          places.push_back({face, (here[0] + next[0]) / 2, (here[1] + next[1]) / 2, corner});
          points.push_back(fine[1]);
        }
        places.push_back({face, 0.5, 0.5, corner});
        points.push_back(twice.face(4 * child)[2]);
      }
    }
    const auto samples = surface.evaluate(places).value();
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_LT(distance(samples[i].position, limits[points[i]]), 4e-14) << places[i].face;
    }
  });
}

TEST(Evaluate, RefinementChangesParametersOnly) {
  constexpr std::array<std::array<double, 2>, 4> kPlaces = {
      {{0.3, 0.6}, {0, 0.7}, {1e-4, 3e-5}, {0.99999, 0.999995}}};
  for_each_sample([&](const Mesh& mesh, const Rules& rules, bool) {
    const Mesh fine = refine(mesh, rules, 1).value();
    const LimitSurface surface = LimitSurface::create(mesh, rules).value();
    const LimitSurface refined = LimitSurface::create(fine, rules).value();
    std::vector<SurfacePlace> before;
    std::vector<SurfacePlace> after;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index corner = 0; corner < mesh.face(f).size(); ++corner) {
        for (const auto& [u, v] : kPlaces) {
          before.push_back({f, u, v, corner});
          after.push_back({mesh.face_offsets[f] + corner, u, v});
        }
      }
    }
    const auto coarse_samples = surface.evaluate(before).value();
    const auto fine_samples = refined.evaluate(after).value();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto& a = coarse_samples[i];
      const auto& b = fine_samples[i];
      EXPECT_LT(distance(a.position, b.position), 1e-14);
      EXPECT_LT(distance(a.du, b.du), 1e-13 * (1 + norm(a.du)));
      EXPECT_LT(distance(a.dv, b.dv), 1e-13 * (1 + norm(a.dv)));
      ASSERT_TRUE(a.second && b.second);
      EXPECT_LT(distance(a.second->uv, b.second->uv), 1e-10 * (1 + norm(a.second->uv)));
    }
  });
}

// Where a quad is given with and without a corner.
TEST(Evaluate, QuartersOfQuadsAreTurnedAndHalved) {
  const Mesh mesh = test::random_polygons({.seed = 6, .kind = 3, .creases = 0.15});
  const LimitSurface surface = LimitSurface::create(mesh, rules_with(Boundary::edge_only)).value();
  int quads = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != 4) continue;
    ++quads;
    const auto whole = surface.evaluate({f, 0.8, 0.3}).value();
    const auto quarter = surface.evaluate({f, 0.6, 0.4, 1}).value();  // 2 v, 2 (1 - u)
    EXPECT_LT(distance(whole.position, quarter.position), 1e-15);
    EXPECT_LT(distance(whole.du, times(-2, quarter.dv)), 1e-14);
    EXPECT_LT(distance(whole.dv, times(2, quarter.du)), 1e-14);
    EXPECT_LT(distance(whole.second->uu, times(4, quarter.second->vv)), 1e-13);
    EXPECT_LT(distance(whole.second->uv, times(-4, quarter.second->uv)), 1e-13);
    EXPECT_LT(distance(whole.second->vv, times(4, quarter.second->uu)), 1e-13);
    EXPECT_LT(distance(whole.normal, quarter.normal), 1e-13);
  }
  EXPECT_GT(quads, 3);
}

// One sector, so one normal.
bool has_one_plane(const Ring& ring) {
  const VertexRule rule = ring.rule();
  return rule == VertexRule::smooth || rule == VertexRule::dart || sectors(ring).size() == 1;
}

TEST(Evaluate, CornersAreTheVertices) {
  for_each_sample([](const Mesh& mesh, const Rules& rules, bool has_normals) {
    const LimitSurface surface = LimitSurface::create(mesh, rules).value();
    const auto limits = limit_positions(mesh, rules).value();
    const auto normals = limit_normals(mesh, rules).value();
    const Topology topology = Topology::build(mesh).value();
    const Sharpness sharpness = Sharpness::build(mesh, topology, rules.boundary).value();
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index corner = 0; corner < mesh.face(f).size(); ++corner) {
        const Index v = mesh.face(f)[corner];
        const auto at = surface.evaluate({f, 0, 0, corner}).value();
        EXPECT_LT(distance(at.position, limits[v]), 1e-14) << v;
        if (topology.is_bowtie(v) || !has_normals) continue;
        const Ring ring = Ring::around(topology, sharpness, v);
        if (ring.is_semi_sharp() || !has_one_plane(ring)) continue;
        if (ring.rule() == VertexRule::corner && sectors(ring).front().faces > 2) continue;
        EXPECT_LT(distance(at.normal, normals[v]), 1e-13) << v;
      }
    }
  });
}

TEST(Evaluate, QuadCornersAreInOrder) {
  const Mesh mesh = test::quad_grid(4, 4);
  const auto limits = limit_positions(mesh, rules_with(Boundary::edge_only)).value();
  const LimitSurface surface = LimitSurface::create(mesh, rules_with(Boundary::edge_only)).value();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = surface.evaluate({f, kCorners[k][0], kCorners[k][1]}).value();
      EXPECT_LT(distance(at.position, limits[mesh.face(f)[k]]), 1e-14);
    }
  }
}

// The tangents at a vertex of valence n are an eigenvector of refinement; its eigenvalue is known,
// and 1/2 for n = 4, where they are the derivatives.
TEST(Evaluate, TangentsAtIrregularVerticesShrinkByTheSubdominantEigenvalue) {
  for (const Index n : {3U, 5U, 6U, 7U, 12U}) {
    SCOPED_TRACE(n);
    const Rules rules = rules_with(Boundary::edge_only);
    const Mesh coarse = refine(test::bipyramid(n), rules, 1).value();
    const Mesh fine = refine(coarse, rules, 1).value();
    const double c = std::cos(2 * M_PI / n);
    const double eigenvalue = (5 + c + std::cos(M_PI / n) * std::sqrt(2 * (9 + c))) / 16;
    const LimitSurface before = LimitSurface::create(coarse, rules).value();
    const LimitSurface after = LimitSurface::create(fine, rules).value();
    for (Index f = 0; f < coarse.face_count(); ++f) {
      for (Index k = 0; k < 4; ++k) {
        if (coarse.face(f)[k] != n) continue;  // an apex
        const auto a = before.evaluate({f, kCorners[k][0], kCorners[k][1]}).value();
        const auto b = after.evaluate({4 * f + k, 0, 0}).value();
        EXPECT_FALSE(a.second);
        const bool turned = k % 2 == 1;  // parameters of quarter k, see the test above
        const Point u = times(k == 1 || k == 2 ? -1 : 1, turned ? b.dv : b.du);
        const Point v = times(k == 2 || k == 3 ? -1 : 1, turned ? b.du : b.dv);
        EXPECT_GT(norm(a.du), 0.1);
        EXPECT_LT(distance(times(eigenvalue, a.du), u), 1e-14);
        EXPECT_LT(distance(times(eigenvalue, a.dv), v), 1e-14);
      }
    }
  }
}

TEST(Evaluate, SharpCurvesHaveTheirDerivativesAtIrregularVertices) {
  // Vertex 0 has three faces, or two of one sharp curve's; beside it the patches are regular.
  Mesh mesh = test::quad_grid(4, 4);
  for (const Boundary boundary : kBoundaries) {
    mesh.corners = {{2, 10}, {13, 10}};
    mesh.creases = {{{1, 5}, 10}, {{5, 9}, 10}};
    const LimitSurface surface = LimitSurface::create(mesh, rules_with(boundary)).value();
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index k = 0; k < 4; ++k) {
        const auto at = surface.evaluate({f, 0, 0, k}).value();
        const auto along = surface.evaluate({f, 1e-9, 0, k}).value();
        if (norm(at.du) == 0) continue;  // no tangent of its own
        EXPECT_LT(distance(at.du, along.du), 1e-7) << f << " " << k;
      }
    }
  }
}

TEST(Evaluate, AnyDistanceIsExact) {
  const Mesh mesh = test::prism(5);  // valence 3
  const LimitSurface surface = LimitSurface::create(mesh, rules_with(Boundary::edge_only)).value();
  const SurfaceSample vertex = surface.evaluate({1, 0, 0}).value();
  for (const double t : {1e-3, 1e-6, 1e-12, 1e-50, 1e-300}) {
    const auto near = surface.evaluate({1, t, 0}).value();
    const Point d = {near.position[0] - vertex.position[0], near.position[1] - vertex.position[1],
                     near.position[2] - vertex.position[2]};
    // Distances go as t to the power log2(1 / eigenvalue), of valence 3.
    const double eigenvalue = (5 - 0.5 + 0.5 * std::sqrt(17.0)) / 16;
    const double power = -std::log2(eigenvalue);
    EXPECT_LT(norm(d), 3 * std::pow(t, power) + 1e-15);
    EXPECT_LT(distance(near.normal, vertex.normal), 10 * std::pow(t, power) + 1e-13) << t;
    EXPECT_TRUE(std::isfinite(norm(near.du)));
    const double tangent = norm(near.du) / std::pow(t, power - 1);
    EXPECT_GT(tangent, 0.1);  // the derivative shrinks as it should, and keeps its digits
    EXPECT_LT(tangent, 10);
  }
}

TEST(Evaluate, HolesAreEvaluatedLikeOtherFaces) {
  Mesh mesh = test::random_polygons({.seed = 4, .kind = 3});
  const Rules rules = rules_with(Boundary::edge_only);
  const auto before = LimitSurface::create(mesh, rules)->evaluate({2, 0.3, 0.4, 1}).value();
  mesh.hole_faces = {2, 3};
  const auto after = LimitSurface::create(mesh, rules)->evaluate({2, 0.3, 0.4, 1}).value();
  EXPECT_EQ(before.position, after.position);
  EXPECT_EQ(before.du, after.du);
}

TEST(Evaluate, RefusesWhatIsNoPlace) {
  const Mesh mesh = test::prism(5);  // side quads, then the pentagons
  const LimitSurface surface = LimitSurface::create(mesh, rules_with(Boundary::edge_only)).value();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SurfacePlace& place :
       {SurfacePlace{7, 0, 0}, SurfacePlace{5, 0.5, 0.5}, SurfacePlace{5, 0.5, 0.5, 5},
        SurfacePlace{0, 0.5, 0.5, 4}, SurfacePlace{0, -0.1, 0.5}, SurfacePlace{0, 0.5, 1.0001},
        SurfacePlace{0, nan, 0.5}}) {
    const auto result = surface.evaluate(place);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
    const auto many = surface.evaluate(std::vector{SurfacePlace{0, 0, 0}, place});
    ASSERT_FALSE(many);
    EXPECT_EQ(many.error().message, result.error().message);
  }
  for (const Scheme scheme : {Scheme::loop, Scheme::doo_sabin}) {
    const auto other = LimitSurface::create(test::octahedron(), Rules{scheme});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::invalid_argument);
  }
}

TEST(Evaluate, CanBeCancelled) {
  const LimitSurface surface = LimitSurface::create(test::cube(), rules_with({})).value();
  const std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  const auto result = surface.evaluate(std::vector<SurfacePlace>(10), context);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace surpass

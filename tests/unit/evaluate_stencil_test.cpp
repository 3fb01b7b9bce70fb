// Stencils: sums, affine invariance, digits far from the origin, the same bits however asked for.
#include <numeric>

#include <gtest/gtest.h>

#include "support/polygons.hpp"

namespace surpass {
namespace {

constexpr Rules kRules = {Scheme::catmull_clark, Boundary::edge_and_corner};

double sum(const std::vector<double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

Mesh creased_patch() {
  return test::random_polygons({.seed = 12, .kind = 3, .creases = 0.15, .semi_sharp = true});
}

std::vector<SurfacePlace> places_on(const Mesh& mesh) {
  std::vector<SurfacePlace> places;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index corner = 0; corner < mesh.face(f).size(); ++corner) {
      for (const double u : {0.0, 1e-9, 0.3, 1.0}) places.push_back({f, u, 0.6 * u, corner});
    }
  }
  return places;
}

TEST(EvaluateStencil, WeightsAddUp) {
  const Mesh mesh = creased_patch();
  const LimitSurface surface = LimitSurface::create(mesh, kRules).value();
  const auto stencils = surface.stencils(places_on(mesh)).value();
  for (const SurfaceStencil& s : stencils) {
    EXPECT_NEAR(sum(s.position), 1, 1e-14);
    for (const auto* d : {&s.du, &s.dv, &s.duu, &s.duv, &s.dvv, &s.tangent_u, &s.tangent_v}) {
      if (d->empty()) continue;
      ASSERT_EQ(d->size(), s.columns.size());
      const double largest = *std::max_element(d->begin(), d->end());
      EXPECT_NEAR(sum(*d), 0, 1e-14 * (1 + largest));
    }
    std::vector<Index> columns = s.columns;
    std::sort(columns.begin(), columns.end());
    EXPECT_EQ(std::adjacent_find(columns.begin(), columns.end()), columns.end());
  }
}

TEST(EvaluateStencil, AffineMapsOfTheControlMeshMapTheSurface) {
  const Mesh mesh = creased_patch();
  const auto map = [](const Point& p, double offset) {
    return Point{2 * p[0] - p[1] + 3 * offset, p[1] + 0.5 * p[2] - offset,
                 p[0] - 3 * p[2] + 2 * offset};
  };
  Mesh mapped = mesh;
  for (Point& p : mapped.points) p = map(p, 1);
  const auto places = places_on(mesh);
  const auto before = LimitSurface::create(mesh, kRules)->evaluate(places).value();
  const auto after = LimitSurface::create(mapped, kRules)->evaluate(places).value();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point position = map(before[i].position, 1);
    const Point du = map(before[i].du, 0);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(after[i].position[c], position[c], 1e-13);
      EXPECT_NEAR(after[i].du[c], du[c], 1e-12 * (1 + std::abs(du[c])));
    }
  }
}

TEST(EvaluateStencil, FarFromTheOriginNoDigitIsLost) {
  Mesh near = creased_patch();
  Mesh far = near;
  const double grid = std::ldexp(1.0, -20);
  const double offset = std::ldexp(1.0, 30);
  for (std::size_t v = 0; v < near.points.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      near.points[v][c] = std::round(near.points[v][c] / grid) * grid;  // so that sums are exact
      far.points[v][c] = near.points[v][c] + offset;
    }
  }
  const auto places = places_on(near);
  const auto a = LimitSurface::create(near, kRules)->evaluate(places).value();
  const auto b = LimitSurface::create(far, kRules)->evaluate(places).value();
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(a[i].du, b[i].du);
    EXPECT_EQ(a[i].normal, b[i].normal);
  }
}

TEST(EvaluateStencil, SameBitsOneByOneTogetherAndOnAnyNumberOfThreads) {
  const Mesh mesh = creased_patch();
  const LimitSurface surface = LimitSurface::create(mesh, kRules).value();
  const auto places = places_on(mesh);
  ASSERT_GT(places.size(), 800U);  // several chunks
  const auto one = surface.evaluate(places, {.threads = 1}).value();
  for (const int threads : {2, 3, 8}) {
    const auto many = surface.evaluate(places, {.threads = threads}).value();
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(one[i].position, many[i].position);
      ASSERT_EQ(one[i].dv, many[i].dv);
      ASSERT_EQ(one[i].normal, many[i].normal);
    }
  }
  for (std::size_t i = 0; i < places.size(); i += 7) {
    const auto alone = surface.evaluate(places[i]).value();
    EXPECT_EQ(one[i].position, alone.position);
    EXPECT_EQ(one[i].du, alone.du);
  }
}

}  // namespace
}  // namespace surpass

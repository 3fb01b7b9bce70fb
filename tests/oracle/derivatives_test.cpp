// The rows of sampled derivatives against OpenSubdiv's evaluator of surfaces at any parameter
// (Bfr).
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include "osd.hpp"
#include "scheme/catmull_clark_derivatives.hpp"
#include "scheme/patch_rows.hpp"
#include "support/polygons.hpp"

namespace surpass {
namespace {

namespace Bfr = OpenSubdiv::Bfr;

using Values = std::vector<Point>;

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point times(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

// What OpenSubdiv finds at the nine samples of one face, in parameters from 0 to 1.
struct Expected {
  Values first;
  Values second;
  Values mixed;
  Values third;  ///< differences of second derivatives between neighbouring samples
};

struct Derivatives {
  Point du, dv, duu, duv, dvv;
};

Expected expected_at(const Bfr::Surface<double>& surface, const std::vector<double>& patch,
                     const std::vector<bool>& extraordinary) {
  Derivatives at[3][3];
  Expected found;
  const auto is_extraordinary = [&](int i, int j) {
    if (i == 1 || j == 1) return false;
    return bool(extraordinary[i == 0 ? (j == 0 ? 0U : 3U) : (j == 0 ? 1U : 2U)]);
  };
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      if (is_extraordinary(i, j)) continue;
      const double uv[2] = {i / 2.0, j / 2.0};
      Point p;
      Derivatives& d = at[i][j];
      surface.Evaluate(uv, patch.data(), 3, p.data(), d.du.data(), d.dv.data(), d.duu.data(),
                       d.duv.data(), d.dvv.data());
      found.first.insert(found.first.end(), {d.du, d.dv});
      found.second.insert(found.second.end(), {d.duu, d.dvv});
      found.mixed.push_back(d.duv);
    }
  }
  for (int line = 0; line < 3; ++line) {
    for (int k = 0; k < 2; ++k) {
      if (!is_extraordinary(k, line) && !is_extraordinary(k + 1, line)) {
        found.third.push_back(times(2, minus(at[k + 1][line].duu, at[k][line].duu)));
      }
      if (!is_extraordinary(line, k) && !is_extraordinary(line, k + 1)) {
        found.third.push_back(times(2, minus(at[line][k + 1].dvv, at[line][k].dvv)));
      }
    }
  }
  return found;
}

// The distance to the nearest, but for the sign.
double nearest(const Point& value, const Values& others) {
  double best = HUGE_VAL;
  for (const Point& other : others) {
    best = std::min({best, length(minus(value, other)), length(minus(times(-1, value), other))});
  }
  return best;
}

double farthest(const Values& values, const Values& others) {
  double worst = 0;
  for (const Point& value : values) worst = std::max(worst, nearest(value, others));
  return worst;
}

struct Ours {
  Values first;
  Values second;
  Values mixed;
  Values third;
};

Ours ours_at(const PatchRows& rows, std::size_t patch, const std::vector<Point>& control) {
  Ours ours;
  const PatchKind& kind = rows.kind(patch);
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    Point value = {};
    for (std::size_t c = 0; c < kind.columns; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        value[k] += kind.row(r)[c] * control[rows.columns(patch)[c]][k];
      }
    }
    switch (kind.derivative[r]) {
      case Derivative::first: ours.first.push_back(value); break;
      case Derivative::second: ours.second.push_back(value); break;
      case Derivative::mixed: ours.mixed.push_back(value); break;
      case Derivative::third: ours.third.push_back(value); break;
    }
  }
  return ours;
}

class Patches {
 public:
  explicit Patches(Mesh control) : control_(std::move(control)) {
    topology_ = std::make_unique<Topology>(Topology::build(control_).value());
    rows_ = PatchRows::build(control_, *topology_, rules_, 1, {}, {}).value();
    refiner_ = test::osd_refiner(control_, rules_);
    factory_ = std::make_unique<Bfr::RefinerSurfaceFactory<>>(*refiner_);
  }

  // Checks face f; `one_way`: derivatives that OpenSubdiv has may lack here.
  void check(Index f, bool one_way, double tolerance) const {
    const std::unique_ptr<Bfr::Surface<double>> surface(
        factory_->CreateVertexSurface<double>(static_cast<int>(f)));
    std::vector<double> mesh;
    for (const Point& p : control_.points) mesh.insert(mesh.end(), p.begin(), p.end());
    std::vector<double> patch(3 * static_cast<std::size_t>(surface->GetNumPatchPoints()));
    surface->PreparePatchPoints(mesh.data(), {3, 3}, patch.data(), {3, 3});
    std::vector<bool> extraordinary;
    for (Index h = topology_->face_begin(f); h < topology_->face_end(f); ++h) {
      const Index v = topology_->tail(h);
      extraordinary.push_back(!topology_->is_boundary(v) && topology_->faces_at(v) != 4);
    }
    const Expected expected = expected_at(*surface, patch, extraordinary);
    Ours ours = ours_at(rows_, f, control_.points);
    // Tangents at extraordinary corners are tested by themselves.
    const bool has_tangents =
        std::find(extraordinary.begin(), extraordinary.end(), true) != extraordinary.end();
    if (!has_tangents) {
      EXPECT_LT(farthest(ours.first, expected.first), tolerance) << f;
    }
    EXPECT_LT(farthest(ours.second, expected.second), tolerance) << f;
    EXPECT_LT(farthest(ours.mixed, expected.mixed), tolerance) << f;
    EXPECT_LT(farthest(ours.third, expected.third), 8 * tolerance) << f;
    if (one_way) return;
    EXPECT_LT(farthest(expected.first, ours.first), tolerance) << f;
    EXPECT_LT(farthest(expected.second, ours.second), tolerance) << f;
    EXPECT_LT(farthest(expected.mixed, ours.mixed), tolerance) << f;
    EXPECT_LT(farthest(expected.third, ours.third), 8 * tolerance) << f;
  }

  [[nodiscard]] const Mesh& control() const { return control_; }
  [[nodiscard]] const Topology& topology() const { return *topology_; }

 private:
  Rules rules_ = {Scheme::catmull_clark};
  Mesh control_;
  std::unique_ptr<Topology> topology_;
  PatchRows rows_;
  std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner_;
  std::unique_ptr<Bfr::RefinerSurfaceFactory<>> factory_;
};

Mesh refined_once(const Mesh& mesh) { return refine(mesh, {Scheme::catmull_clark}, 1).value(); }

// Coordinates near 1.
Mesh normalised(Mesh mesh) {
  const double side = bounding_box(mesh.points).side();
  for (Point& p : mesh.points) p = times(1 / side, p);
  return mesh;
}

TEST(DerivativeRows, AreOpenSubdivsOnClosedMeshes) {
  std::mt19937_64 random(5);
  for (const int kind : {0, 1}) {
    const Mesh given = test::random_polygons({.seed = 11, .kind = kind, .size = 6});
    const Patches patches(normalised(test::jitter(refined_once(given), random, 0.02)));
    for (Index f = 0; f < patches.control().face_count(); ++f) patches.check(f, false, 1e-12);
  }
}

TEST(DerivativeRows, AreOpenSubdivsAtBoundariesWhereThereAreAny) {
  std::mt19937_64 random(6);
  for (const Mesh& given : {test::quad_grid(5, 4), test::random_polygons({.seed = 3, .kind = 2})}) {
    const Patches patches(normalised(test::jitter(refined_once(given), random, 0.02)));
    for (Index f = 0; f < patches.control().face_count(); ++f) {
      bool near_boundary = false;
      for (const Index v : patches.control().face(f)) {
        near_boundary = near_boundary || patches.topology().is_boundary(v);
      }
      patches.check(f, near_boundary, 1e-12);
    }
  }
}

TEST(DerivativeRows, AreOpenSubdivsAtCreases) {
  std::mt19937_64 random(7);
  Mesh given = test::quad_grid(7, 7);
  for (Index k = 0; k + 1 < 7; ++k) given.creases.push_back({{21 + k, 22 + k}});
  const Patches patches(normalised(test::jitter(refined_once(given), random, 0.02)));
  for (Index f = 0; f < patches.control().face_count(); ++f) patches.check(f, true, 1e-12);
}

// The tangent is a left eigenvector of the refinement around the vertex, for the eigenvalue of the
// tangent plane, whatever the control points are.
TEST(DerivativeRows, TangentsAtExtraordinaryVerticesAreEigenvectors) {
  for (const Index n : {3U, 5U, 6U, 7U, 12U, 40U}) {
    Mesh mesh = refined_once(test::prism(n));
    const Index pole = mesh.vertex_count() - 1;  // in the middle of an n-gon
    std::mt19937_64 random(n);
    mesh = test::jitter(mesh, random, 0.3);
    const Mesh fine = refined_once(mesh);
    const double c = std::cos(2 * M_PI / n);
    const double eigenvalue = (5 + c + std::cos(M_PI / n) * std::sqrt(2 * (9 + c))) / 16;
    const auto tangents = [&](const Mesh& m) {
      const auto topology = Topology::build(m).value();
      const auto sharpness = Sharpness::build(m, topology, Boundary::edge_and_corner).value();
      const auto ring = catmull_clark::FaceRing::around(topology, sharpness, pole);
      std::vector<Point> found;
      for (std::size_t s = 0; s < n; ++s) {
        const auto mask = catmull_clark::tangent_along(ring, s).value();
        Point& sum = found.emplace_back(Point{});
        for (std::size_t i = 0; i < mask.size(); ++i) {
          for (std::size_t k = 0; k < 3; ++k) sum[k] += mask[i] * m.points[ring.columns[i]][k];
        }
      }
      return found;
    };
    const auto coarse = tangents(mesh);
    for (const Point& tangent : tangents(fine)) {
      double best = HUGE_VAL;
      for (const Point& t : coarse) {
        best = std::min(best, length(minus(tangent, times(eigenvalue, t))));
      }
      EXPECT_LT(best, 1e-14) << n;
    }
  }
}

}  // namespace
}  // namespace surpass

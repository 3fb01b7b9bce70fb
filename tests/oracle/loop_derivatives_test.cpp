// The rows of sampled derivatives of Loop surfaces against OpenSubdiv's evaluator of surfaces at
// any parameter (Bfr).
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include "osd_refiner.hpp"
#include "scheme/patch_rows.hpp"
#include "support/vectors.hpp"

namespace surpass {
namespace {

namespace Bfr = OpenSubdiv::Bfr;

using test::size_of;
using test::unlike;
using test::Values;
using test::weighted_sum;

// First, second and third derivatives along the three sides; the thin plate's integral by the same
// rule is a number of its own.
struct Found {
  Values first;
  Values second;
  Values third;
  double thin_plate = 0;
};

// At the six samples of a triangle: along u, along v, and from the one to the other.
Found by_opensubdiv(const Bfr::Surface<double>& surface, const Values& control) {
  std::vector<double> mesh;
  for (const Point& p : control) mesh.insert(mesh.end(), p.begin(), p.end());
  std::vector<double> patch(3 * static_cast<std::size_t>(surface.GetNumPatchPoints()));
  surface.PreparePatchPoints(mesh.data(), {3, 3}, patch.data(), {3, 3});
  Found found;
  Point second[3][3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i + j < 3; ++i) {
      const double uv[2] = {i / 2.0, j / 2.0};
      Point p, du, dv, duu, duv, dvv;
      surface.Evaluate(uv, patch.data(), 3, p.data(), du.data(), dv.data(), duu.data(), duv.data(),
                       dvv.data());
      found.first.insert(found.first.end(), {du, dv, weighted_sum(1, dv, -1, du)});
      second[i][j][0] = duu;
      second[i][j][1] = weighted_sum(1, weighted_sum(1, duu, -2, duv), 1, dvv);
      second[i][j][2] = dvv;
      found.second.insert(found.second.end(), second[i][j], second[i][j] + 3);
      // With a right angle and sides of length 1: x = u + v / 2, y = sqrt(3) / 2 v.
      const Point xy = weighted_sum(2 / std::sqrt(3.0), duv, -1 / std::sqrt(3.0), duu);
      const Point yy = weighted_sum(4.0 / 3, weighted_sum(1, dvv, -1, duv), 1.0 / 3, duu);
      const double bending =
          std::pow(size_of(duu), 2) + 2 * std::pow(size_of(xy), 2) + std::pow(size_of(yy), 2);
      const int ends = (i == 0 ? 1 : 0) + (j == 0 ? 1 : 0) + (i + j == 2 ? 1 : 0);
      found.thin_plate += bending * (ends == 2 ? 1.0 : 3.0) / 12;
    }
  }
  constexpr int kSteps[3][2] = {{1, 0}, {-1, 1}, {0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i + j < 3; ++i) {
        const int a = i + kSteps[axis][0];
        const int b = j + kSteps[axis][1];
        if (a < 0 || a + b > 2) continue;
        found.third.push_back(weighted_sum(2, second[a][b][axis], -2, second[i][j][axis]));
      }
    }
  }
  return found;
}

Found by_rows(const PatchRows& rows, std::size_t patch, const Values& control) {
  Found found;
  const PatchKind& kind = rows.kind(patch);
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    Point value = {};
    for (std::size_t c = 0; c < kind.columns; ++c) {
      value = weighted_sum(1, value, kind.row(r)[c], control[rows.columns(patch)[c]]);
    }
    switch (kind.derivative[r]) {
      case Derivative::first: found.first.push_back(value); break;
      case Derivative::second: found.second.push_back(value); break;
      case Derivative::mixed:
        found.thin_plate += 2 * kind.area[r] * std::pow(size_of(value), 2);
        break;
      case Derivative::third: found.third.push_back(value); break;
    }
  }
  return found;
}

// The faces whose corners all are regular, inside or, if `open`, on the boundary, too.
int compare_regular_faces(const Mesh& control, bool open) {
  const Rules rules;
  const auto topology = Topology::build(control).value();
  const auto rows = PatchRows::build(control, topology, rules, 1, {}, {}).value();
  const auto refiner = test::osd_refiner(control, rules, 0);
  const Bfr::RefinerSurfaceFactory<> factory(*refiner);
  int compared = 0;
  for (Index f = 0; f < control.face_count(); ++f) {
    const auto face = control.face(f);
    const bool regular = std::all_of(face.begin(), face.end(), [&](Index v) {
      return topology.is_boundary(v) ? open && topology.faces_at(v) == 3
                                     : topology.faces_at(v) == 6;
    });
    if (!regular) continue;
    ++compared;
    const std::unique_ptr<Bfr::Surface<double>> surface(
        factory.CreateVertexSurface<double>(static_cast<int>(f)));
    const Found theirs = by_opensubdiv(*surface, control.points);
    const Found ours = by_rows(rows, f, control.points);
    EXPECT_EQ(ours.first.size(), theirs.first.size());
    EXPECT_EQ(ours.second.size(), theirs.second.size());
    EXPECT_EQ(ours.third.size(), theirs.third.size());
    EXPECT_LT(unlike(ours.first, theirs.first), 1e-12) << f;
    EXPECT_LT(unlike(theirs.first, ours.first), 1e-12) << f;
    EXPECT_LT(unlike(ours.second, theirs.second), 1e-12) << f;
    EXPECT_LT(unlike(theirs.second, ours.second), 1e-12) << f;
    EXPECT_LT(unlike(ours.third, theirs.third), 1e-11) << f;
    EXPECT_LT(unlike(theirs.third, ours.third), 1e-11) << f;
    EXPECT_NEAR(ours.thin_plate, theirs.thin_plate, 1e-11 * theirs.thin_plate) << f;
  }
  return compared;
}

TEST(LoopDerivativeRows, AreOpenSubdivsAtRegularFaces) {
  std::mt19937_64 random(5);
  const Mesh given = test::random_mesh({.seed = 11, .kind = 0, .size = 6});
  const Mesh control = test::jitter(refine(given, {}, 2).value(), random, 0.02);
  EXPECT_GT(compare_regular_faces(control, false), 20);
}

TEST(LoopDerivativeRows, AreOpenSubdivsAtRegularBoundaries) {
  std::mt19937_64 random(6);
  const Mesh control = test::jitter(test::triangle_grid(8, 7), random, 0.02);
  const int inside = compare_regular_faces(control, false);
  EXPECT_GT(compare_regular_faces(control, true), inside);
}

// Around an extraordinary vertex the tangents are left eigenvectors of refinement, for the
// eigenvalue 3/8 + cos(2 pi / n) / 4 of its tangent plane.
TEST(LoopDerivativeRows, TangentsAtExtraordinaryVerticesAreEigenvectors) {
  for (const Index n : {3U, 4U, 5U, 7U, 9U, 20U}) {
    std::mt19937_64 random(n);
    const Mesh mesh = test::jitter(refine(test::bipyramid(n), {}, 1).value(), random, 0.3);
    const Mesh fine = refine(mesh, {}, 1).value();
    const Index pole = n;
    const auto tangents = [&](const Mesh& m) {
      const auto topology = Topology::build(m).value();
      const auto rows = PatchRows::build(m, topology, {}, 1, {}, {}).value();
      Values found;
      for (Index f = 0; f < m.face_count(); ++f) {
        const auto face = m.face(f);
        if (std::find(face.begin(), face.end(), pole) == face.end()) continue;
        const Values all = by_rows(rows, f, m.points).first;
        found.insert(found.end(), all.begin(), all.end());
      }
      return found;
    };
    ASSERT_EQ(Topology::build(mesh).value().faces_at(pole), n);
    const double eigenvalue = 3.0 / 8 + std::cos(2 * std::acos(-1.0) / n) / 4;
    const Values coarse = tangents(mesh);
    int matched = 0;
    for (const Point& t : tangents(fine)) {
      double best = HUGE_VAL;
      for (const Point& c : coarse)
        best = std::min(best, size_of(weighted_sum(1, t, -eigenvalue, c)));
      matched += best < 1e-14 ? 1 : 0;
    }
    EXPECT_GE(matched, static_cast<int>(2 * n)) << n;
  }
}

}  // namespace
}  // namespace surpass

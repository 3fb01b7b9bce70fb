#include <surpass/quality.hpp>
#include <surpass/repair.hpp>

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

Mesh moved(Mesh mesh, const Point& t, double scale = 1) {
  for (Point& p : mesh.points) {
    p = {p[0] * scale + t[0], p[1] * scale + t[1], p[2] * scale + t[2]};
  }
  return mesh;
}

Deviation measured(const Mesh& a, const Mesh& b, double accuracy = 1e-5) {
  const auto result = deviation(a, b, accuracy);
  EXPECT_TRUE(result) << describe(result.error());
  return result ? *result : Deviation{};
}

// The value lies between the distance found and its bound, and these are as close as was asked.
void expect_between(double value, const OneSided& d, double accuracy) {
  EXPECT_LE(d.max, value + 1e-14);
  EXPECT_GE(d.max_bound, value - 1e-14);
  EXPECT_LE(d.max_bound - d.max, accuracy);
}

// An octahedron refined towards the unit sphere.
Mesh sphere(int levels) {
  Mesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Face& f : std::vector<Face>{{0, 2, 4},
                                         {2, 1, 4},
                                         {1, 3, 4},
                                         {3, 0, 4},
                                         {2, 0, 5},
                                         {1, 2, 5},
                                         {3, 1, 5},
                                         {0, 3, 5}}) {
    mesh.add_face(f);
  }
  for (int level = 0; level < levels; ++level) {
    Mesh fine;
    fine.points = mesh.points;
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [at, isnew] = middles.try_emplace(std::minmax(a, b), fine.vertex_count());
      if (isnew) {
        Point p = {};
        for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.points[a][k] + mesh.points[b][k];
        const double r = std::hypot(p[0], p[1], p[2]);
        fine.points.push_back({p[0] / r, p[1] / r, p[2] / r});
      }
      return at->second;
    };
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Index a = mesh.face(f)[0];
      const Index b = mesh.face(f)[1];
      const Index c = mesh.face(f)[2];
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      for (const Face& t : std::vector<Face>{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
        fine.add_face(t);
      }
    }
    mesh = fine;
  }
  return mesh;
}

TEST(Deviation, OfAMeshFromItselfIsZero) {
  for (const Mesh& mesh : {samples::cube(), samples::torus(20, 11, false), sphere(3)}) {
    const Deviation d = measured(mesh, mesh);
    EXPECT_LE(d.hausdorff_bound, 1e-15 * d.box_side);
    EXPECT_LE(d.a_to_b.mean, 1e-15 * d.box_side);
    EXPECT_LE(d.b_to_a.rms, 1e-15 * d.box_side);
  }
}

TEST(Deviation, SameSurfaceCutDifferently) {
  // Edges of the two cross everywhere; only cutting along them can show that the distance is 0.
  const Deviation d = measured(moved(samples::grid(7), {0, 0, 0}, 1.0 / 7), samples::grid(1));
  EXPECT_LE(d.hausdorff_bound, 1e-5);
  const Deviation e = measured(moved(samples::grid(17), {0, 0, 0}, 1.0 / 17),
                               moved(samples::grid(13), {0, 0, 0}, 1.0 / 13), 1e-7);
  EXPECT_LE(e.hausdorff_bound, 1e-7);
  EXPECT_LE(e.a_to_b.mean, 1e-7);
}

TEST(Deviation, OfParallelPlanesIsTheirDistance) {
  const Deviation d = measured(samples::grid(3), moved(samples::grid(3), {0, 0, 0.25}));
  for (const OneSided& side : {d.a_to_b, d.b_to_a}) {
    EXPECT_DOUBLE_EQ(side.max, 0.25);
    EXPECT_NEAR(side.mean, 0.25, 1e-12);
    EXPECT_NEAR(side.rms, 0.25, 1e-12);
    expect_between(0.25, side, 3e-5);
  }
  EXPECT_DOUBLE_EQ(d.box_side, 3);
}

TEST(Deviation, OfATranslatedPlaneIsOneSidedAtItsEdge) {
  // The unit square moved by 0.5 in its plane: half of it is covered, beyond that the distance
  // grows from 0 to 0.5. Mean: 0.5 * 0.25; mean square: 0.5 * 0.25 / 3.
  const Deviation d = measured(samples::grid(1), moved(samples::grid(1), {0.5, 0, 0}), 1e-6);
  expect_between(0.5, d.a_to_b, 1e-6);
  EXPECT_NEAR(d.a_to_b.mean, 0.125, 1e-6);
  EXPECT_NEAR(d.a_to_b.rms, std::sqrt(0.125 / 3), 1e-4);
  EXPECT_NEAR(d.a_to_b.at[0], 0, 1e-12);
  EXPECT_NEAR(d.b_to_a.at[0], 1.5, 1e-12);
}

TEST(Deviation, OfConcentricCubes) {
  const Mesh inner = moved(samples::cube(), {-0.5, -0.5, -0.5});
  const Mesh outer = moved(inner, {0, 0, 0}, 1.5);
  const Deviation d = measured(inner, outer);
  expect_between(0.25, d.a_to_b, 1e-5);
  EXPECT_NEAR(d.a_to_b.mean, 0.25, 1e-12);
  expect_between(0.25 * std::sqrt(3.0), d.b_to_a, 1e-5);
  EXPECT_NEAR(std::abs(d.b_to_a.at[0]), 0.75, 1e-12);
  // Mean square from outside: 1/16 and the mean of the squares of what hangs over on two axes,
  // each the integral of s^2 over two strips of 0.25, over the side 1.5.
  const double overhang = 2 * std::pow(0.25, 3) / 3 / 1.5;
  EXPECT_NEAR(d.b_to_a.rms, std::sqrt(1.0 / 16 + 2 * overhang), 1e-5);
  EXPECT_EQ(d.hausdorff, d.b_to_a.max);
  EXPECT_EQ(d.hausdorff_bound, d.b_to_a.max_bound);
}

TEST(Deviation, SeesASpikeBetweenVertices) {
  // All four vertices of the plate lie on the other surface, which has a hole in the middle.
  const Mesh plate = samples::grid(1);
  Mesh holed;
  const Mesh fine = moved(samples::grid(9), {0, 0, 0}, 1.0 / 9);
  holed.points = fine.points;
  for (Index f = 0; f < fine.face_count(); ++f) {
    if (f != 40) holed.add_face(fine.face(f));
  }
  const Deviation hole = measured(plate, holed, 1e-6);
  expect_between(1.0 / 18, hole.a_to_b, 1e-6);
  EXPECT_LE(hole.b_to_a.max_bound, 1e-6);

  // A needle of height 0.3 stands on the plate.
  Mesh spiked = fine;
  const Index tip = spiked.vertex_count();
  spiked.points.push_back({0.5, 0.5, 0.3});
  spiked.points.push_back({0.5001, 0.5, 0});
  spiked.points.push_back({0.5, 0.5001, 0});
  spiked.add_face(Face{tip, tip + 1, tip + 2});
  const Deviation spike = measured(plate, spiked, 1e-6);
  EXPECT_LE(spike.a_to_b.max_bound, 1e-6);
  expect_between(0.3, spike.b_to_a, 1e-6);
  EXPECT_EQ(spike.b_to_a.at, (Point{0.5, 0.5, 0.3}));
}

TEST(Deviation, OfCoarseSpheresLiesWithinTheSagitta) {
  const Mesh coarse = sphere(2);
  const Mesh fine = sphere(5);
  double coarse_sag = 0;
  double fine_sag = 0;
  const auto sag = [](const Mesh& mesh) {
    double largest = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      Point centre = {};
      for (const Index v : mesh.face(f)) {
        for (std::size_t k = 0; k < 3; ++k) centre[k] += mesh.points[v][k] / 3;
      }
      largest = std::max(largest, 1 - std::hypot(centre[0], centre[1], centre[2]));
    }
    return largest;
  };
  coarse_sag = sag(coarse);
  fine_sag = sag(fine);
  const Deviation d = measured(coarse, fine);
  // The centres of the coarse faces are coarse_sag below the sphere, and the fine one is at most
  // fine_sag below it.
  for (const OneSided& side : {d.a_to_b, d.b_to_a}) {
    EXPECT_LE(side.max, coarse_sag + 1e-12);
    EXPECT_GE(side.max_bound, coarse_sag - fine_sag);
    EXPECT_LE(side.max_bound - side.max, 1e-5 * d.box_side);
    EXPECT_LT(side.mean, side.rms);
    EXPECT_LT(side.rms, side.max);
  }
}

TEST(Deviation, SwapsWithItsArguments) {
  const Mesh a = samples::torus(12, 9, false);
  const Mesh b = moved(samples::torus(13, 8, false), {0.1, 0.05, 0});
  const double accuracy = 1e-4;
  const double sides = bounding_box(a.points).side() / bounding_box(b.points).side();
  const Deviation ab = measured(a, b, accuracy);
  const Deviation ba = measured(b, a, accuracy * sides);
  EXPECT_NEAR(ab.hausdorff, ba.hausdorff, accuracy * ab.box_side);
  EXPECT_NEAR(ab.a_to_b.mean, ba.b_to_a.mean, 1e-4);
  EXPECT_NEAR(ab.b_to_a.rms, ba.a_to_b.rms, 1e-4);
}

TEST(Deviation, OfATranslationIsAtMostItsLength) {
  const Mesh mesh = sphere(3);
  const Point t = {0.02, -0.05, 0.04};
  const Deviation d = measured(mesh, moved(mesh, t));
  EXPECT_LE(d.hausdorff, std::hypot(t[0], t[1], t[2]) + 1e-15);
  EXPECT_GE(d.hausdorff_bound, 0.95 * std::hypot(t[0], t[1], t[2]));
}

TEST(Deviation, ScalesWithTheMeshes) {
  const Deviation one = measured(samples::cube(), moved(samples::cube(), {0.1, 0.2, 0.3}), 1e-3);
  for (const double scale : {0x1p500, 0x1p-700}) {
    const Deviation d =
        measured(moved(samples::cube(), {0, 0, 0}, scale),
                 moved(moved(samples::cube(), {0.1, 0.2, 0.3}), {0, 0, 0}, scale), 1e-3);
    EXPECT_EQ(d.hausdorff, one.hausdorff * scale);
    EXPECT_EQ(d.hausdorff_bound, one.hausdorff_bound * scale);
    EXPECT_EQ(d.a_to_b.mean, one.a_to_b.mean * scale);
  }
}

TEST(Deviation, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh a = sphere(2);
  const Mesh b = moved(samples::torus(12, 6, false), {0.3, 0, 0}, 0.4);
  const auto on = [&](int threads) { return *deviation(a, b, 1e-2, Context{.threads = threads}); };
  const Deviation one = on(1);
  for (const int threads : {2, 3, 8}) {
    const Deviation d = on(threads);
    EXPECT_EQ(d.hausdorff, one.hausdorff);
    EXPECT_EQ(d.hausdorff_bound, one.hausdorff_bound);
    EXPECT_EQ(d.a_to_b.mean, one.a_to_b.mean);
    EXPECT_EQ(d.b_to_a.rms, one.b_to_a.rms);
    EXPECT_EQ(d.a_to_b.at, one.a_to_b.at);
  }
}

TEST(Deviation, TakesDegenerateFaces) {
  Mesh line = samples::faces(3, {{0, 1, 2}});
  line.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  const Deviation d = measured(line, moved(line, {0, 0, 2}));
  expect_between(2, d.a_to_b, 1e-5);
  Mesh point = line;
  point.points.assign(3, {0, 3, 0});
  expect_between(std::sqrt(10.0), measured(line, point).a_to_b, 1e-5);
  expect_between(3, measured(point, line).a_to_b, 1e-5);
}

TEST(Deviation, RefusesWhatIsNoSurface) {
  Mesh empty;
  EXPECT_EQ(deviation(empty, samples::cube()).error().code, ErrorCode::empty_mesh);
  EXPECT_EQ(deviation(samples::cube(), empty).error().code, ErrorCode::empty_mesh);
  Mesh bad = samples::cube();
  bad.points[3][1] = std::nan("");
  EXPECT_EQ(deviation(samples::cube(), bad).error().place.vertex, 3U);
  bad = samples::cube();
  bad.face_vertices[9] = 8;
  EXPECT_EQ(deviation(bad, samples::cube()).error().code, ErrorCode::index_out_of_range);
  EXPECT_EQ(deviation(samples::cube(), samples::cube(), 0).error().code,
            ErrorCode::invalid_argument);
  const std::atomic<bool> stop{true};
  EXPECT_EQ(deviation(sphere(2), sphere(3), 1e-5, Context{.cancel = &stop}).error().code,
            ErrorCode::cancelled);
}

}  // namespace
}  // namespace surpass

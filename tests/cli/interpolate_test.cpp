// `surpass interpolate` by the progressive method, and `surpass predict`, held against values found
// in another way.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

using Words = std::vector<std::string>;

// The mask of a regular vertex of valence 4 is 24/55 at the vertex and 31/55 shared by its
// neighbours, whose sum is zero in the octahedron; so L is 24/55 there and x = 55/24 v.
TEST(Interpolate, TheOctahedronHasAKnownControlMesh) {
  const TempFolder folder;
  const std::string given = data("octahedron.obj");
  const nlohmann::json report =
      report_of({"interpolate", given, "-o", folder / "c.obj", "--tolerance", "1e-14"});
  const Mesh control = mesh_of(folder / "c.obj");
  const Mesh original = mesh_of(given);
  ASSERT_EQ(control.face_vertices, original.face_vertices);
  for (Index v = 0; v < 6; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(control.points[v][k], original.points[v][k] * 55 / 24, 1e-13);
    }
  }
  const double initial = 31.0 / 55.0 / 2.0;  // relative to the box side, 2
  EXPECT_NEAR(report["error"]["initial_max"].get<double>(), initial, 1e-15);
  EXPECT_NEAR(report["error"]["initial_mean"].get<double>(), initial, 1e-15);
  double largest = 0;
  for (Index v = 0; v < 6; ++v) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = control.points[v][k] * 24 / 55 - original.points[v][k];
      square += d * d;
    }
    largest = std::max(largest, std::sqrt(square) / 2);
  }
  EXPECT_NEAR(report["error"]["max"].get<double>(), largest, 2e-16);
  EXPECT_EQ(report["input"]["box_side"], 2.0);
  EXPECT_EQ(control.annotation("scheme"), "loop");
  EXPECT_EQ(control.annotation("boundary"), "edge-and-corner");
}

TEST(Interpolate, EverySolverFindsTheSameControlMesh) {
  const TempFolder folder;
  for (const char* solver : {"chebyshev", "richardson", "conjugate-gradient", "gauss-seidel"}) {
    const std::string path = folder / (std::string(solver) + ".obj");
    EXPECT_EQ(surpass({"interpolate", data("sphere_irregular.obj"), "-o", path, "--tolerance",
                       "1e-13", "--solver", solver})
                  .status,
              0);
  }
  const Mesh expected = mesh_of(folder / "chebyshev.obj");
  for (const char* solver : {"richardson", "conjugate-gradient", "gauss-seidel"}) {
    const Mesh found = mesh_of(folder / (std::string(solver) + ".obj"));
    double largest = 0;
    for (Index v = 0; v < expected.vertex_count(); ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(found.points[v][k] - expected.points[v][k]));
      }
    }
    EXPECT_LT(largest, 1e-11) << solver;  // the inverse of L is below 10
  }
}

// The cube's equations are singular, but not contradictory: nothing is said of what time did not
// allow to find.
TEST(Interpolate, IterationsThatRanOutAreNoProof) {
  const TempFolder folder;
  const Words words = {"interpolate", data("cube.obj"), "-o", folder / "c.obj"};
  ASSERT_EQ(surpass(words).status, 0);
  Words cut = words;
  cut.insert(cut.end(), {"--max-iterations", "1"});
  const Outcome outcome = surpass(cut);
  EXPECT_EQ(outcome.status, 4);
  EXPECT_EQ(outcome.err.find("no control mesh"), std::string::npos) << outcome.err;
}

TEST(Interpolate, TheBitsDoNotDependOnTheThreads) {
  const TempFolder folder;
  const std::string grid = folder.file("grid.off", grid_off(120));  // several chunks of vertices
  std::string expected;
  for (const char* threads : {"1", "2", "3", "8"}) {
    const std::string control = folder / "c.ply";
    const std::string surface = folder / "s.ply";
    ASSERT_EQ(surpass({"interpolate", grid, "-o", control, "--surface", surface, "--levels", "1",
                       "--threads", threads})
                  .status,
              0);
    const std::string bytes = slurp(control) + slurp(surface);
    if (expected.empty()) expected = bytes;
    EXPECT_TRUE(bytes == expected) << threads << " threads";
  }
}

TEST(Interpolate, TheSurfacePassesThroughTheGivenVertices) {
  const TempFolder folder;
  const std::string given = data("disc.ply");
  ASSERT_EQ(surpass({"interpolate", given, "-o", folder / "c.ply", "--surface", folder / "s.ply",
                     "--levels", "2"})
                .status,
            0);
  const Mesh original = mesh_of(given);
  const Mesh surface = mesh_of(folder / "s.ply");
  EXPECT_EQ(surface.face_count(), 16 * original.face_count());
  EXPECT_EQ(surface.annotation("scheme"), "") << "its points are no control points";
  const double allowed = 1e-9 * bounding_box(original.points).side();
  for (Index v = 0; v < original.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(surface.points[v][k], original.points[v][k], allowed);
    }
  }
}

TEST(Interpolate, RoundedFilesReportBothErrors) {
  const TempFolder folder;
  const std::string given = data("sphere_irregular.obj");
  const nlohmann::json report =
      report_of({"interpolate", given, "-o", folder / "c.ply", "--single"});
  EXPECT_LE(report["error"]["max"], 1e-9);
  EXPECT_GT(report["error_stored"]["max"], 1e-9);
  EXPECT_LT(report["error_stored"]["max"], 1e-6);
  const nlohmann::json check = report_of({"check", folder / "c.ply", "--against", given}, 4);
  EXPECT_EQ(check["error"]["max"], report["error_stored"]["max"]) << "what the file really holds";
  EXPECT_EQ(check["error"]["mean"], report["error_stored"]["mean"]);
}

TEST(Interpolate, OnlyTheListedVerticesMove) {
  const TempFolder folder;
  const std::string given = data("sphere_irregular.obj");
  const std::string list = folder.file("only.txt", "0 5 17 # three of them\n");
  const nlohmann::json report =
      report_of({"interpolate", given, "-o", folder / "c.obj", "--only", list});
  EXPECT_EQ(report["only"], 3);
  EXPECT_LE(report["error"]["max"], 1e-9);
  EXPECT_GT(report["error"]["initial_max"], 1e-3);
  const Mesh original = mesh_of(given);
  const Mesh control = mesh_of(folder / "c.obj");
  for (Index v = 0; v < original.vertex_count(); ++v) {
    const bool listed = v == 0 || v == 5 || v == 17;
    EXPECT_EQ(control.points[v] != original.points[v], listed) << v;
  }
}

TEST(Predict, DirectDoesThePredictedSweepsAndReachesTheTolerance) {
  const TempFolder folder;
  const Words common = {"--solver", "richardson", "--tolerance", "1e-6"};
  Words predict = {"predict", data("octahedron.obj")};
  predict.insert(predict.end(), common.begin(), common.end());
  const nlohmann::json prediction = report_of(predict)["prediction"];
  // (3 beta - 1) / 2 with beta = 24/55
  EXPECT_NEAR(prediction["lowest_eigenvalue"].get<double>(), 17.0 / 110.0, 1e-12);
  Words direct = {"interpolate", data("octahedron.obj"), "-o", folder / "c.obj", "--direct"};
  direct.insert(direct.end(), common.begin(), common.end());
  const nlohmann::json report = report_of(direct);
  EXPECT_EQ(report["iterations"].get<unsigned>(), prediction["sweeps"].get<unsigned>());
  EXPECT_LE(report["error"]["max"], 1e-6);
}

}  // namespace
}  // namespace surpass::test

// Each subcommand on the committed meshes, held against values found in another way.
#include <surpass/io.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

using Words = std::vector<std::string>;

Mesh mesh_of(const std::string& path) {
  const Result<LoadedMesh> loaded = read_mesh(path);
  if (!loaded) throw std::runtime_error(describe(loaded.error()));
  return loaded->mesh;
}

nlohmann::json report_of(Words words, int status = 0) {
  const TempFolder folder;
  words.insert(words.end(), {"--report", folder / "report.json"});
  const Outcome outcome = surpass(words);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  return nlohmann::json::parse(slurp(folder / "report.json"));
}

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

// Plain interpolation must refuse a cube with one corner moved; similarity and fairing give a
// surface, which `check` accepts by the first vertices of the control mesh.
TEST(Interpolate, SimilarityHasASurfaceWherePlainInterpolationHasNone) {
  const TempFolder folder;
  const std::string pulled =
      folder.file("cube.off",
                  "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n2 2 2\n-1 1 1\n"
                  "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(surpass({"interpolate", pulled, "-o", folder / "p.off"}).status, 3);
  for (const Words& method : {Words{"--method", "similarity"}, Words{"--method", "fair"},
                              Words{"--method", "similarity", "--similarity", "directions"},
                              Words{"--method", "similarity", "--solver", "gauss-seidel"}}) {
    Words words = {"interpolate",    pulled,     "-o", folder / "c.off",     "--surface",
                   folder / "s.ply", "--levels", "1",  "--solver-tolerance", "1e-12"};
    words.insert(words.end(), method.begin(), method.end());
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("of which the first 8 are"), std::string::npos) << outcome.err;
    const Outcome checked =
        surpass({"check", folder / "c.off", "--against", pulled, "--tolerance", "1e-12"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    const Mesh control = mesh_of(folder / "c.off");
    EXPECT_EQ(control.points.size(), 26U);
    EXPECT_EQ(control.annotation("refined"), "1");
    const Mesh surface = mesh_of(folder / "s.ply");
    EXPECT_NEAR(surface.points[6][0], 2, 1e-12);
    EXPECT_EQ(surface.annotation("refined"), "");
  }
  // The values of the reference implementation, to what the solver's tolerance leaves.
  const Mesh control = mesh_of(folder / "c.off");
  EXPECT_NEAR(control.points[0][0], -1.1177818677862, 1e-11);
  EXPECT_NEAR(control.points[6][0], 2.5744505853472, 1e-11);
}

// The ring of dummies is told of where it was not asked for, and where a file cannot tell it from
// the surface.
TEST(Interpolate, NobodyGetsADummyRingUnawares) {
  const TempFolder folder;
  const std::string given =
      folder.file("grid.off",
                  "OFF\n9 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n"
                  "4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n");
  const std::string wish =
      folder.file("wish.json", R"({"requirements": [{"vertex": 0, "normal": [0, 0.2, 1]}]})");
  const auto notes = [&](const std::string& control, const Words& more) {
    Words words = {"interpolate", given, "-o", control, "--method", "similarity"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto told = [&](const char* words_of_it) {
      return outcome.err.find(words_of_it) != std::string::npos;
    };
    return std::pair(told("the last 16 of the control mesh"),
                     told("the ring of 16 dummy faces is drawn like the surface"));
  };
  const std::string ply = folder / "c.ply";
  const std::string off = folder / "c.off";
  EXPECT_EQ(notes(ply, {"--requirements", wish}), std::pair(true, false));
  EXPECT_EQ(notes(off, {"--requirements", wish}), std::pair(true, true));
  EXPECT_EQ(notes(off, {"--requirements", wish, "--open", "dummy-ring"}), std::pair(false, true));
  EXPECT_EQ(notes(off, {"--requirements", wish, "--open", "boundary-rules"}),
            std::pair(false, false));
  EXPECT_EQ(notes(off, {}), std::pair(false, false));
}

// On Doo-Sabin surfaces no vertex of the control mesh stands for a given one: `check` finds its
// face by the given mesh's faces, in every format that keeps them, and sees a vertex that has
// moved.
TEST(Interpolate, SimilarDooSabinSurfacesAreChecked) {
  const TempFolder folder;
  const std::string given = data("jug.obj");
  for (const char* file : {"c.obj", "c.ply", "c.off"}) {
    const std::string control = folder / file;
    const Outcome outcome = surpass(
        {"interpolate", given, "-o", control, "--scheme", "doo-sabin", "--method", "similarity"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("with a face for each vertex"), std::string::npos) << outcome.err;
    const Outcome checked = surpass({"check", control, "--against", given, "--tolerance", "1e-12"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_EQ(surpass({"check", control, "--against", data("cube.obj")}).status, 3);
  }
  Mesh moved = mesh_of(given);
  moved.points[7][1] += 1;
  ASSERT_TRUE(write_mesh(moved, folder / "moved.obj"));
  const Outcome seen = surpass({"check", folder / "c.obj", "--against", folder / "moved.obj"});
  EXPECT_EQ(seen.status, 4) << seen.err;
  EXPECT_NE(seen.out.find("at vertex 7"), std::string::npos) << seen.out;
}

TEST(Interpolate, AReferenceMayBeGivenOrRefined) {
  const TempFolder folder;
  const std::string given = data("quad_patch.ply");
  const auto run = [&](const Words& more, const char* name) {
    Words words = {"interpolate", given, "-o", folder / name, "--method", "similarity"};
    words.insert(words.end(), more.begin(), more.end());
    return surpass(words).status;
  };
  ASSERT_EQ(surpass({"subdivide", given, "-o", folder / "r.ply", "--levels", "1"}).status, 0);
  ASSERT_EQ(run({"--scaling", "none"}, "a.ply"), 0);
  ASSERT_EQ(run({"--reference", given}, "b.ply"), 0);
  ASSERT_EQ(run({"--reference", folder / "r.ply"}, "c.ply"), 0);
  EXPECT_EQ(mesh_of(folder / "a.ply").points, mesh_of(folder / "b.ply").points);
  EXPECT_EQ(mesh_of(folder / "a.ply").points, mesh_of(folder / "c.ply").points);
  // The same faces, listed backwards and from other vertices on.
  const Mesh as_it_was = mesh_of(given);
  Mesh turned;
  turned.points = as_it_was.points;
  for (Index f = as_it_was.face_count(); f > 0; --f) {
    std::vector<Index> face(as_it_was.face(f - 1).begin(), as_it_was.face(f - 1).end());
    std::rotate(face.begin(), face.begin() + 1, face.end());
    turned.add_face(face);
  }
  ASSERT_TRUE(write_mesh(turned, folder / "turned.ply"));
  ASSERT_EQ(run({"--reference", folder / "turned.ply"}, "t.ply"), 0);
  EXPECT_EQ(mesh_of(folder / "a.ply").points, mesh_of(folder / "t.ply").points);
  EXPECT_EQ(run({"--reference", data("cube.obj")}, "d.ply"), 3);
  EXPECT_EQ(run({"--reference", folder / "none.ply"}, "d.ply"), 2);
}

// Stretched by 2, the cube's vertices are at 10/9, its edge points at 3/2 and its face points at 2;
// the box of the limits of its vertices is the given one. It is the control mesh as well.
TEST(Interpolate, TheReferenceIsWritten) {
  const TempFolder folder;
  const std::string given = data("cube.obj");
  const std::string reference = folder / "r.obj";
  const nlohmann::json report = report_of({"interpolate", given, "-o", folder / "c.ply", "--method",
                                           "similarity", "--write-reference", reference});
  ASSERT_EQ(report["outputs"].size(), 2U);
  EXPECT_EQ(report["outputs"][1]["path"], reference);
  EXPECT_EQ(report["outputs"][1]["format"], "obj");
  EXPECT_NEAR(report["similarity"]["scale"][0].get<double>(), 2, 1e-14);
  const Mesh mesh = mesh_of(reference);
  const Mesh cube = mesh_of(given);
  ASSERT_EQ(mesh.vertex_count(), 26U);
  EXPECT_EQ(mesh.annotation("scheme"), "catmull-clark");
  EXPECT_EQ(mesh.annotation("boundary"), "edge-and-corner");
  EXPECT_EQ(mesh.annotation("refined"), "1");
  const double half = bounding_box(cube.points).side() / 2;
  for (Index v = 0; v < 26; ++v) {
    double largest = 0;
    for (const double x : mesh.points[v]) largest = std::max(largest, std::abs(x) / half);
    EXPECT_NEAR(largest, v < 8 ? 10.0 / 9 : v < 20 ? 1.5 : 2, 1e-14) << v;
  }
  const Outcome checked = surpass({"check", reference, "--against", given, "--tolerance", "1e-12"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  EXPECT_EQ(surpass({"subdivide", reference, "-o", folder / "s.obj", "--levels", "2"}).status, 0);
}

// Where the vertices go besides is the interpolation's affair.
TEST(Interpolate, WithoutIterationsFreeVerticesAreThoseOfTheReference) {
  const TempFolder folder;
  const std::string wishes =
      folder.file("w.json", R"({"requirements": [{"vertex": 3, "position": [3, 0.5, 0.25]}]})");
  for (const char* name : {"quad_torus.obj", "quad_patch.ply"}) {
    const std::string given = data(name);
    const Index n = mesh_of(given).vertex_count();
    for (const Words& more : std::vector<Words>{{},
                                                {"--scaling", "isotropic"},
                                                {"--open", "dummy-ring"},
                                                {"--requirements", wishes},
                                                {"--reference", given}}) {
      Words words = {"interpolate",      given,      "-o",
                     folder / "c.ply",   "--method", "similarity",
                     "--max-iterations", "0",        "--write-reference",
                     folder / "r.ply"};
      words.insert(words.end(), more.begin(), more.end());
      const Outcome outcome = surpass(words);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const Mesh control = mesh_of(folder / "c.ply");
      const Mesh reference = mesh_of(folder / "r.ply");
      ASSERT_EQ(control.face_vertices, reference.face_vertices);
      EXPECT_EQ(control.hole_faces, reference.hole_faces);
      for (Index v = n; v < control.vertex_count(); ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(control.points[v][k], reference.points[v][k]) << name << " " << v;
        }
      }
      EXPECT_NE(control.points[0], reference.points[0]);
    }
  }
}

TEST(Interpolate, TheReferenceIsNotWrittenWithoutTheResult) {
  const TempFolder folder;
  const std::string wishes =
      folder.file("w.json", R"({"requirements": [{"vertex": 999, "remove": true}]})");
  const Outcome outcome =
      surpass({"interpolate", data("cube.obj"), "-o", folder / "c.ply", "--method", "fair",
               "--write-reference", folder / "r.ply", "--requirements", wishes});
  EXPECT_NE(outcome.status, 0);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"w.json"});
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

TEST(Subdivide, KeepsOldVerticesAndMakesFourFacesOfOne) {
  const TempFolder folder;
  ASSERT_EQ(surpass({"subdivide", data("octahedron.obj"), "-o", folder / "f.obj", "--levels", "1"})
                .status,
            0);
  const Mesh fine = mesh_of(folder / "f.obj");
  EXPECT_EQ(fine.face_count(), 32U);
  ASSERT_EQ(fine.vertex_count(), 18U);
  // Vertex rule of valence 4: 1 - alpha with alpha = 5/8 - (3/8)^2 = 31/64; neighbours cancel.
  EXPECT_NEAR(fine.points[0][0], mesh_of(data("octahedron.obj")).points[0][0] * 33 / 64, 1e-15);
  EXPECT_EQ(fine.annotation("scheme"), "loop");
}

TEST(Subdivide, LimitAtLevelZeroIsTheGivenMesh) {
  const TempFolder folder;
  const std::string given = data("patch_irregular.obj");
  ASSERT_EQ(surpass({"interpolate", given, "-o", folder / "c.obj", "--boundary", "hoppe",
                     "--tolerance", "1e-13"})
                .status,
            0);
  ASSERT_EQ(
      surpass({"subdivide", folder / "c.obj", "-o", folder / "l.obj", "--levels", "0", "--limit"})
          .status,
      0);
  const Mesh original = mesh_of(given);
  const Mesh limit = mesh_of(folder / "l.obj");
  const double allowed = 1e-12 * bounding_box(original.points).side();
  for (Index v = 0; v < original.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(limit.points[v][k], original.points[v][k], allowed)
          << "rule not taken from file?";
    }
  }
}

TEST(Check, TakesTheRecordedRulesUnlessTold) {
  const TempFolder folder;
  const std::string given = data("patch_irregular.obj");
  const std::string control = folder / "c.obj";
  ASSERT_EQ(surpass({"interpolate", given, "-o", control, "--boundary", "hoppe"}).status, 0);
  const nlohmann::json own = report_of({"check", control, "--against", given});
  EXPECT_EQ(own["boundary"], "hoppe");
  EXPECT_EQ(own["converged"], true);
  const Words other = {"check", control, "--against", given, "--boundary", "edge-only"};
  EXPECT_GT(report_of(other, 4)["error"]["max"], 1e-4);
}

TEST(Check, TheOracleAgreesOrIsRefused) {
  const TempFolder folder;
  const std::string given = data("patch_irregular.obj");
  const std::string control = folder / "c.obj";
  ASSERT_EQ(surpass({"interpolate", given, "-o", control}).status, 0);
  const Words check = {"check", control, "--against", given, "--oracle"};
  if (surpass({"--version"}).out.find("oracle    not built in") != std::string::npos) {
    const Outcome outcome = surpass(check);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("no OpenSubdiv"), std::string::npos) << outcome.err;
    return;
  }
  const nlohmann::json report = report_of(check);
  EXPECT_LE(report["oracle"]["max"], 1e-9);
  EXPECT_NE(report["oracle"]["evaluator"], report["error"]["evaluator"]);
  for (const char* rule : {"hoppe", "interior"}) {
    Words lacking = check;
    lacking.insert(lacking.end(), {"--boundary", rule});
    EXPECT_EQ(surpass(lacking).status, 1) << rule;
  }
}

TEST(Boundary, TheCommandLineWinsOverTheFileAndThatOverTheDefault) {
  const TempFolder folder;
  const std::string mesh = slurp(data("patch_irregular.obj"));
  const auto tagged = [&](const std::string& value) {
    return folder.file("t" + value + ".obj", mesh + "t interpolateboundary 1/0/0 " + value + "\n");
  };
  const auto rule = [&](Words words) {
    words.insert(words.end(), {"-o", folder / "c.obj"});
    return report_of(words)["boundary"].get<std::string>();
  };
  EXPECT_EQ(rule({"interpolate", tagged("1")}), "edge-and-corner");
  EXPECT_EQ(rule({"interpolate", tagged("2")}), "edge-only");
  EXPECT_EQ(rule({"interpolate", tagged("2"), "--boundary", "hoppe"}), "hoppe");
  EXPECT_EQ(rule({"interpolate", data("patch_irregular.obj")}), "edge-and-corner");
  const Outcome none = surpass({"interpolate", tagged("0"), "-o", folder / "c.obj"});
  EXPECT_EQ(none.status, 0);
  EXPECT_NE(none.err.find("is not supported"), std::string::npos) << none.err;

  ASSERT_EQ(rule({"interpolate", tagged("1"), "--boundary", "edge-only"}), "edge-only");
  const std::string control = slurp(folder / "c.obj");
  EXPECT_NE(control.find("t interpolateboundary 1/0/0 2"), std::string::npos)
      << "the tag of the written mesh says the rule that made it";
}

TEST(Scheme, IsChosenByTheFacesRecordedAndReadAgain) {
  const TempFolder folder;
  const std::string control = folder / "c.ply";
  EXPECT_EQ(report_of({"interpolate", data("torus_irregular.off"), "-o", control})["scheme"],
            "loop");
  EXPECT_EQ(report_of({"interpolate", data("quad_torus.obj"), "-o", control})["scheme"],
            "catmull-clark");
  for (const char* scheme : {"catmull-clark", "doo-sabin"}) {
    const std::string given = data("mixed_polygons.obj");
    const nlohmann::json made = report_of({"interpolate", given, "-o", control, "--scheme", scheme,
                                           "--weights", "cosine", "--tolerance", "1e-12"});
    EXPECT_EQ(made["weights"], "cosine");
    const nlohmann::json checked =
        report_of({"check", control, "--against", given, "--tolerance", "1e-11"});
    EXPECT_EQ(checked["scheme"], scheme);
    EXPECT_EQ(checked["weights"], "cosine");
    EXPECT_LE(checked["error"]["max"], 1e-11);
  }
  // The last control mesh has cosine weights; with the others its surface passes elsewhere.
  const Words other = {"check",     control,    "--against", data("mixed_polygons.obj"),
                       "--weights", "averaging"};
  EXPECT_GT(report_of(other, 4)["error"]["max"], 1e-4);
}

TEST(Scheme, DooSabinSurfacesBeginWithTheGivenVertices) {
  const TempFolder folder;
  const std::string given = data("mixed_polygons.obj");
  ASSERT_EQ(surpass({"interpolate", given, "-o", folder / "c.obj", "--scheme", "doo-sabin",
                     "--tolerance", "1e-12", "--surface", folder / "s.obj", "--levels", "2"})
                .status,
            0);
  const auto surface = read_mesh(folder / "s.obj");
  const auto points = read_mesh(given);
  ASSERT_TRUE(surface && points);
  const double side = bounding_box(points->mesh.points).side();
  ASSERT_GT(surface->mesh.vertex_count(), points->mesh.vertex_count());
  for (Index v = 0; v < points->mesh.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(surface->mesh.points[v][k], points->mesh.points[v][k], 2e-12 * side);
    }
  }
}

TEST(Scheme, WithoutAnInterpolantComponentsAreNamedAndCanBeSkipped) {
  const TempFolder folder;
  std::string text = "v 0 0 0.2\n";  // a cube with a corner moved, and a tetrahedron
  for (const char* p : {"1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1", "5 0 0",
                        "6 0 0", "5 1 0", "5 0 1"}) {
    text += "v " + std::string(p) + "\n";
  }
  text += "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  text += "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n";
  const std::string given = folder.file("given.obj", text);
  const Outcome refused = surpass({"interpolate", given, "-o", folder / "c.obj"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("component 0:"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--skip-component"), std::string::npos) << refused.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"given.obj"}));
  const nlohmann::json skipped =
      report_of({"interpolate", given, "-o", folder / "c.obj", "--skip-component", "0"});
  EXPECT_LE(skipped["error"]["max"], 1e-9);
  EXPECT_EQ(surpass({"interpolate", given, "-o", folder / "d.obj", "--skip-component", "2"}).status,
            1);
  EXPECT_EQ(surpass({"interpolate", given, "-o", folder / "d.obj", "--scheme", "doo-sabin"}).status,
            0);
}

TEST(Scheme, OracleIsRefusedWhereOpenSubdivLacksIt) {
  const TempFolder folder;
  const std::string control = folder / "c.obj";
  ASSERT_EQ(
      surpass({"interpolate", data("cube.obj"), "-o", control, "--scheme", "doo-sabin"}).status, 0);
  const Outcome outcome = surpass({"check", control, "--against", data("cube.obj"), "--oracle"});
  if (outcome.err.find("no OpenSubdiv") != std::string::npos) GTEST_SKIP() << "not built in";
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("doo-sabin"), std::string::npos) << outcome.err;
}

TEST(Inspect, CountsOfADiscAndAnOctahedron) {
  const nlohmann::json octahedron = report_of({"inspect", data("octahedron.obj")});
  EXPECT_EQ(octahedron["input"]["components"], 1);
  EXPECT_EQ(octahedron["input"]["boundary_loops"], 0);
  EXPECT_EQ(octahedron["anatomy"]["edges"], 12);
  EXPECT_EQ(octahedron["anatomy"]["valences"]["interior"], (nlohmann::json{{"4", 6}}));
  const nlohmann::json tube = report_of({"inspect", data("tube.obj")});
  EXPECT_EQ(tube["input"]["boundary_loops"], 2);
  std::size_t boundary = 0;
  for (const auto& length : tube["anatomy"]["boundary_loop_lengths"]) {
    boundary += length.get<std::size_t>();
  }
  // Every edge has two faces but those of the boundary: 3 F = 2 E - B.
  EXPECT_EQ(3 * 216, 2 * tube["anatomy"]["edges"].get<std::size_t>() - boundary);
}

TEST(Inspect, SaysWhatWouldBeRefused) {
  const nlohmann::json cube = report_of({"inspect", data("cube.obj"), "--scheme", "loop"}, 3);
  EXPECT_EQ(cube["anatomy"]["accepted"], false);
  EXPECT_EQ(cube["anatomy"]["refusals"][0]["code"], "unsuitable-for-scheme");
  const nlohmann::json mended = report_of({"inspect", data("cube.obj"), "--triangulate"});
  EXPECT_EQ(mended["scheme"], "loop");
  EXPECT_EQ(report_of({"inspect", data("cube.obj")})["scheme"], "catmull-clark");
  EXPECT_EQ(mended["anatomy"]["accepted"], true);
  EXPECT_EQ(mended["input"]["faces"], 12);
}

TEST(Compare, TwoParallelTriangles) {
  const TempFolder folder;
  const std::string low = folder.file("low.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string high =
      folder.file("high.off", "OFF\n3 1 0\n0 0 0.5\n1 0 0.5\n0 1 0.5\n3 0 1 2\n");
  const nlohmann::json distance = report_of({"compare", low, high})["distance"];
  for (const char* side : {"a_to_b", "b_to_a"}) {
    for (const char* figure : {"max", "mean", "rms"}) {
      EXPECT_NEAR(distance[side][figure].get<double>(), 0.5, 1e-12) << side << " " << figure;
    }
  }
  EXPECT_GE(distance["hausdorff_bound"].get<double>(), 0.5);
  EXPECT_LE(distance["hausdorff_bound"].get<double>(), 0.5 + 1e-5);
}

TEST(Convert, ThroughEveryFormatAndBack) {
  const TempFolder folder;
  const std::string first = data("sphere_irregular.obj");
  ASSERT_EQ(surpass({"convert", first, folder / "a.ply"}).status, 0);
  ASSERT_EQ(surpass({"convert", folder / "a.ply", folder / "b.off"}).status, 0);
  ASSERT_EQ(surpass({"convert", folder / "b.off", "-o", folder / "c.ply", "--ascii"}).status, 0);
  ASSERT_EQ(surpass({"convert", folder / "c.ply", folder / "d.obj"}).status, 0);
  const Mesh original = mesh_of(first);
  const Mesh last = mesh_of(folder / "d.obj");
  EXPECT_EQ(last.points, original.points);
  EXPECT_EQ(last.face_vertices, original.face_vertices);
}

TEST(Convert, SaysWhatTheFormatCannotHold) {
  const TempFolder folder;
  const Outcome outcome = surpass({"convert", data("crease_loop.obj"), folder / "x.stl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("note: "), std::string::npos);
  EXPECT_NE(outcome.err.find("crease"), std::string::npos) << outcome.err;
  const Outcome quiet = surpass({"convert", data("crease_loop.obj"), folder / "x.stl", "--quiet"});
  EXPECT_EQ(quiet.err, "");
}

TEST(Streams, StandardInputToStandardOutput) {
  const TempFolder folder;
  const std::string given = data("bipyramid.off");
  ASSERT_EQ(surpass({"interpolate", given, "-o", folder / "c.off"}).status, 0);
  const Outcome streamed = surpass({"interpolate", "-", "-o", "-"}, {.input = slurp(given)});
  EXPECT_EQ(streamed.status, 0) << streamed.err;
  EXPECT_TRUE(streamed.out == slurp(folder / "c.off"));
  const Outcome named = surpass({"interpolate", "-", "-o", "-", "--from", "off", "--to", "ply"},
                                {.input = slurp(given)});
  EXPECT_EQ(named.out.substr(0, 4), "ply\n");
  const Outcome check =
      surpass({"check", "-", "--against", given, "--from", "off"}, {.input = streamed.out});
  EXPECT_EQ(check.status, 0) << check.err;
}

TEST(Streams, AReportOnStandardOutputIsAlone) {
  const Outcome outcome = surpass({"inspect", data("octahedron.obj"), "--report", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["command"], "inspect");
}

}  // namespace
}  // namespace surpass::test

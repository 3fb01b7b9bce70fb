// `surpass interpolate --method similarity`: surfaces where the progressive method has none, rings
// of dummies, references.
#include <surpass/io.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

using Words = std::vector<std::string>;

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

}  // namespace
}  // namespace surpass::test

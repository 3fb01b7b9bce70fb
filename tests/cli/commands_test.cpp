// The other subcommands on the committed meshes, held against values found in another way.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

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

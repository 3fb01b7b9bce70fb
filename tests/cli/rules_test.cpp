// Which scheme, boundary rule and weights a surface has: told, recorded or chosen; and `surpass
// check`, which goes by them.
#include <surpass/io.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

using Words = std::vector<std::string>;

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
  if (!is_built_in("oracle")) {
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

}  // namespace
}  // namespace surpass::test

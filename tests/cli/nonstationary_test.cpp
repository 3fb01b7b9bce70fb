// --scheme nonstationary-loop, as a user runs it.
#include <surpass/surpass.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "schema.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

class NonstationaryCommand : public testing::Test {
 protected:
  /// Runs a command under the scheme, expects the exit code, and the schema's consent.
  json run(std::vector<std::string> words, int status = 0) {
    const std::string path = folder_ / "report.json";
    words.insert(words.end(), {"--scheme", "nonstationary-loop", "--report", path});
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    said_ = outcome.err + outcome.out;
    json report = json::parse(slurp(path));
    EXPECT_EQ(schema_.complaint(report.dump()), "") << report.dump(1);
    std::filesystem::remove(path);
    return report;
  }

  /// The largest difference of a coordinate between the first vertices of a file and a mesh.
  static double miss(const std::string& path, const Mesh& given) {
    const Mesh mesh = read_mesh(path).value().mesh;
    double largest = 0;
    for (std::size_t v = 0; v < given.points.size(); ++v) {
      for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(mesh.points[v][c] - given.points[v][c]));
      }
    }
    return largest;
  }

  const std::string path_ = data("sphere_irregular.obj");
  const Mesh given_ = read_mesh(path_).value().mesh;
  TempFolder folder_;
  Schema schema_{SURPASS_SCHEMA};
  std::string said_;
};

TEST_F(NonstationaryCommand, SubdivideMeetsTheVerticesAfterItsLevels) {
  const std::string out = folder_ / "out.ply";
  const json report = run({"subdivide", path_, "-o", out, "--levels", "3"});
  EXPECT_EQ(report["nonstationary"]["steps"], 3);
  EXPECT_EQ(report["nonstationary"]["shape"], -1.5);
  EXPECT_LE(miss(out, given_), 1e-14);
  // The limit of that mesh is another surface.
  run({"subdivide", path_, "-o", out, "--levels", "2", "--limit", "--shape", "-3"});
  EXPECT_LE(miss(out, given_), 1e-14);
  EXPECT_EQ(read_mesh(out).value().mesh.face_count(), 16 * given_.face_count());
}

TEST_F(NonstationaryCommand, InterpolateWritesTheSurfaceAndCheckAgrees) {
  const std::string out = folder_ / "out.ply";
  const json report = run({"interpolate", path_, "-o", out, "--levels", "2"});
  EXPECT_NE(said_.find("no other control mesh than the given one"), std::string::npos);
  EXPECT_EQ(report["method"], "nonstationary");
  EXPECT_LE(report["error"]["max"], 1e-14);
  EXPECT_LE(miss(out, given_), 1e-14);
  EXPECT_LE(run({"check", path_, "--against", path_})["error"]["max"], 1e-14);
  EXPECT_LE(run({"check", out, "--against", path_})["error"]["max"], 1e-14);
  // Without the scheme it is no control mesh; what it may be is said.
  const Outcome plain = surpass({"check", out, "--against", path_});
  EXPECT_EQ(plain.status, 3);
  EXPECT_NE(plain.err.find("--scheme nonstationary-loop"), std::string::npos) << plain.err;
  EXPECT_GE(run({"check", path_, "--against", path_, "--uniform", "1"}, 4)["error"]["max"], 1e-3);
  EXPECT_NE(said_.find("nonstationary-loop, edge-and-corner"), std::string::npos) << said_;
  run({"check", path_, "--against", path_, "--uniform", "1", "--boundary", "edge-only"}, 4);
  EXPECT_NE(said_.find("nonstationary-loop, edge-only"), std::string::npos) << said_;
  EXPECT_GE(
      run({"interpolate", path_, "-o", folder_ / "no.ply", "--rule", "mean"}, 4)["error"]["max"],
      1e-3);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "no.ply"));
  run({"check", data("octahedron.obj"), "--against", path_}, 3);
}

TEST_F(NonstationaryCommand, TargetsAreMet) {
  const std::string targets =
      folder_.file("targets.txt", "# vertex, position\n0 0.25\n3 -0.1 # out\n");
  const std::string out = folder_ / "out.ply";
  const json report = run({"interpolate", path_, "-o", out, "--targets", targets});
  EXPECT_EQ(report["nonstationary"]["targets"], 2);
  EXPECT_LE(report["error"]["max"], 1e-14);
  EXPECT_GE(miss(out, given_), 1e-3);
  EXPECT_LE(run({"check", out, "--against", path_, "--targets", targets})["error"]["max"], 1e-14);
}

TEST_F(NonstationaryCommand, BadTargetsAreRefusedWithTheirPlace) {
  const auto says = [&](const std::string& text, int status, const std::string& words) {
    const std::string targets = folder_.file("bad.txt", text);
    run({"subdivide", path_, "-o", folder_ / "x.ply", "--levels", "1", "--targets", targets},
        status);
    EXPECT_NE(said_.find(words), std::string::npos) << said_;
  };
  says("0 0.1\nx 0.2\n", 2, "bad.txt:2:1: 'x' is not a vertex number");
  says("0 0.1\n1 y\n", 2, "bad.txt:2:3: 'y' is not a number");
  says("0 nan\n", 2, "'nan' is not a number");
  says("99999 0\n", 2, "there is no vertex 99999");
  says("0 0.1 7\n", 2, "vertex 7 has no position");
  says("# none\n", 2, "names no target");
  says("0 0.4\n", 1, "must be below 0.3125");
  says("0 0.1 0 0.2\n", 1, "two targets");
  run({"subdivide", path_, "-o", folder_ / "x.ply", "--levels", "0", "--targets",
       folder_.file("good.txt", "0 0.1\n")},
      1);
  EXPECT_NE(said_.find("passes through no --targets"), std::string::npos) << said_;
}

// Whatever is written: the number is the one that quality prints for the same surface.
TEST_F(NonstationaryCommand, AutoFindsTheLeastBendingOfTheLimit) {
  const std::string out = folder_ / "a.ply";
  const json stepped =
      run({"subdivide", path_, "-o", out, "--levels", "2", "--shape", "auto"})["nonstationary"];
  const double shape = stepped["shape"];
  const json& fairest = stepped["fairest"];
  const json found = run({"quality", path_, "--shape=" + json(shape).dump()})["surfaces"][0];
  EXPECT_EQ(found["trimmed_bending"], fairest["trimmed_bending"]);
  EXPECT_EQ(found["levels"], fairest["levels"]);
  EXPECT_EQ(fairest["rings"], 2);
  const auto again = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"subdivide", path_, "-o", out, "--shape", "auto"});
    return run(words)["nonstationary"];
  };
  EXPECT_EQ(again({"--levels", "1", "--limit"})["shape"], shape);
}

TEST_F(NonstationaryCommand, AutoIsMeasuredAsQualityIsAsked) {
  const json report = run({"quality", path_, "--levels", "3", "--rings", "1", "--shape", "auto"});
  const double best = report["surfaces"][0]["trimmed_bending"];
  const json& chosen = report["nonstationary"];
  EXPECT_EQ(chosen["fairest"]["trimmed_bending"], best);
  EXPECT_EQ(chosen["fairest"]["levels"], 3);
  EXPECT_EQ(chosen["fairest"]["rings"], 1);
  const auto energy = [&](double at) {
    return run({"quality", path_, "--levels", "3", "--rings", "1",
                "--shape=" + std::to_string(at)})["surfaces"][0]["trimmed_bending"]
        .get<double>();
  };
  EXPECT_GT(energy(0), best);
  EXPECT_GT(energy(-3.9), best);
}

TEST_F(NonstationaryCommand, QualityRefusesTheRuleMeanWithTheReason) {
  run({"quality", path_, "--rule", "mean"}, 1);
  EXPECT_NE(said_.find("no closed form of second derivatives"), std::string::npos) << said_;
  const std::string help = surpass({"quality", "--help"}).out;
  EXPECT_NE(help.find("interpolating|quadratic"), std::string::npos);
  EXPECT_EQ(help.find("mean: edges"), std::string::npos);
  EXPECT_NE(surpass({"subdivide", "--help"}).out.find("mean: edges"), std::string::npos);
}

TEST_F(NonstationaryCommand, CheckMendsBothMeshesAlike) {
  const std::string cube = data("cube.obj");
  run({"check", cube, "--against", cube}, 3);
  EXPECT_LE(run({"check", cube, "--against", cube, "--triangulate"})["error"]["max"], 1e-14);
  const std::string twice = folder_.file("twice.off",
                                         "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 1\n"
                                         "3 0 2 1\n3 0 1 3\n3 0 4 2\n3 1 2 3\n");
  const json report = run({"check", twice, "--against", twice, "--weld", "1e-9"});
  EXPECT_EQ(report["control"]["vertices"], 4);
  EXPECT_LE(report["error"]["max"], 1e-14);
}

TEST_F(NonstationaryCommand, NothingIsSaidThatIsNotSo) {
  const std::string out = folder_ / "out.ply";
  run({"interpolate", path_, "-o", out, "--uniform", "1"}, 4);
  EXPECT_EQ(said_.find("what is written"), std::string::npos) << said_;
  EXPECT_EQ(said_.find("shape parameter"), std::string::npos) << said_;
  EXPECT_NE(said_.find("uniform parameter 1"), std::string::npos) << said_;
  run({"subdivide", path_, "-o", out, "--levels", "1", "--uniform", "-2", "--iteration",
       "exponential"},
      1);
  EXPECT_NE(said_.find("the uniform parameter is -2"), std::string::npos) << said_;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(NonstationaryCommand, RenderDrawsItsLimitSurface) {
  const std::string surface = folder_ / "surface.ply";
  const std::string own = folder_ / "own.png";
  const std::string drawn = folder_ / "drawn.png";
  if (surpass({"render", path_, "-o", own}).status != 0) {
    GTEST_SKIP() << "this build makes no pictures";
  }
  run({"subdivide", path_, "-o", surface, "--levels", "2", "--limit", "--shape", "-3"});
  const json report = run({"render", path_, "-o", own, "--levels", "2", "--shape", "-3"});
  EXPECT_EQ(report["inputs"][0]["scheme"], "nonstationary-loop");
  EXPECT_EQ(report["inputs"][0]["nonstationary"]["shape"], -3);
  EXPECT_EQ(surpass({"render", surface, "-o", drawn}).status, 0);
  EXPECT_EQ(slurp(own), slurp(drawn));
  EXPECT_EQ(surpass({"render", path_, "-o", drawn, "--levels", "2"}).status, 0);
  EXPECT_NE(slurp(own), slurp(drawn));
  run({"render", path_, "-o", own}, 1);
  EXPECT_NE(said_.find("name its --levels"), std::string::npos);
  run({"render", path_, "-o", own, "--levels", "2", "--style", "error"}, 1);
  EXPECT_NE(said_.find("name a mesh with --against"), std::string::npos);
}

TEST_F(NonstationaryCommand, PresetsAndWeightsAreTaken) {
  const std::string out = folder_ / "out.ply";
  const std::vector<std::string> words = {"subdivide", path_, "-o", out, "--levels", "2"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return run(more)["nonstationary"];
  };
  EXPECT_EQ(with({"--preset", "round"})["shape"], -3);
  EXPECT_EQ(with({"--preset", "flat"})["shape"], 0);
  EXPECT_EQ(with({"--weights", "classic"})["loop_weights"], "classic");
  EXPECT_LE(miss(out, given_), 1e-14);
  EXPECT_EQ(with({"--rule", "quadratic"})["rule"], "quadratic");
  EXPECT_LE(miss(out, given_), 1e-14);
  EXPECT_EQ(with({"--uniform", "2", "--iteration", "exponential"})["iteration"], "exponential");
  EXPECT_EQ(with({"--shape", "17"})["shape"], kHighestShape);
  EXPECT_NE(said_.find("outside of the range"), std::string::npos);
}

TEST_F(NonstationaryCommand, ContradictionsAreRefused) {
  const std::string out = folder_ / "out.ply";
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.begin(), {"interpolate", path_, "-o", out});
    run(more, 1);
    EXPECT_NE(said_.find(words), std::string::npos) << said_;
  };
  refused({"--shape", "wide"}, "neither a number nor auto");
  refused({"--shape", "-2", "--preset", "flat"}, "same number");
  refused({"--uniform", "1", "--shape", "0"}, "no shape parameter");
  refused({"--rule", "quadratic", "--preset", "flat"}, "no shape parameter");
  refused({"--uniform", "1", "--rule", "mean"}, "leave out --rule");
  refused({"--iteration", "exponential"}, "cannot interpolate");
  refused({"--weights", "cosine"}, "warren and classic");
  refused({"--method", "fair"}, "interpolates by itself");
  refused({"--surface", folder_ / "s.ply"}, "-o is that surface");
  refused({"--max-iterations", "5"}, "--max-iterations is for schemes");
  refused({"--boundary", "hoppe"}, "edge-only and edge-and-corner");
  EXPECT_FALSE(std::filesystem::exists(out));
  for (const char* option :
       {"--shape=-2", "--preset=flat", "--uniform=1", "--rule=mean", "--weights=warren"}) {
    const Outcome outcome = surpass({"subdivide", path_, "-o", out, "--levels", "1", option});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("only for --scheme nonstationary-loop"), std::string::npos);
  }
}

TEST_F(NonstationaryCommand, UnsuitableMeshesNameTheElement) {
  run({"subdivide", data("crease_darts.obj"), "-o", folder_ / "x.obj", "--levels", "1"}, 3);
  EXPECT_NE(said_.find("a crease ends inside of the surface"), std::string::npos);
  EXPECT_NE(said_.find("(vertex "), std::string::npos);
  run({"subdivide", data("cube.obj"), "-o", folder_ / "x.obj", "--levels", "1"}, 3);
  EXPECT_NE(said_.find("(face 0"), std::string::npos);
}

}  // namespace
}  // namespace surpass::test

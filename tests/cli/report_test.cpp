// Reports of every command, of successes and of failures, against docs/report.schema.json.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "schema.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;
class Report : public testing::Test {
 protected:
  std::string complaint(const json& report) const { return schema_.complaint(report.dump()); }

  /// Runs the command with --report, expects the exit code, and the schema's consent.
  json valid(std::vector<std::string> words, int status) {
    const std::string path = folder_ / "report.json";
    words.insert(words.end(), {"--report", path});
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    json report = json::parse(slurp(path));
    EXPECT_EQ(complaint(report), "") << report.dump(1);
    EXPECT_EQ(report.contains("failure"), status != 0);
    if (status != 0) {
      EXPECT_EQ(report["failure"]["exit_status"], status);
    }
    std::filesystem::remove(path);
    return report;
  }

  TempFolder folder_;
  Schema schema_{SURPASS_SCHEMA};
};

TEST_F(Report, OfInterpolation) {
  for (const char* mesh : {"octahedron.obj", "patch_irregular.obj", "crease_darts.obj",
                           "three_parts.ply", "isolated.obj", "bowtie.obj"}) {
    valid({"interpolate", data(mesh), "-o", folder_ / "c.ply"}, 0);
  }
  const json full = valid({"interpolate", data("tube.obj"), "-o", folder_ / "c.stl", "--surface",
                           folder_ / "s.off", "--levels", "1", "--solver", "richardson"},
                          0);
  EXPECT_EQ(full["outputs"].size(), 2U);
  EXPECT_GT(full["boundary_iterations"], 0);
  EXPECT_EQ(full["history"].size(), full["iterations"].get<std::size_t>());
  EXPECT_EQ(full["history"].back()["iteration"], full["iterations"]);
  for (const auto& [stage, seconds] : full["seconds"].items()) {
    EXPECT_LE(seconds, full["seconds"]["total"]) << stage;
  }
  EXPECT_GT(full["peak_memory_bytes"], 1000000);
  valid({"interpolate", data("cube.obj"), "-o", folder_ / "c.ply", "--triangulate"}, 0);
}

TEST_F(Report, OfSimilarityAndFairing) {
  const std::string given = data("quad_patch.ply");
  const json vectors = valid(
      {"interpolate", given, "-o", folder_ / "v.ply", "--method", "similarity", "--oracle"}, 0);
  EXPECT_EQ(vectors["method"], "similarity");
  EXPECT_EQ(vectors["similarity"]["form"], "vectors");
  EXPECT_EQ(vectors["similarity"]["residuals"].size(), vectors["iterations"].get<std::size_t>());
  EXPECT_LE(vectors["similarity"]["residual"], 1e-2);
  EXPECT_LE(vectors["oracle"]["max"], 1e-12);
  EXPECT_EQ(vectors["input"]["vertices"].get<std::size_t>() +
                vectors["similarity"]["free_vertices"].get<std::size_t>(),
            vectors["outputs"][0]["vertices"]);
  const json none =
      valid({"interpolate", given, "-o", folder_ / "d.ply", "--method", "similarity",
             "--similarity", "directions", "--weights", "none", "--max-iterations", "0"},
            0);
  EXPECT_EQ(none["similarity"]["row_weights"], "none");
  EXPECT_EQ(none["iterations"], 0);
  EXPECT_LE(none["error"]["max"], 1e-12);
  const json both =
      valid({"interpolate", given, "-o", folder_ / "b.ply", "--scheme", "doo-sabin", "--method",
             "similarity", "--similarity", "directions", "--weights", "cosine,unit"},
            0);
  EXPECT_EQ(both["weights"], "cosine");
  EXPECT_EQ(both["similarity"]["row_weights"], "unit");
  const json fair = valid({"interpolate", given, "-o", folder_ / "f.ply", "--method", "fair",
                           "--membrane", "0.5", "--samples", "5", "--scaling", "isotropic"},
                          0);
  EXPECT_EQ(fair["similarity"]["membrane"], 0.5);
  const json scale = fair["similarity"]["scale"];
  EXPECT_EQ(scale[0], scale[2]);
  const json polygons = valid({"interpolate", data("cube.obj"), "-o", folder_ / "x.ply", "--method",
                               "similarity", "--scheme", "loop"},
                              3);
  EXPECT_EQ(polygons["failure"]["code"], "unsuitable-for-scheme");
}

TEST_F(Report, OfFailedInterpolation) {
  const json few = valid({"interpolate", data("sphere_irregular.obj"), "-o", folder_ / "x.obj",
                          "--max-iterations", "2"},
                         4);
  EXPECT_EQ(few["converged"], false);
  EXPECT_EQ(few["iterations"], 2);
  EXPECT_EQ(few["failure"]["code"], "not-converged");
  const json polygons =
      valid({"interpolate", data("cube.obj"), "-o", folder_ / "x.obj", "--scheme", "loop"}, 3);
  EXPECT_EQ(polygons["input"]["vertices"], 8);
  EXPECT_EQ(polygons["failure"]["code"], "unsuitable-for-scheme");
  valid({"interpolate", folder_ / "missing.obj", "-o", folder_ / "x.obj"}, 2);
  valid({"interpolate", data("tube.obj"), "-o", folder_ / "none/x.obj"}, 5);
  const std::string bad = folder_.file("bad.obj", "v 0 0 0\nv 1 0 x\n");
  const json syntax = valid({"interpolate", bad, "-o", folder_ / "x.obj"}, 2);
  EXPECT_EQ(syntax["failure"]["line"], 2);
  EXPECT_EQ(syntax["failure"]["column"], 7);
}

TEST_F(Report, OfTheOtherCommands) {
  const std::string given = data("patch_irregular.obj");
  const std::string control = folder_ / "c.obj";
  valid({"interpolate", given, "-o", control}, 0);
  valid({"predict", given}, 0);
  valid({"subdivide", control, "-o", folder_ / "s.ply", "--levels", "1", "--limit"}, 0);
  valid({"check", control, "--against", given}, 0);
  valid({"check", given, "--against", given}, 4);
  valid({"check", given, "--against", data("tube.obj")}, 3);
  for (const char* mesh : {"octahedron.obj", "crease_corners.obj", "hole_faces.obj", "coloured.ply",
                           "textured.obj", "isolated.obj", "bowtie.obj"}) {
    valid({"inspect", data(mesh)}, 0);
  }
  valid({"inspect", data("mixed_polygons.obj")}, 0);
  valid({"inspect", data("mixed_polygons.obj"), "--scheme", "loop"}, 3);
  valid({"compare", given, control}, 0);
  valid({"convert", given, folder_ / "x.off"}, 0);
  if (is_built_in("render")) {
    const json drawn =
        valid({"render", control, "-o", folder_ / "x.png", "--levels", "1", "--size", "64x48"}, 0);
    EXPECT_EQ(drawn["picture"]["width"], 64);
    EXPECT_EQ(drawn["picture"]["panels"][0]["style"], "matte");
  }
}

// With the pages' frame, which `make web` builds, or with the sentence that names it.
TEST_F(Report, OfPages) {
  const std::filesystem::path frame =
      std::filesystem::path(SURPASS_EXECUTABLE).parent_path() / "../report/report.html";
  const bool built = std::filesystem::exists(frame);
  const std::string given = data("octahedron.obj");
  const std::string page = folder_ / "page.html";
  const std::vector<std::vector<std::string>> commands = {
      {"interpolate", given, "-o", folder_ / "c.obj", "--html", page},
      {"subdivide", given, "-o", folder_ / "s.obj", "--levels", "1", "--html", page},
      {"compare", given, given, "--html", page},
      {"view", given, "--html", page, "--no-browser"}};
  for (const auto& words : commands) {
    const json report = valid(words, built ? 0 : 1);
    EXPECT_EQ(std::filesystem::exists(page), built) << words.front();
    if (built) {
      EXPECT_EQ(report["html"], page);
      EXPECT_EQ(slurp(page).rfind("<!doctype html>", 0), 0U);
      std::filesystem::remove(page);
    } else {
      EXPECT_NE(report["failure"]["message"].get<std::string>().find("make web"),
                std::string::npos);
    }
  }
  // A page never takes the place of an input.
  valid({"compare", given, given, "--html", given}, 1);
}

TEST_F(Report, OfQuality) {
  const std::string given = data("quad_torus.obj");
  const std::string control = folder_ / "c.obj";
  valid({"interpolate", given, "-o", control}, 0);
  const json one = valid({"quality", control}, 0);
  EXPECT_EQ(one["surfaces"].size(), 1U);
  EXPECT_FALSE(one["surfaces"][0].contains("normal_deviation"));
  const json two =
      valid({"quality", control, given, "--reference", given, "--levels", "3", "--rings", "1"}, 0);
  EXPECT_EQ(two["rings"], 1);
  EXPECT_EQ(two["surfaces"][1]["normal_deviation"]["max"], 0);
  json lacking = two;
  lacking["surfaces"][1].erase("total_variation");
  EXPECT_NE(complaint(lacking), "");
  lacking = two;
  lacking["surfaces"][1] = {{"mesh", two["surfaces"][1]["mesh"]}};
  EXPECT_NE(complaint(lacking), "") << "without a failure all surfaces are measured";

  const json other = valid({"quality", control, "--reference", data("cube.obj")}, 3);
  EXPECT_EQ(other["failure"]["code"], "mismatch");
  EXPECT_EQ(other["failure"]["file"], control);
  valid({"quality", data("cube.obj"), "--levels", "1"}, 3);
  valid({"quality", data("cube.obj"), folder_ / "missing.obj"}, 2);
}

TEST_F(Report, TheSchemaRefusesOtherThings) {
  const json good = valid({"interpolate", data("octahedron.obj"), "-o", folder_ / "c.obj"}, 0);
  for (const char* key : {"command", "error", "history", "seconds", "input", "tolerance"}) {
    json lacking = good;
    lacking.erase(key);
    EXPECT_NE(complaint(lacking), "") << key;
  }
  json unknown = good;
  unknown["eror"] = 1;
  EXPECT_NE(complaint(unknown), "");
  json negative = good;
  negative["iterations"] = -1;
  EXPECT_NE(complaint(negative), "");
  json false_claim = good;
  false_claim["converged"] = false;
  EXPECT_NE(complaint(false_claim), "") << "without a failure the tolerance was reached";
}

}  // namespace
}  // namespace surpass::test

// --requirements and --normals: what their files may say, and that what they say holds.
#include <surpass/surpass.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "requirement_samples.hpp"
#include "schema.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

class Requirements : public testing::Test {
 protected:
  Outcome run(const json& requirements, std::vector<std::string> more = {}) {
    const std::string path = folder_.file("requirements.json", requirements.dump());
    std::vector<std::string> words = {"interpolate", data("quad_torus.obj"), "-o",
                                      control_,      "--requirements",       path};
    if (std::find(more.begin(), more.end(), "--method") == more.end()) {
      more.insert(more.end(), {"--method", "similarity"});
    }
    words.insert(words.end(), more.begin(), more.end());
    std::filesystem::remove(control_);
    return surpass(words);
  }
  static json list(const std::vector<json>& entries) { return {{"requirements", entries}}; }

  TempFolder folder_;
  std::string control_ = folder_ / "control.ply";
  Schema schema_{SURPASS_REQUIREMENTS_SCHEMA};
};

TEST_F(Requirements, AreMetAndReported) {
  const json all = list({kNormal, kPosition, kDirection, kDerivative, kRemove, kMoved, kNormal});
  EXPECT_EQ(schema_.complaint(all.dump()), "");
  const std::string report_path = folder_ / "report.json";
  for (const char* form : {"vectors", "directions"}) {
    const Outcome outcome = run(all, {"--similarity", form, "--report", report_path, "--oracle",
                                      "--max-iterations", "5", "--solver-tolerance", "0.01"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json report = json::parse(slurp(report_path));
    EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "");
    const json& requirements = report["similarity"]["requirements"];
    ASSERT_EQ(requirements.size(), 7U);
    for (const json& r : requirements) EXPECT_LT(r["error"], 1e-14) << r;
    EXPECT_EQ(requirements[0]["redundant"], false);
    EXPECT_EQ(requirements[6]["redundant"], true);
    EXPECT_NE(outcome.err.find("follows from the others"), std::string::npos) << outcome.err;
    const Mesh control = read_mesh(control_)->mesh;
    const auto limits = limit_positions(control, {Scheme::catmull_clark}).value();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(limits[13][c], 1, 1e-13);
  }
}

TEST_F(Requirements, AnglesAreReported) {
  const std::string report_path = folder_ / "report.json";
  ASSERT_EQ(run(list({kNormal, kPosition, kDirection}), {"--report", report_path}).status, 0);
  const json report = json::parse(slurp(report_path));
  EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "");
  const json& requirements = report["similarity"]["requirements"];
  EXPECT_TRUE(requirements[0].contains("angle"));
  EXPECT_FALSE(requirements[1].contains("angle"));
  EXPECT_LT(requirements[2]["angle"], 1e-7);
}

// Whatever is wrong with the file is said of the file, with one exit code.
TEST_F(Requirements, WrongEntriesNameTheFile) {
  const std::string path = folder_ / "requirements.json";
  const auto refused = [&](const std::string& text, const std::string& sentence) {
    const Outcome outcome =
        surpass({"interpolate", data("quad_torus.obj"), "-o", control_, "--method", "similarity",
                 "--requirements", folder_.file("requirements.json", text)});
    EXPECT_EQ(outcome.status, 2) << text << outcome.err;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
  };
  const auto with = [](const std::string& entry) { return "{\"requirements\": [" + entry + "]}"; };
  refused(with(R"({"vertex": 99999, "normal": [0, 0, 1]})"), "requirement 0 (normal at vertex");
  refused(with(R"({"face": 99999, "uv": [0, 0], "normal": [0, 0, 1]})"), "there are");
  refused(with(R"({"vertex": 0, "towards": 99999, "direction": [0, 0, 1]})"), "no edge leads");
  refused(with(R"({"vertex": 2, "remove": true}, {"vertex": 0, "vertex": 1, "remove": true})"),
          "requirement 1: \"vertex\" is there more than once");
  refused(with(R"({"vertex": 0, "normal": [0, 0, 1], "position": [0, 0, 1]})"),
          "exactly one of position, normal, direction, derivative and remove; it has position and "
          "normal");
  refused(with(R"({"vertex": 0, "norml": [0, 0, 1]})"), "and remove; it has \"norml\"");
  refused(R"({"requirement": []})", "it has \"requirement\"");
  // Whoever wrote it by hand looks for a line.
  refused("{\"requirements\": [\n  {\"vertex\": 0,, ",
          "requirements.json:2:16: is not JSON from here on");
  refused("{\"requirements\":\n\n[1e999]}",
          "requirements.json:3:6: holds a number here that no double");
  refused("", "requirements.json:1:1: is not JSON");
}

TEST_F(Requirements, ContradictionsAreNamedAndNothingIsWritten) {
  json other = kPosition;
  other["position"][0] = 1.25;
  const Outcome outcome = run(list({kNormal, kPosition, other}));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("1 (position on face 5"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("2 (position on face 5"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(control_));
}

// Two places so close that the surface goes 1e7 box sides far for them: rounding.
TEST_F(Requirements, WhatRoundingMissesIsNamedAndNothingIsWritten) {
  json beside = kPosition;
  beside["uv"][0] = 0.5000001;
  beside["position"][2] = 1.3;
  const Outcome outcome = run(list({kNormal, kPosition, beside}));
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("(position on face 5"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("by rounding"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(control_));
}

// The fairest surface through one point is that point.
TEST_F(Requirements, ASurfaceThatShrankIsNoted) {
  std::vector<json> removed;
  for (int v = 1; v < 160; ++v) removed.push_back({{"vertex", v}, {"remove", true}});
  const Outcome outcome = run(list(removed), {"--method", "fair"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("has shrunk to"), std::string::npos) << outcome.err;
}

TEST_F(Requirements, CommentsAndTheSchemasNameArePassedOver) {
  json labelled = kNormal;
  labelled["comment"] = "the nose looks up";
  json all = list({labelled, kPosition});
  all["$schema"] = "requirements.schema.json";
  EXPECT_EQ(schema_.complaint(all.dump()), "");
  EXPECT_EQ(run(all).status, 0);
}

// Upright on a flat sheet: the tangent would vanish, and the report says which it was.
TEST_F(Requirements, LengthsThatWereChosenAreReported) {
  const std::string sheet = folder_.file("sheet.off",
                                         "OFF\n9 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n"
                                         "1 1 0\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n4 0 1 4 3\n"
                                         "4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n");
  const json upright = {{"vertex", 4}, {"towards", 5}, {"direction", {0, 0, 1}}};
  const json along = {{"vertex", 4}, {"towards", 7}, {"direction", {0, 1, 0}}};
  const std::string path = folder_.file("list.json", list({along, upright}).dump());
  const std::string report_path = folder_ / "report.json";
  const Outcome outcome = surpass({"interpolate", sheet, "-o", control_, "--method", "similarity",
                                   "--requirements", path, "--report", report_path});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json report = json::parse(slurp(report_path));
  EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "");
  const json& found = report["similarity"]["requirements"];
  EXPECT_FALSE(found[0].contains("length_chosen"));
  EXPECT_EQ(found[1]["length_chosen"], true);
  EXPECT_NE(outcome.err.find("requirements at most"), std::string::npos) << outcome.err;
}

TEST_F(Requirements, NumbersThatNothingIsLeftBesideAreRefused) {
  for (json one : {kPosition, kMoved}) {
    one["position"][1] = 1e200;
    const Outcome outcome = run(list({kNormal, one}));
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("requirement 1 ("), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("so large beside the given mesh"), std::string::npos) << outcome.err;
  }
}

// What the schema refuses, the program refuses, with a sentence.
TEST_F(Requirements, WhatTheSchemaRefusesIsRefused) {
  const auto with = [](json entry, const char* key, const json& value) {
    entry[key] = value;
    return entry;
  };
  const std::vector<json> wrong = {
      json::array(),
      json::object(),
      {{"requirements", 3}},
      {{"requirements", json::array()}, {"more", 1}},
      list({json(7)}),
      list({{{"vertex", 3}}}),
      list({{{"normal", {0, 0, 1}}}}),
      list({with(kNormal, "position", {0, 0, 0})}),
      list({with(kNormal, "face", 2)}),
      list({with(kNormal, "vertex", -1)}),
      list({with(kNormal, "vertex", 1.5)}),
      list({with(kNormal, "vertex", "3")}),
      list({with(kNormal, "normal", {1, 2})}),
      list({with(kNormal, "normal", {1, 2, "x"})}),
      list({with(kNormal, "towards", 4)}),
      list({with(kNormal, "colour", 4)}),
      list({with(kPosition, "uv", {0.5})}),
      list({with(kPosition, "uv", {0.5, 1.5})}),
      list({with(kPosition, "along", {1, 0})}),
      list({with(kRemove, "remove", false)}),
      list({{{"face", 1}, {"uv", {0, 0}}, {"remove", true}}}),
      list({{{"vertex", 1}, {"direction", {0, 0, 1}}}}),
  };
  for (const json& document : wrong) {
    EXPECT_NE(schema_.complaint(document.dump()), "") << document;
    const Outcome outcome = run(document);
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << document << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(control_));
  }
  for (const char* text :
       {"", "{\"requirements\": [", "{\"requirements\": [{\"vertex\": 1e999}]}"}) {
    const std::string path = folder_.file("broken.json", text);
    const Outcome outcome = surpass({"interpolate", data("quad_torus.obj"), "-o", control_,
                                     "--method", "fair", "--requirements", path});
    EXPECT_EQ(outcome.status, 2) << text << outcome.err;
  }
}

TEST_F(Requirements, NormalsOfTheGivenFileOrAnother) {
  // The surface of a mesh, as a mesh with normals.
  const std::string with_normals = folder_ / "with_normals.ply";
  ASSERT_EQ(
      surpass({"subdivide", data("quad_torus.obj"), "-o", with_normals, "--levels", "0", "--limit"})
          .status,
      0);
  const std::string report_path = folder_ / "report.json";
  for (const std::string& normals : {std::string("given"), with_normals}) {
    const Outcome outcome =
        surpass({"interpolate", with_normals, "-o", control_, "--method", "fair", "--scheme",
                 "catmull-clark", "--normals", normals, "--report", report_path});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json report = json::parse(slurp(report_path));
    const Mesh given = read_mesh(with_normals)->mesh;
    const json& requirements = report["similarity"]["requirements"];
    ASSERT_EQ(requirements.size(), given.points.size());
    for (const json& r : requirements) {
      EXPECT_LT(r["error"], 1e-14);
      EXPECT_EQ(r["flipped"], false);
    }
  }
  const Outcome none = surpass({"interpolate", data("quad_torus.obj"), "-o", control_, "--method",
                                "fair", "--normals", "given"});
  EXPECT_EQ(none.status, 3) << none.err;
  EXPECT_NE(none.err.find("no normals"), std::string::npos);
}

// A normal on the boundary brings the dummy ring with it, unless told otherwise; its faces are
// holes in the file, and both certificates hold for what is read from it.
// OBJ files have normals for their faces' corners.
TEST_F(Requirements, NormalsOfCornersThatAgree) {
  const std::string given = folder_ / "normals.obj";
  ASSERT_EQ(surpass({"subdivide", data("quad_torus.obj"), "-o", given, "--levels", "0", "--limit"})
                .status,
            0);
  const std::string report_path = folder_ / "report.json";
  const Outcome outcome = surpass({"interpolate", given, "-o", control_, "--method", "similarity",
                                   "--normals", "given", "--report", report_path});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json requirements = json::parse(slurp(report_path))["similarity"]["requirements"];
  EXPECT_EQ(requirements.size(), read_mesh(given)->mesh.points.size());
  for (const json& r : requirements) EXPECT_EQ(r["flipped"], false);
}

TEST_F(Requirements, NormalsThatPointInwardAreRefusedUnlessReversed) {
  const std::string given = folder_ / "given.ply";
  const std::string inward = folder_ / "inward.ply";
  ASSERT_EQ(surpass({"subdivide", data("quad_torus.obj"), "-o", given, "--levels", "0", "--limit"})
                .status,
            0);
  Mesh mesh = read_mesh(given)->mesh;
  for (Channel& channel : mesh.channels) {
    if (channel.name != "normal") continue;
    for (double& c : channel.values) c = -c;
  }
  ASSERT_TRUE(write_mesh(mesh, inward));
  const std::vector<std::string> words = {"interpolate", given,        "-o",        control_,
                                          "--method",    "similarity", "--normals", inward};
  const Outcome refused = surpass(words);
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("point to the back of the faces"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("try --reverse-normals"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(control_));
  std::vector<std::string> reversed = words;
  reversed.emplace_back("--reverse-normals");
  EXPECT_EQ(surpass(reversed).status, 0);
  EXPECT_EQ(surpass({"check", control_, "--against", given, "--normals", given}).status, 0);
  reversed[7] = given;
  EXPECT_NE(surpass(reversed).err.find("leave out --reverse-normals"), std::string::npos);
  const Outcome alone =
      surpass({"interpolate", given, "-o", control_, "--method", "fair", "--reverse-normals"});
  EXPECT_EQ(alone.status, 1) << alone.err;
}

TEST_F(Requirements, AFolderIsNoFile) {
  for (const char* option : {"--requirements", "--only"}) {
    std::vector<std::string> words = {"interpolate", data("quad_torus.obj"), "-o", control_,
                                      option,        folder_ / "."};
    if (option == std::string("--requirements")) {
      words.insert(words.end(), {"--method", "similarity"});
    }
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be read"), std::string::npos) << outcome.err;
  }
}

TEST_F(Requirements, OnTheBoundaryAreMetInsideADummyRing) {
  const std::string given_path = data("quad_patch.ply");
  const Mesh given = read_mesh(given_path)->mesh;
  const auto topology = Topology::build(given).value();
  Index rim = 0;
  while (!topology.is_boundary(rim) || topology.faces_at(rim) != 2) ++rim;
  const std::string path =
      folder_.file("rim.json", list({{{"vertex", rim}, {"normal", {0.3, 0.1, 1}}}}).dump());
  const std::string control = folder_ / "control.obj";
  const std::string report_path = folder_ / "report.json";
  const auto interpolated = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"interpolate", given_path,      "-o",       control,
                                      "--scheme",    "catmull-clark", "--method", "similarity",
                                      "--report",    report_path};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const json report = json::parse(slurp(report_path));
    EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "");
    for (const json& r : report["similarity"].value("requirements", json::array())) {
      EXPECT_LT(r["error"], 1e-14) << r;
    }
    EXPECT_EQ(
        surpass({"check", control, "--against", given_path, "--tolerance", "1e-12", "--oracle"})
            .status,
        0);
    return report["similarity"]["open"];
  };
  const auto hole_faces = [&] { return read_mesh(control)->mesh.hole_faces.size(); };
  const std::size_t dummies = 2 * std::size_t{topology.boundary_edge_count()};
  EXPECT_EQ(interpolated({}), "boundary-rules");
  EXPECT_EQ(hole_faces(), 0U);
  EXPECT_EQ(interpolated({"--requirements", path}), "dummy-ring");
  EXPECT_EQ(hole_faces(), dummies);
  EXPECT_EQ(interpolated({"--requirements", path, "--open", "boundary-rules"}), "boundary-rules");
  EXPECT_EQ(interpolated({"--open", "dummy-ring"}), "dummy-ring");
  EXPECT_EQ(hole_faces(), dummies);
  const Outcome loop = surpass({"interpolate", data("tube.obj"), "-o", control, "--method",
                                "similarity", "--open", "dummy-ring", "--scheme", "loop"});
  EXPECT_EQ(loop.status, 1) << loop.err;
  EXPECT_NE(loop.err.find("dummy ring"), std::string::npos);
}

TEST_F(Requirements, AreOfTheMethodsThatHaveFreedom) {
  const Outcome outcome = run(list({kNormal}), {"--method", "progressive"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
}

}  // namespace
}  // namespace surpass::test

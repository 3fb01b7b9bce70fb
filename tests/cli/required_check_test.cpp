// `surpass check --requirements`: what interpolate was asked for is found in the file, and what is
// not there is named.
#include <surpass/surpass.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "requirement_samples.hpp"
#include "schema.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

class RequiredCheck : public testing::Test {
 protected:
  std::string list(const std::vector<json>& entries) {
    const std::string name = "list" + std::to_string(lists_++) + ".json";
    return folder_.file(name, json{{"requirements", entries}}.dump());
  }

  void make(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"interpolate", given_, "-o", control_};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = surpass(words);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  void make_by(const std::string& requirements, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--method", "similarity", "--requirements", requirements});
    make(more);
  }

  /// The report, which the schema takes.
  json check(const std::vector<std::string>& more, int status) {
    std::vector<std::string> words = {"check", control_, "--against", given_, "--report", report_};
    words.insert(words.end(), more.begin(), more.end());
    outcome_ = surpass(words);
    EXPECT_EQ(outcome_.status, status) << outcome_.err;
    if (status == 1) return {};
    json report = json::parse(slurp(report_));
    EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "") << report.dump(1);
    return report;
  }

  /// In each direction, so that whatever depends on it is missed.
  void move_vertex(Index v, double by) {
    Mesh control = read_mesh(control_)->mesh;
    for (double& c : control.points[v]) c += by;
    ASSERT_TRUE(write_mesh(control, control_));
  }
  /// The middle of the part of the surface where a requirement is.
  Index control_vertex_at(const json& requirement) const {
    const Mesh given = read_mesh(given_)->mesh;
    const Mesh control = read_mesh(control_)->mesh;
    if (requirement.contains("face")) {
      const Index face = requirement["face"];
      return control.face(given.face_offsets[face])[2];
    }
    const auto corner = std::find(given.face_vertices.begin(), given.face_vertices.end(),
                                  requirement["vertex"].get<Index>());
    return control.face(static_cast<Index>(corner - given.face_vertices.begin()))[2];
  }

  [[nodiscard]] bool says(const std::string& text) const {
    return outcome_.err.find(text) != std::string::npos;
  }

  TempFolder folder_;
  int lists_ = 0;
  std::string given_ = data("quad_torus.obj");
  std::string control_ = folder_ / "control.obj";
  std::string report_ = folder_ / "report.json";
  Outcome outcome_;
};

TEST_F(RequiredCheck, PassesWhatWasMadeWithThem) {
  const std::string all = list({kNormal, kPosition, kDirection, kDerivative, kRemove, kMoved});
  for (const char* method : {"similarity", "fair"}) {
    make({"--method", method, "--requirements", all});
    const json report = check({"--requirements", all, "--tolerance", "1e-12", "--oracle"}, 0);
    EXPECT_EQ(report["replaced"], 1);
    EXPECT_EQ(report["removed"], 1);
    EXPECT_TRUE(says(
        "1 is moved by requirements, compared with the new place, and 1 is removed, not compared"));
    EXPECT_LT(report["oracle"]["max"], 1e-13);
    ASSERT_EQ(report["requirements"].size(), 6U);
    for (const json& r : report["requirements"]) EXPECT_LT(r["error"], 1e-13) << r;
    EXPECT_EQ(report["requirements"][1]["what"], "position on face 5 at (0.5, 0.25)");
    EXPECT_NE(outcome_.out.find("6 of them"), std::string::npos) << outcome_.out;
    check({"--tolerance", "1e-12"}, 4);  // vertices 12 and 13 are elsewhere
  }
}

TEST_F(RequiredCheck, NamesWhatAMovedVertexMisses) {
  for (const json& one : {kNormal, kPosition, kDirection, kDerivative, kMoved}) {
    const std::string path = list({kRemove, one});
    make_by(path);
    check({"--requirements", path}, 0);
    move_vertex(control_vertex_at(one), 1e-6);
    const json report = check({"--requirements", path}, 4);
    EXPECT_TRUE(says("requirement 1 (")) << outcome_.err;
    EXPECT_GT(report["requirements"][1]["error"], 1e-8) << one;
    EXPECT_EQ(report["requirements"][0]["error"], 0);
    EXPECT_EQ(report["failure"]["code"], "not-converged");
    check({"--requirements", path, "--tolerance", "1e-4"}, 0);
  }
}

TEST_F(RequiredCheck, FailsWhatWasMadeWithoutThem) {
  for (const char* method : {"similarity", "progressive"}) {
    make({"--method", method, "--scheme", "catmull-clark"});
    check({}, 0);
    for (const json& one : {kNormal, kPosition, kDirection, kDerivative, kMoved}) {
      const json report = check({"--requirements", list({one})}, 4);
      EXPECT_TRUE(says("requirement 0 (")) << outcome_.err;
      EXPECT_GT(report["requirements"][0]["error"], 1e-3) << one;
    }
    check({"--requirements", list({kRemove})}, 0);
  }
}

// The fairest surface through one point is tiny, and errors are relative to the given box all the
// same, by either evaluator.
TEST_F(RequiredCheck, RemovedVerticesDoNotShrinkTheBox) {
  control_ = folder_ / "control.ply";
  const Mesh given = read_mesh(given_)->mesh;
  std::vector<json> removed;
  for (Index v = 0; v < given.vertex_count(); ++v) {
    if (v != 13) removed.push_back({{"vertex", v}, {"remove", true}});
  }
  const std::string path = list(removed);
  make({"--method", "fair", "--requirements", path, "--single"});
  const json found = check({"--requirements", path, "--tolerance", "1e-6", "--oracle"}, 0);
  EXPECT_NEAR(found["oracle"]["max"], found["error"]["max"].get<double>(), 1e-12);
}

// The surface of a mesh is that of the mesh refined once, and so are its derivatives.
TEST_F(RequiredCheck, TakesControlMeshesOfTheGivenTopology) {
  make({"--scheme", "catmull-clark"});
  const Mesh control = read_mesh(control_)->mesh;
  const auto surface = LimitSurface::create(control, {Scheme::catmull_clark}).value();
  const SurfaceSample s = surface.evaluate({5, 0.5, 0.25}).value();
  const std::string path =
      list({{{"face", 5}, {"uv", {0.5, 0.25}}, {"position", s.position}},
            {{"face", 5}, {"uv", {0.5, 0.25}}, {"along", {0, 1}}, {"derivative", s.dv}},
            {{"face", 5}, {"uv", {0.5, 0.25}}, {"normal", s.normal}}});
  const json report = check({"--requirements", path}, 0);
  for (const json& r : report["requirements"]) EXPECT_LT(r["error"], 1e-14) << r;
}

TEST_F(RequiredCheck, OppositeSignsAreMissed) {
  make_by(list({kNormal}));
  EXPECT_EQ(check({"--requirements", list({kNormal})}, 0)["requirements"][0]["flipped"], false);
  EXPECT_FALSE(says("the other way"));
  json opposite = kNormal;
  for (json& c : opposite["normal"]) c = -c.get<double>();
  const json report = check({"--requirements", list({opposite})}, 4);
  EXPECT_EQ(report["requirements"][0]["flipped"], true);
  EXPECT_GT(report["requirements"][0]["error"], 1e-3);
  EXPECT_TRUE(says("1 of 1 requirement points the other way")) << outcome_.err;
  EXPECT_TRUE(says(", the other way round)")) << outcome_.err;
}

TEST_F(RequiredCheck, NormalsOfTheGivenFile) {
  given_ = folder_ / "normals.ply";
  ASSERT_EQ(surpass({"subdivide", data("quad_torus.obj"), "-o", given_, "--levels", "0", "--limit"})
                .status,
            0);
  make({"--scheme", "catmull-clark", "--method", "fair", "--normals", "given"});
  const json report = check({"--normals", "given", "--tolerance", "1e-12"}, 0);
  EXPECT_EQ(report["requirements"].size(), read_mesh(given_)->mesh.points.size());
  move_vertex(control_vertex_at({{"vertex", 8}}), 1e-6);
  check({"--normals", "given"}, 4);
  EXPECT_TRUE(says("(normal at vertex ")) << outcome_.err;
}

TEST_F(RequiredCheck, OfSurfacesInsideADummyRing) {
  given_ = data("quad_patch.ply");
  const auto topology = Topology::build(read_mesh(given_)->mesh).value();
  Index rim = 0;
  while (!topology.is_boundary(rim) || topology.faces_at(rim) != 2) ++rim;
  const json normal = {{"vertex", rim}, {"normal", {0.3, 0.1, 1}}};
  const std::string path = list({normal, kPosition});
  make_by(path, {"--scheme", "catmull-clark"});
  ASSERT_FALSE(read_mesh(control_)->mesh.hole_faces.empty());
  check({"--requirements", path, "--tolerance", "1e-12"}, 0);
  move_vertex(control_vertex_at(normal), 1e-6);
  check({"--requirements", path}, 4);
  EXPECT_TRUE(says("requirement 0 (normal at vertex ")) << outcome_.err;
}

TEST_F(RequiredCheck, OfVerticesOfEveryScheme) {
  const std::string moves =
      list({{{"vertex", 1}, {"position", {0.9, 0.1, 0.2}}}, {{"vertex", 4}, {"remove", true}}});
  for (const char* scheme : {"loop", "doo-sabin", "catmull-clark"}) {
    given_ = data("sphere_irregular.obj");
    make_by(moves, {"--scheme", scheme});
    const json report = check({"--requirements", moves, "--tolerance", "1e-12"}, 0);
    EXPECT_EQ(report["scheme"], scheme);
    EXPECT_EQ(report["removed"], 1);
    check({"--tolerance", "1e-12"}, 4);
    if (scheme == std::string("catmull-clark")) continue;
    const std::string normal = list({kNormal});
    const Outcome refused = surpass({"interpolate", given_, "-o", folder_ / "x.obj", "--scheme",
                                     scheme, "--method", "similarity", "--requirements", normal});
    check({"--requirements", normal}, refused.status);
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(outcome_.err, refused.err);
  }
}

TEST_F(RequiredCheck, RefusesWhatCannotBeMeant) {
  make_by(list({kPosition}));
  // The same vertices, but face 5 is another one.
  Mesh other = read_mesh(given_)->mesh;
  std::rotate(other.face_vertices.begin(), other.face_vertices.begin() + 4,
              other.face_vertices.end());
  const std::string kept = given_;
  given_ = folder_ / "other.obj";
  ASSERT_TRUE(write_mesh(other, given_));
  check({}, 0);
  const json report = check({"--requirements", list({kPosition})}, 3);
  EXPECT_EQ(report["failure"]["code"], "mismatch");
  given_ = kept;
  check({"--requirements", list({kPosition, {{"vertex", 5000}, {"remove", true}}})}, 2);
  EXPECT_TRUE(says("requirement 1 (remove at vertex 5000)")) << outcome_.err;
  check({"--requirements", list({kMoved, {{"vertex", 13}, {"remove", true}}})}, 3);
  check({"--requirements", folder_ / "missing.json"}, 2);
  given_ = data("tube.obj");
  control_ = given_;
  check({"--requirements", list({kMoved}), "--scheme", "nonstationary-loop"}, 1);
  EXPECT_TRUE(says("nonstationary-loop")) << outcome_.err;
}

}  // namespace
}  // namespace surpass::test

// Reference limit positions and control meshes, computed by an independent prototype with dense
// linear algebra (progressive.json). Coordinates there have 15 digits.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "golden/json_points.hpp"
#include "support/meshes.hpp"

namespace surpass {
namespace {

struct Case {
  std::string name;
  Mesh mesh;
  Rules rules;
  std::vector<Point> limit;
  std::vector<Point> control;
};

Rules rules_of(const std::string& scheme, const std::string& boundary) {
  Rules rules;
  rules.scheme = scheme == "loop"            ? Scheme::loop
                 : scheme == "catmull-clark" ? Scheme::catmull_clark
                                             : Scheme::doo_sabin;
  rules.weights = scheme == "doosabin-cos" ? Weights::cosine : Weights::averaging;
  rules.boundary = boundary == "hoppe"    ? Boundary::hoppe
                   : boundary == "corner" ? Boundary::edge_and_corner
                                          : Boundary::edge_only;
  return rules;
}

// Cases of one scheme as the file names it.
std::vector<Case> cases_of(const std::string& scheme) {
  std::ifstream file(SURPASS_GOLDEN_DIR "/progressive.json");
  const auto json = nlohmann::json::parse(file);
  std::vector<Case> cases;
  for (const auto& entry : json.contains("cases") ? json["cases"] : json) {
    if (entry["scheme"] != scheme) continue;
    Case c;
    c.name = entry["name"].get<std::string>() + " " + entry["boundary"].get<std::string>();
    c.mesh.points = points_of(entry["vertices"]);
    for (const auto& face : entry["faces"]) c.mesh.add_face(face.get<std::vector<Index>>());
    for (const auto& e : entry["sharp_edges"]) {
      c.mesh.creases.push_back({{e[0].get<Index>(), e[1].get<Index>()}, e[2].get<float>()});
    }
    for (const auto& v : entry["sharp_vertices"]) {
      c.mesh.corners.push_back({v[0].get<Index>(), v[1].get<float>()});
    }
    c.rules = rules_of(scheme, entry["boundary"].get<std::string>());
    c.limit = points_of(entry["limit"]);
    c.control = points_of(entry["control"]);
    cases.push_back(std::move(c));
  }
  return cases;
}

class ProgressiveReference : public testing::TestWithParam<Case> {};

TEST_P(ProgressiveReference, LimitPositionsMatch) {
  const Case& c = GetParam();
  const auto limit = limit_positions(c.mesh, c.rules);
  ASSERT_TRUE(limit) << describe(limit.error());
  EXPECT_LT(test::max_distance(*limit, c.limit), 1e-12);
}

TEST_P(ProgressiveReference, ControlMeshesMatch) {
  const Case& c = GetParam();
  for (const Solver solver : {Solver::chebyshev, Solver::richardson, Solver::gauss_seidel}) {
    const auto result =
        interpolate(c.mesh, {.rules = c.rules, .solver = solver, .tolerance = 1e-15});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_LT(test::max_distance(result->control.points, c.control), 1e-12) << name_of(solver);
  }
}

std::string test_name(const testing::TestParamInfo<Case>& which) {
  std::string name = which.param.name;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Loop, ProgressiveReference, testing::ValuesIn(cases_of("loop")),
                         test_name);
INSTANTIATE_TEST_SUITE_P(DooSabinAveraging, ProgressiveReference,
                         testing::ValuesIn(cases_of("doosabin-cc78")), test_name);
INSTANTIATE_TEST_SUITE_P(DooSabinCosine, ProgressiveReference,
                         testing::ValuesIn(cases_of("doosabin-cos")), test_name);

TEST(ProgressiveReference, HasEveryCase) {
  EXPECT_EQ(cases_of("loop").size(), 13U);
  EXPECT_EQ(cases_of("doosabin-cc78").size(), 7U);
  EXPECT_EQ(cases_of("doosabin-cos").size(), 7U);
}

}  // namespace
}  // namespace surpass

// Reference control meshes of similarity interpolation, computed by an independent prototype with
// dense linear algebra: similarity.json and, with other weights, similarity_full.json.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "golden/json_points.hpp"
#include "support/meshes.hpp"

namespace surpass {
namespace {

nlohmann::json parsed(const std::string& name) {
  std::ifstream file(SURPASS_GOLDEN_DIR "/" + name);
  return nlohmann::json::parse(file);
}

Mesh mesh_of(const nlohmann::json& points, const nlohmann::json& faces) {
  Mesh mesh;
  mesh.points = points_of(points);
  for (const auto& face : faces) mesh.add_face(face.get<std::vector<Index>>());
  return mesh;
}

// The files number the points of edges in an order of their own.
std::vector<Point> in_our_order(const Mesh& mesh, const nlohmann::json& edges,
                                const std::vector<Point>& theirs) {
  const auto topology = Topology::build(mesh).value();
  std::vector<Point> ours = theirs;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Index e = topology.find_edge(edges[k][0].get<Index>(), edges[k][1].get<Index>());
    ours[mesh.points.size() + e] = theirs[mesh.points.size() + k];
  }
  return ours;
}

std::vector<Point> joined(const nlohmann::json& found) {
  std::vector<Point> points;
  for (const char* part : {"vertex_points", "edge_points", "face_points"}) {
    const auto some = points_of(found[part]);
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

SimilarityOptions solved(Similarity similarity, RowWeights weights = RowWeights::none) {
  SimilarityOptions options;
  options.similarity = similarity;
  options.row_weights = weights;
  options.solver_tolerance = 1e-13;
  return options;
}

void expect_control(const Mesh& mesh, const SimilarityOptions& options,
                    const std::vector<Point>& expected, double tolerance) {
  const auto found = interpolate_similar(mesh, options);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->report.solver_converged) << found->report.residual;
  EXPECT_LT(test::max_distance(found->control.points, expected), tolerance)
      << name_of(options.similarity) << ", " << name_of(options.row_weights);
}

TEST(SimilarityReference, ControlMeshesMatch) {
  const auto cases = parsed("similarity.json");
  ASSERT_EQ(cases.size(), 3U);
  for (const auto& entry : cases) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const Mesh mesh = mesh_of(entry["vertices"], entry["faces"]);
    const auto expected = [&](const char* form) {
      return in_our_order(mesh, entry["edges"], joined(entry[form]));
    };
    expect_control(mesh, solved(Similarity::vectors), expected("vectors"), 1e-10);
    expect_control(mesh, solved(Similarity::directions), expected("directions_none"), 1e-10);
    expect_control(mesh, solved(Similarity::directions, RowWeights::regularised),
                   expected("directions_reg"), 1e-10);
  }
}

TEST(SimilarityReference, GaussSeidelSolvesTheSameSystem) {
  for (const auto& entry : parsed("similarity.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const Mesh mesh = mesh_of(entry["vertices"], entry["faces"]);
    for (const auto& [similarity, form] : {std::pair(Similarity::vectors, "vectors"),
                                           std::pair(Similarity::directions, "directions_none")}) {
      SimilarityOptions options = solved(similarity);
      options.solver = SimilaritySolver::gauss_seidel;
      expect_control(mesh, options, in_our_order(mesh, entry["edges"], joined(entry[form])), 1e-10);
    }
  }
}

TEST(SimilarityReference, OtherWeightsMatchToo) {
  const auto cases = parsed("similarity_full.json");
  for (const char* name : {"cube", "tetra", "cubepull"}) {
    SCOPED_TRACE(name);
    const auto& entry = cases[name];
    const Mesh mesh = mesh_of(entry["P"], entry["faces"]);
    const auto expected = [&](const char* form) {
      return in_our_order(mesh, entry["edges"], points_of(entry[form]));
    };
    expect_control(mesh, solved(Similarity::directions), expected("Q_dir"), 1e-10);
    expect_control(mesh, solved(Similarity::directions, RowWeights::unit), expected("Q_dir_full"),
                   1e-10);
    expect_control(mesh, solved(Similarity::vectors), expected("Q_vec"), 1e-10);
  }
}

// The prototype's mean for the weights by order counts each derivative once, however many patches
// share it; here every sample of every patch counts, as in the sum itself. Another weighting, so
// the results are alike and not equal.
TEST(SimilarityReference, WeightsByOrderDifferByTheirMean) {
  const auto cases = parsed("similarity_full.json");
  const auto& entry = cases["cubepull"];
  const Mesh mesh = mesh_of(entry["P"], entry["faces"]);
  const auto expected =
      in_our_order(mesh, entry["edges"], points_of(entry["Q_dir_order_weighted_by_plain_mean"]));
  const auto found = interpolate_similar(mesh, solved(Similarity::directions, RowWeights::order));
  ASSERT_TRUE(found);
  const double distance = test::max_distance(found->control.points, expected);
  EXPECT_GT(distance, 1e-6);
  EXPECT_LT(distance, 1e-2);
}

TEST(SimilarityReference, ReferencesMatchBeforeAnyIteration) {
  const auto cases = parsed("similarity_full.json");
  for (const char* name : {"cube", "tetra", "cubepull"}) {
    SCOPED_TRACE(name);
    const auto& entry = cases[name];
    const Mesh mesh = mesh_of(entry["P"], entry["faces"]);
    SimilarityOptions options;
    options.max_iterations = 0;
    const auto found = interpolate_similar(mesh, options);
    ASSERT_TRUE(found) << describe(found.error());
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(found->report.scale[k], entry["s"][k].get<double>(), 1e-12);
    }
    // The given vertices' points are moved to interpolate; all others are the reference's.
    auto expected = in_our_order(mesh, entry["edges"], points_of(entry["Ghat"]));
    std::copy_n(found->control.points.begin(), mesh.points.size(), expected.begin());
    EXPECT_LT(test::max_distance(found->control.points, expected), 1e-12);
  }
}

}  // namespace
}  // namespace surpass

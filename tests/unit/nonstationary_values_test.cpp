// Parameters, shares and places against the values of an independent implementation.
#include <gtest/gtest.h>

#include "nonstationary_reference.hpp"
#include "nonstationary_samples.hpp"

namespace surpass {
namespace {

constexpr double kClose = 1e-12;

double solved(Index valence, const NonstationaryOptions& options, double along = 0) {
  const auto found = interpolating_parameter(valence, options, along);
  EXPECT_TRUE(found) << describe(found.error());
  return found.value_or(NAN);
}

TEST(NonstationaryParameters, AreThoseOfTheReference) {
  for (const auto& row : test::kParameters) {
    for (std::size_t i = 0; i < std::size(test::kShapes); ++i) {
      const NonstationaryOptions options{.shape = test::kShapes[i], .steps = row.steps};
      EXPECT_NEAR(solved(row.valence, options), row.parameters[i], kClose);
      if (row.valence == 3) continue;
      EXPECT_EQ(solved(50, options), solved(4, options));
    }
  }
  EXPECT_EQ(std::size(test::kParameters), 18);
}

TEST(NonstationaryParameters, AreThoseOfTheReferenceAtOtherRates) {
  for (const auto& row : test::kRates) {
    NonstationaryOptions options{.shape = row.shape, .rate = row.rate};
    EXPECT_NEAR(solved(row.valence, options), row.limit, kClose);
    options.steps = 7;
    EXPECT_NEAR(solved(row.valence, options), row.seven, kClose);
  }
  EXPECT_EQ(std::size(test::kRates), 24);
}

TEST(NonstationaryParameters, AreThoseOfTheReferenceWithLoopsWeights) {
  constexpr double kThree[] = {-3, -1.5, 0};
  for (const auto& row : test::kClassic) {
    for (std::size_t i = 0; i < 3; ++i) {
      NonstationaryOptions options{.shape = kThree[i], .weights = LoopWeights::classic};
      EXPECT_NEAR(solved(row.valence, options), row.limit[i], kClose);
      options.steps = 7;
      EXPECT_NEAR(solved(row.valence, options), row.seven[i], kClose);
    }
  }
  EXPECT_EQ(std::size(test::kClassic), 10);
}

TEST(NonstationaryParameters, SolveForTheirTarget) {
  for (const double shape : {-3.5, -1.5, 0.0, 1.9}) {
    for (const double along : {-2.0, -0.5, 0.0, 0.01, 0.9 * (0.5 + shape / 8)}) {
      for (const int steps : {0, 1, 2, 5, 40}) {
        for (const Index valence : {3U, 5U, 11U}) {
          const NonstationaryOptions options{.shape = shape, .steps = steps};
          const double parameter = solved(valence, options, along);
          EXPECT_NEAR(centroid_share(parameter, valence, options), along, 4e-15);
        }
      }
    }
  }
}

TEST(NonstationaryParameters, LieInTheProvenBracket) {
  for (const double rate : {4.5, 8.0, 16.0, std::numeric_limits<double>::infinity()}) {
    for (const Index valence : {3U, 4U, 6U, 50U}) {
      for (double shape = -3.999; shape < 4; shape += 0.05) {
        const NonstationaryOptions options{
            .shape = shape, .weights = LoopWeights::classic, .rate = rate};
        const double parameter = solved(valence, options);
        EXPECT_LE(parameter, 0);
        EXPECT_LE(std::abs(centroid_share(parameter, valence, options)), 8e-16);
      }
    }
  }
}

TEST(NonstationaryParameters, AreRefusedWhereThereAreNone) {
  const auto code = [](Index valence, const NonstationaryOptions& options, double along = 0) {
    const auto found = interpolating_parameter(valence, options, along);
    return found ? std::string("found") : found.error().message;
  };
  EXPECT_NE(code(2, {}).find("valence is 2"), std::string::npos);
  EXPECT_NE(code(4, {.shape = 4}).find("between -4 and 4"), std::string::npos);
  EXPECT_NE(code(4, {.shape = NAN}).find("between -4 and 4"), std::string::npos);
  EXPECT_NE(code(4, {.rate = 1}).find("above 1"), std::string::npos);
  EXPECT_NE(code(4, {.shape = -1.5}, 0.3125).find("below 0.3125"), std::string::npos);
  EXPECT_NE(code(4, {.iteration = ParameterIteration::exponential}).find("cannot interpolate"),
            std::string::npos);
}

TEST(NonstationaryShares, AreThoseOfTheReference) {
  for (const auto& row : test::kUniform) {
    const NonstationaryOptions options{.rule = NonstationaryRule::uniform};
    EXPECT_NEAR(centroid_share(row.parameter, row.valence, options), row.share, kClose);
  }
  EXPECT_EQ(std::size(test::kUniform), 14);
  for (const auto& row : test::kShares) {
    const NonstationaryOptions options{.shape = -0.7, .steps = row.steps};
    EXPECT_NEAR(centroid_share(0.3, row.valence, options), row.share, kClose);
  }
  EXPECT_EQ(std::size(test::kShares), 10);
}

Mesh sample(test::Sample which) {
  switch (which) {
    case test::Sample::tetrahedron: return test::reference_tetrahedron();
    case test::Sample::bipyramid: return test::reference_bipyramid(3);
    case test::Sample::icosahedron: return test::icosahedron();
    case test::Sample::fan: break;
  }
  return test::wavy_fan(6);
}

/// The number of the vertex that a row means.
Index vertex_of(const test::PlaceRow& row, const Mesh& given) {
  if (row.b == kNone) return row.a;
  const auto topology = Topology::build(given).value();
  const Index born = given.vertex_count() + topology.find_edge(row.a, row.b);
  if (!row.half) return born;
  const auto surface = test::made(given, {}, 1);
  const auto finer = Topology::build(surface.mesh()).value();
  return surface.mesh().vertex_count() + finer.find_edge(row.a, born);
}

TEST(NonstationaryPlaces, AreThoseOfTheReference) {
  for (const auto& row : test::kPlaces) {
    const Mesh given = sample(row.mesh);
    const NonstationaryOptions options{.shape = row.shape, .steps = row.steps};
    // Limits are checked at the level where the vertex is born and at the next.
    const int first = row.level > 0 ? row.level : row.half ? 2 : row.b == kNone ? 0 : 1;
    const int last = row.level > 0 ? row.level : first + 2;
    for (int level = first; level <= last; ++level) {
      const auto surface = test::made(given, options, level);
      const auto points = row.level > 0 ? surface.mesh().points : surface.limit_positions().value();
      const Point found = points[vertex_of(row, given)];
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], row.place[c], kClose);
    }
  }
  EXPECT_EQ(std::size(test::kPlaces), 138);
}

double sum_of_squares(const std::vector<Point>& points) {
  double sum = 0;
  for (const Point& p : points) sum += p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  return sum;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Point& a = mesh.points[mesh.face(f)[0]];
    const Point& b = mesh.points[mesh.face(f)[1]];
    const Point& c = mesh.points[mesh.face(f)[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

TEST(NonstationaryPlaces, AddUpToTheSumsOfTheReference) {
  const auto expect_sum = [](double found, double sum) { EXPECT_NEAR(found, sum, kClose * sum); };
  for (const auto& row : test::kSums) {
    const auto surface = test::made(sample(row.mesh), {.shape = row.shape, .steps = row.steps}, 3);
    const Mesh& mesh = surface.mesh();
    EXPECT_EQ(mesh.vertex_count(), row.vertices);
    EXPECT_EQ(mesh.face_count(), row.faces);
    expect_sum(sum_of_squares(mesh.points), row.squares);
    expect_sum(volume(mesh), row.volume);
    const Mesh limit = surface.limit_mesh().value();
    expect_sum(sum_of_squares(limit.points), row.limit_squares);
    expect_sum(volume(limit), row.limit_volume);
  }
  EXPECT_EQ(std::size(test::kSums), 9);
}

TEST(NonstationaryPlaces, OfTheUniformSchemeAreThoseOfTheReference) {
  const auto surface =
      test::made(test::icosahedron(), {.rule = NonstationaryRule::uniform, .shape = 0.25}, 1);
  const auto topology = Topology::build(test::icosahedron()).value();
  const Point at_vertex = {-0.948176274578121, 1.534181439593653, 0};
  const Point at_edge = {-1.277766994374947, 0.789703432226513, 0.488063562148434};
  const Index born = 12 + topology.find_edge(0, 11);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(surface.mesh().points[0][c], at_vertex[c], kClose);
    EXPECT_NEAR(surface.mesh().points[born][c], at_edge[c], kClose);
  }
}

}  // namespace
}  // namespace surpass

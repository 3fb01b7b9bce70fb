// Good clouds: the right topology, every point used, vertices that are the points.
#include <cmath>
#include <memory>

#include "reconstruct_clouds.hpp"
#include "support/meshes.hpp"

namespace surpass::test {
namespace {

TEST(Reconstruct, ClosedSurfacesOfEveryGenus) {
  const std::vector<Cloud> clouds = {sphere_cloud(2000), torus_cloud(3000, 1),
                                     double_torus_cloud()};
  for (std::size_t genus = 0; genus < clouds.size(); ++genus) {
    SCOPED_TRACE(genus);
    const Cloud cloud = shuffled(clouds[genus], 7);
    const Reconstruction found = reconstructed(cloud);
    expect_closed(found, genus);
    expect_input_points(found, cloud);
    EXPECT_EQ(found.mesh.vertex_count(), cloud.size());
    EXPECT_TRUE(found.unused.empty());
    EXPECT_EQ(found.report.outliers, 0U);
    EXPECT_EQ(found.report.smoothing_passes, 0U);
    EXPECT_TRUE(found.report.warnings.empty());
  }
}

TEST(Reconstruct, TheVolumeIsThatOfTheBody) {
  const Reconstruction found = reconstructed(sphere_cloud(5000));
  EXPECT_NEAR(volume(found.mesh), 4 * M_PI / 3, 0.01);
  EXPECT_NEAR(volume(reconstructed(torus_cloud(8000, 3)).mesh), 2 * M_PI * M_PI * 0.16, 0.02);
}

TEST(Reconstruct, SpacingIsMeasured) {
  // On a square grid: four neighbours at 1, two of the four at the square root of 2.
  Cloud grid;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) grid.push_back({i / 49.0, j / 49.0, 0});
  }
  const Reconstruction found = reconstructed(grid);
  EXPECT_NEAR(found.report.spacing, (4 + 2 * std::sqrt(2.0)) / 6 / 49, 1e-12);
  ASSERT_TRUE(found.report.noise);
  EXPECT_NEAR(*found.report.noise, 0, 1e-9);
}

TEST(Reconstruct, NoiseIsMeasured) {
  const Cloud cloud = torus_cloud(4000, 4);
  const double spacing = reconstructed(cloud).report.spacing * 2.8;
  for (const double sigma : {0.1, 0.3, 0.5}) {
    const Reconstruction found = reconstructed(with_noise(cloud, sigma * spacing, 5));
    ASSERT_TRUE(found.report.noise);
    EXPECT_NEAR(*found.report.noise, sigma, 0.3 * sigma) << sigma;
  }
  // Nearly even points, of which the spacing after the noise is measured here, too.
  for (const double sigma : {0.1, 0.2, 0.3}) {
    const Reconstruction found =
        reconstructed(with_noise(sphere_cloud(8000), sigma * std::sqrt(4 * M_PI / 8000), 3));
    const double truth = sigma * std::sqrt(4 * M_PI / 8000) / found.report.box_side;
    EXPECT_NEAR(*found.report.noise * found.report.spacing, truth, 0.03 * truth) << sigma;
  }
}

// A grid on the torus of radii 3 and 1.
Cloud torus_grid(int along, int around) {
  Cloud cloud;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const double u = 2 * M_PI * i / along;
      const double v = 2 * M_PI * j / around;
      cloud.push_back(
          {(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
    }
  }
  return cloud;
}

TEST(Reconstruct, CurvatureIsNoNoise) {
  for (const auto& [cloud, genus] : {std::pair{torus_grid(16, 10), 1U},
                                     {torus_grid(24, 10), 1U},
                                     {torus_grid(60, 16), 1U},
                                     {icosahedron().points, 0U},
                                     {sphere_cloud(20), 0U},
                                     {cube_cloud(7), 0U}}) {
    SCOPED_TRACE(cloud.size());
    const Reconstruction found = reconstructed(cloud);
    expect_closed(found, genus);
    expect_input_points(found, cloud);
    EXPECT_EQ(found.mesh.vertex_count(), cloud.size());
    EXPECT_EQ(found.report.smoothing_passes, 0U);
    EXPECT_TRUE(found.report.warnings.empty()) << found.report.warnings.front();
    EXPECT_EQ(found.report.noise.has_value(), cloud.size() >= 180);
    EXPECT_LT(found.report.noise.value_or(0), 0.06);
  }
}

TEST(Reconstruct, TheFewPointsOfACubeStayWhereTheyAre) {
  const Cloud cloud = cube_cloud(4);
  const Reconstruction found = reconstructed(cloud);
  expect_input_points(found, cloud);
  EXPECT_FALSE(found.report.smoothed_positions);
  EXPECT_FALSE(found.report.sheet_gap);
  EXPECT_TRUE(found.mesh == reconstructed(cloud, {.smoothing = Choice::off}).mesh);
}

TEST(Reconstruct, NoSmoothingThatTearsTheSurface) {
  // A dense sphere whose scatter calls for smoothing, and a ring of tubes too coarse for it.
  Cloud cloud = with_noise(sphere_cloud(3000), 0.2 * std::sqrt(4 * M_PI / 3000), 3);
  for (Point p : torus_grid(16, 10)) {
    for (double& x : p) x *= 0.05;
    p[0] += 3;
    cloud.push_back(p);
  }
  const Reconstruction found = reconstructed(cloud);
  const Reconstruction smooth = reconstructed(cloud, {.smoothing = Choice::on});
  const Reconstruction plain = reconstructed(cloud, {.smoothing = Choice::off});
  ASSERT_GT(smooth.report.open_loops, plain.report.open_loops);
  ASSERT_LE(plain.unused.size(), smooth.unused.size() + 15);
  EXPECT_LT(found.report.open_loops, smooth.report.open_loops);
  expect_input_points(found, cloud);
  EXPECT_EQ(found.report.smoothing_passes, 0U);
  EXPECT_FALSE(found.report.smoothed_positions);
  ASSERT_FALSE(found.report.warnings.empty());
  EXPECT_NE(found.report.warnings.front().find("not smoothed"), std::string::npos)
      << found.report.warnings.front();
}

TEST(Reconstruct, NoisyPointsAreSmoothedWhereThatIsNeeded) {
  const Cloud cloud = torus_cloud(4000, 4);
  const double spacing = reconstructed(cloud).report.spacing * 2.8;
  for (const double sigma : {0.1, 0.3, 0.5}) {
    SCOPED_TRACE(sigma);
    const Cloud noisy = with_noise(cloud, sigma * spacing, 6);
    const Reconstruction found = reconstructed(noisy);
    expect_closed(found, 1);
    EXPECT_EQ(found.report.smoothing_passes > 0, sigma > 0.2);
    if (!found.report.smoothed_positions) expect_input_points(found, noisy);
  }
}

TEST(Reconstruct, FewerLoopsAreNotPaidForWithHandles) {
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Cloud cloud = with_outliers({{0, 0, 0}, {1, 1, 1}}, 300, seed);  // no surface at all
    const auto in = [&](Choice smoothing) {
      return reconstructed(cloud, {.outliers = Choice::off, .smoothing = smoothing});
    };
    const Reconstruction found = in(Choice::automatic);
    if (found.report.smoothing_passes == 0) continue;
    const Reconstruction plain = in(Choice::off);
    if (!found.report.genus || !plain.report.genus) continue;
    if (plain.report.open_loops >= found.report.open_loops) continue;
    ++met;
    EXPECT_GT(*plain.report.genus, *found.report.genus) << seed;
  }
  EXPECT_GT(met, 0);
}

// CGAL's front would break ties by addresses, and those depend on what was allocated before.
TEST(Reconstruct, TheSameWhateverWasAllocatedBefore) {
  const Cloud cloud = torus_cloud(4000, 4);
  const Cloud noisy = with_noise(cloud, reconstructed(cloud).report.spacing, 8);
  const ReconstructOptions options{.outliers = Choice::off, .smoothing = Choice::off};
  const Reconstruction first = reconstructed(noisy, options);
  std::mt19937_64 random(1);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 20000; ++k) {
      blocks.push_back(std::make_unique<char[]>(random() % 5000));
      blocks[random() % blocks.size()].reset();
    }
    EXPECT_TRUE(reconstructed(noisy, options).mesh == first.mesh) << round;
  }
}

TEST(Reconstruct, PositionsCanBeForced) {
  const Cloud cloud = torus_cloud(4000, 4);
  const double spacing = reconstructed(cloud).report.spacing * 2.8;
  const Cloud noisy = with_noise(cloud, 0.4 * spacing, 8);
  const Reconstruction original =
      reconstructed(noisy, {.smoothing = Choice::on, .positions = Positions::original});
  EXPECT_FALSE(original.report.smoothed_positions);
  expect_input_points(original, noisy);
  const Reconstruction smooth = reconstructed(noisy, {.positions = Positions::smoothed});
  ASSERT_TRUE(smooth.report.smoothed_positions);
  // Distance from the torus, whose equation is known.
  const auto roughness = [](const Mesh& mesh) {
    double sum = 0;
    for (const auto& [x, y, z] : mesh.points) {
      sum += std::pow(std::hypot(std::hypot(x, y) - 1, z) - 0.4, 2);
    }
    return std::sqrt(sum / static_cast<double>(mesh.points.size()));
  };
  EXPECT_LT(roughness(smooth.mesh), 0.6 * roughness(original.mesh));
}

TEST(Reconstruct, OutliersAreLeftOut) {
  const Cloud cloud = torus_cloud(4000, 9);
  for (const std::size_t count : {std::size_t{40}, std::size_t{200}}) {
    SCOPED_TRACE(count);
    const Cloud dirty = with_outliers(cloud, count, 10);
    const Reconstruction found = reconstructed(dirty);
    expect_closed(found, 1);
    expect_input_points(found, dirty);
    std::size_t unused_outliers = 0;
    for (const Index i : found.unused) {
      if (i >= cloud.size()) ++unused_outliers;
    }
    EXPECT_GE(unused_outliers, count * 95 / 100);
    EXPECT_LE(found.unused.size() - unused_outliers, cloud.size() / 50);
    EXPECT_FALSE(found.report.warnings.empty());
    const Reconstruction kept = reconstructed(dirty, {.outliers = Choice::off, .perimeter = 0.0});
    EXPECT_EQ(kept.report.outliers, 0U);
    EXPECT_LT(kept.unused.size(), found.unused.size());
  }
}

TEST(Reconstruct, AnOpenSheetKeepsItsOutline) {
  const Reconstruction found = reconstructed(wave_cloud(40));
  EXPECT_EQ(found.report.open_loops, 1U);
  EXPECT_EQ(found.report.genus, 0U);
  EXPECT_EQ(found.report.pieces, 1U);
}

TEST(Reconstruct, HolesAreFilledAsAsked) {
  Cloud cloud;  // a sphere without the cap above z = 0.8: a hole of some 60 edges
  for (const Point& p : sphere_cloud(5000)) {
    if (p[2] < 0.8) cloud.push_back(p);
  }
  const ReconstructOptions bounded = {.perimeter = 8.0};
  for (const Closing closing : {Closing::none, Closing::small}) {
    ReconstructOptions options = bounded;
    options.close = closing;
    EXPECT_EQ(reconstructed(cloud, options).report.open_loops, 1U);
  }
  ReconstructOptions all = bounded;
  all.close = Closing::all;
  const Reconstruction closed = reconstructed(cloud, all);
  expect_closed(closed, 0);
  EXPECT_EQ(closed.report.filled_loops, 1U);
  expect_input_points(closed, cloud);
}

TEST(Reconstruct, OpenPiecesLookAlongTheirNormals) {
  const Cloud cloud = wave_cloud(30);
  for (const double sign : {1.0, -1.0}) {
    Channel normals{"normal", {"nx", "ny", "nz"}, {}};
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      normals.values.insert(normals.values.end(), {0, 0, sign});
    }
    const auto found = reconstruct(cloud, std::vector<Channel>{normals});
    ASSERT_TRUE(found);
    // At the outline a few triangles may stand on edge; the sheet as a whole must not be turned.
    Index along = 0;
    for (Index f = 0; f < found->mesh.face_count(); ++f) {
      const auto face = found->mesh.face(f);
      const auto& [a, b, c] = std::array{found->mesh.points[face[0]], found->mesh.points[face[1]],
                                         found->mesh.points[face[2]]};
      const double z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      if (z * sign > 0) ++along;
    }
    EXPECT_GT(along, found->mesh.face_count() * 95 / 100);
  }
}

TEST(Reconstruct, ChannelsGoWithTheVertices) {
  const Cloud cloud = sphere_cloud(500);
  Channel colour{"color", {"red", "green", "blue"}, {}, Storage::uint8};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      colour.values.push_back(static_cast<double>((7 * i + k) % 256));
  }
  const auto found = reconstruct(cloud, std::vector<Channel>{colour}, {.vertices = Index{100}});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->mesh.channels.size(), 1U);
  const Channel& carried = found->mesh.channels[0];
  EXPECT_EQ(carried.parts, colour.parts);
  EXPECT_EQ(carried.storage, colour.storage);
  ASSERT_EQ(carried.values.size(), 3 * found->source.size());
  for (std::size_t v = 0; v < found->source.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(carried.values[3 * v + k], colour.values[3 * found->source[v] + k]);
    }
  }
}

TEST(Reconstruct, ChannelsThatAreNotFiniteAreNamedAndLeftOut) {
  Cloud cloud = sphere_cloud(500);
  cloud.push_back({std::nan(""), 0, 0});
  Channel normals{"normal", {"nx", "ny", "nz"}, {}};
  Channel heat{"heat", {"heat"}, std::vector<double>(cloud.size(), 1)};
  for (const Point& p : cloud) normals.values.insert(normals.values.end(), p.begin(), p.end());
  for (const std::size_t i : {3U, 70U, 311U}) heat.values[i] = INFINITY;
  const auto found = reconstruct(cloud, std::vector<Channel>{heat, normals});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->mesh.channels.size(), 1U);  // what is dropped with its point does not count
  EXPECT_EQ(found->mesh.channels[0].name, "normal");
  EXPECT_EQ(found->report.warnings,
            std::vector<std::string>{
                "the channel 'heat' is left out: at 3 of 500 points it is not finite"});
  const Reconstruction without = reconstructed(cloud);
  EXPECT_EQ(found->mesh.points, without.mesh.points);
  EXPECT_EQ(found->mesh.face_vertices, without.mesh.face_vertices);
}

TEST(Reconstruct, TheSameForAnyNumberOfThreadsAndAgain) {
  // The cube's grid is full of equal radii, which the front must not settle by addresses.
  const Cloud rough = with_outliers(with_noise(torus_cloud(3000, 12), 0.01, 13), 60, 14);
  for (const Cloud& cloud : {rough, cube_cloud(12)}) {
    const ReconstructOptions options = {.smoothing = Choice::on, .tolerance = 1e-3};
    const auto once = reconstruct(cloud, {}, options, {.threads = 1});
    ASSERT_TRUE(once);
    for (const int threads : {1, 2, 3, 8}) {
      const auto again = reconstruct(cloud, {}, options, {.threads = threads});
      ASSERT_TRUE(again);
      EXPECT_TRUE(again->mesh == once->mesh) << threads;
      EXPECT_EQ(again->source, once->source);
      EXPECT_EQ(again->unused, once->unused);
    }
  }
}

TEST(Reconstruct, StopsInEveryStage) {
  const Cloud cloud = with_noise(torus_cloud(3000, 12), 0.02, 13);
  const ReconstructOptions options = {.smoothing = Choice::on, .vertices = Index{200}};
  std::vector<std::string> stages;
  Context listening{.progress = [&](const Progress& p) {
    EXPECT_GE(p.fraction, 0);
    EXPECT_LE(p.fraction, 1);
    if (stages.empty() || stages.back() != p.stage) stages.emplace_back(p.stage);
  }};
  ASSERT_TRUE(reconstruct(cloud, {}, options, listening));
  for (const char* expected : {"outliers", "noise", "smooth", "delaunay", "front", "simplify"}) {
    EXPECT_NE(std::find(stages.begin(), stages.end(), expected), stages.end()) << expected;
    std::atomic<bool> cancel = false;
    const Context stopping{.progress =
                               [&](const Progress& p) {
                                 if (p.stage == expected) cancel = true;
                               },
                           .cancel = &cancel};
    const auto stopped = reconstruct(cloud, {}, options, stopping);
    ASSERT_FALSE(stopped) << expected;
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled) << expected;
  }
}

TEST(Reconstruct, TheLimitSurfacePassesTheVerticesUnderEveryScheme) {
  const Cloud cloud = torus_cloud(2000, 20);
  const Reconstruction found = reconstructed(cloud, {.vertices = Index{500}});
  for (const Scheme scheme : {Scheme::doo_sabin, Scheme::loop, Scheme::catmull_clark}) {
    const Rules rules{.scheme = scheme};
    const auto control = interpolate(found.mesh, {.rules = rules, .tolerance = 1e-12});
    ASSERT_TRUE(control) << describe(control.error());
    EXPECT_LT(certify(control->control, found.mesh.points, rules)->max, 1e-12);
    const auto far = limit_distances(cloud, found.source, found.unused, control->control, rules);
    ASSERT_TRUE(far) << describe(far.error());
    EXPECT_EQ(far->all.count, cloud.size());
    EXPECT_LT(far->all.max, 0.2);
    EXPECT_GT(far->all.max, 1e-6);
    ASSERT_TRUE(far->sampling);
    EXPECT_LT(*far->sampling, 0.1 * far->all.max);
  }
}

}  // namespace
}  // namespace surpass::test

// A prepared refinement has the bits of one that is made anew, for the points that it was prepared
// with and for others.
#include <surpass/refiner.hpp>

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "support/polygons.hpp"

namespace surpass {
namespace {

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}
bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return same_bits(flat(std::span(a)), flat(std::span(b)));
}

// Channels of three widths and, in every mesh large enough, a hole.
Mesh with_extras(Mesh mesh) {
  const std::vector<std::vector<std::string>> widths = {
      {"w"}, {"r", "g", "b"}, {"1", "2", "3", "4", "5"}};
  mesh.channels.clear();
  for (const auto& parts : widths) {
    Channel channel{"width " + std::to_string(parts.size()), parts, {}};
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      for (std::size_t c = 0; c < parts.size(); ++c) {
        channel.values.push_back(std::sin(v + 0.7 * static_cast<double>(c)));
      }
    }
    mesh.channels.push_back(std::move(channel));
  }
  if (mesh.face_count() > 10) mesh.hole_faces = {3, 4, 8};
  return mesh;
}

Result<Mesh> made_anew(const Mesh& mesh, const RefinerOptions& options) {
  return options.limit ? limit_mesh(mesh, options.rules, options.levels)
                       : refine(mesh, options.rules, options.levels);
}

// False if the scheme does not take the mesh.
bool check(const Mesh& mesh, const RefinerOptions& options) {
  const auto expected = made_anew(mesh, options);
  const auto refiner = Refiner::create(mesh, options);
  EXPECT_EQ(bool{expected}, bool{refiner});
  if (!expected || !refiner) return false;
  EXPECT_EQ(*expected, refiner->mesh());
  EXPECT_TRUE(same_bits(expected->points, refiner->mesh().points));

  std::mt19937_64 random(5);
  const Mesh moved = test::jitter(mesh, random, 0.3);
  const Mesh expected_moved = made_anew(moved, options).value();
  for (const int threads : {1, 2, 3, 8}) {
    const Context context{.threads = threads};
    EXPECT_TRUE(same_bits(expected_moved.points, refiner->refine(moved.points, context).value()));
    for (std::size_t k = 0; k < mesh.channels.size(); ++k) {
      const Channel& channel = moved.channels[k];
      std::vector<double> found(refiner->mesh().points.size() * channel.width());
      EXPECT_TRUE(refiner->refine(channel.width(), channel.values, found, context));
      EXPECT_TRUE(same_bits(expected_moved.channels[k].values, found)) << channel.name;
    }
  }
  return true;
}

void check_all_kinds(const Mesh& given, Scheme scheme, int most_levels, int& checked) {
  const Mesh mesh = with_extras(given);
  for (const Boundary boundary :
       {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe}) {
    for (int levels = 0; levels <= most_levels; ++levels) {
      for (const bool limit : {false, true}) {
        checked += check(mesh, {{scheme, boundary}, levels, limit}) ? 1 : 0;
      }
    }
  }
}

class RefinerOf : public testing::TestWithParam<Scheme> {};

TEST_P(RefinerOf, HasTheBitsOfRefineOnRandomMeshes) {
  int checked = 0;
  for (int kind = 0; kind < 5; ++kind) {
    for (const double creases : {0.0, 0.15}) {
      const bool semi_sharp = creases > 0 && GetParam() != Scheme::doo_sabin;
      const Mesh mesh = test::random_mesh_for(
          GetParam(), {.seed = 23, .kind = kind, .creases = creases, .semi_sharp = semi_sharp});
      check_all_kinds(mesh, GetParam(), 3, checked);
    }
  }
  EXPECT_GE(checked, 10 * 2 * 8);
}

TEST_P(RefinerOf, HasTheBitsOfRefineOnSpecialCases) {
  int checked = 0;
  for (const test::Sample& sample : test::polygon_samples()) {
    SCOPED_TRACE(sample.name);
    const Mesh mesh = GetParam() == Scheme::loop ? triangulate(sample.mesh).mesh : sample.mesh;
    check_all_kinds(mesh, GetParam(), 2, checked);
  }
  EXPECT_GT(checked, 40);
}

TEST_P(RefinerOf, HasTheBitsOfRefineOnRealMeshes) {
  std::vector<std::string> paths = test::committed_meshes();
  for (const char* folder : {"tri", "quad"}) {
    const auto real = test::real_meshes(folder);
    paths.insert(paths.end(), real.begin(), real.end());
  }
  int checked = 0;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto loaded = read_mesh(path);
    ASSERT_TRUE(loaded);
    const bool large = loaded->mesh.vertex_count() > 3000;
    const Mesh mesh = large ? loaded->mesh : with_extras(loaded->mesh);
    checked += check(mesh, {{GetParam()}, 1, false}) ? 1 : 0;
    if (large) continue;  // normals take their time
    checked += check(mesh, {{GetParam()}, 1, true}) ? 1 : 0;
  }
  EXPECT_GT(checked, 10);
}

INSTANTIATE_TEST_SUITE_P(Schemes, RefinerOf, testing::ValuesIn(all_schemes()),
                         [](const auto& scheme) {
                           std::string name = name_of(scheme.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Refiner, RefusesOtherSizes) {
  const auto refiner = Refiner::create(test::octahedron());
  ASSERT_TRUE(refiner);
  EXPECT_EQ(18U, refiner->mesh().points.size());
  const std::vector<Point> five(5);
  const auto wrong = refiner->refine(five);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(ErrorCode::mismatch, wrong.error().code);
  std::vector<double> room(17);
  const std::vector<double> values(6);
  EXPECT_EQ(ErrorCode::mismatch, refiner->refine(1, values, room).error().code);
  room.resize(18);
  EXPECT_TRUE(refiner->refine(1, values, room));
}

TEST(Refiner, RefusesWhatRefineRefuses) {
  EXPECT_EQ(ErrorCode::invalid_argument,
            Refiner::create(test::octahedron(), {.levels = -1}).error().code);
  EXPECT_EQ(ErrorCode::unsuitable_for_scheme, Refiner::create(test::cube()).error().code);
}

}  // namespace
}  // namespace surpass

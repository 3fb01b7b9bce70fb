// `surpass quality`, held against the library and closed forms.
#include <surpass/surpass.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

// A ring of n columns around a cylinder of radius 2, rows apart by 1/2: curvature 1/2 and 0.
std::string cylinder(unsigned n, unsigned rows) {
  std::string text =
      "OFF\n" + std::to_string(n * rows) + " " + std::to_string(n * (rows - 1)) + " 0\n";
  for (unsigned j = 0; j < rows; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      const double t = 2 * M_PI * i / n;
      text += std::to_string(2 * std::cos(t)) + " " + std::to_string(2 * std::sin(t)) + " " +
              std::to_string(0.5 * j) + "\n";
    }
  }
  for (unsigned j = 0; j + 1 < rows; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      const unsigned k = (i + 1) % n;
      text += "4 " + std::to_string(j * n + i) + " " + std::to_string(j * n + k) + " " +
              std::to_string((j + 1) * n + k) + " " + std::to_string((j + 1) * n + i) + "\n";
    }
  }
  return text;
}

TEST(Quality, OfACylinder) {
  const TempFolder folder;
  const std::string given = folder.file("given.off", cylinder(60, 9));
  const std::string control = folder / "control.ply";
  ASSERT_EQ(surpass({"interpolate", given, "-o", control}).status, 0);
  const json found = report_of({"quality", control, "--levels", "3"})["surfaces"][0];
  // Of 64 rows of patches, the outermost two are left out.
  const double area = 2 * M_PI * 2 * (4 - 2.0 / 16);
  EXPECT_NEAR(found["coverage"]["area"].get<double>(), 2 * M_PI * 2 * 4, 0.01);
  EXPECT_NEAR(found["coverage"]["measured_area"].get<double>(), area, 0.02);
  EXPECT_NEAR(found["bending"].get<double>(), area / 4, 0.03);
  EXPECT_NEAR(found["largest_curvature"].get<double>(), 0.5, 0.01);
  EXPECT_NEAR(found["total_gauss"].get<double>(), 0, 1e-3);
  const double relative = 0.5 * std::sqrt(area);
  EXPECT_NEAR(found["largest_curvature_relative"].get<double>(), relative, 0.02 * relative);
}

TEST(Quality, SaysWhatTheLibrarySays) {
  const std::string path = data("mixed_polygons.obj");
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::doo_sabin}) {
    const json found = report_of({"quality", path, "--scheme", name_of(scheme), "--levels", "4",
                                  "--rings", "3"})["surfaces"][0];
    const auto mesh = read_mesh(path);
    const auto expected = fairness(mesh->mesh, {scheme}, {.levels = 4, .rings = 3});
    ASSERT_TRUE(expected) << describe(expected.error());
    EXPECT_EQ(found["levels"], 4);
    EXPECT_EQ(found["bending"], expected->bending);
    EXPECT_EQ(found["thin_plate"], expected->thin_plate);
    EXPECT_EQ(found["thin_plate_relative"], expected->thin_plate_relative);
    EXPECT_EQ(found["curvature_variation"], expected->curvature_variation);
    EXPECT_EQ(found["total_variation"], expected->total_variation);
    EXPECT_EQ(found["high_curvature"], expected->high_curvature);
    EXPECT_EQ(found["coverage"]["left_out"], expected->coverage.left_out);
    EXPECT_EQ(found["coverage"]["measured_patches"], expected->coverage.measured_patches);
  }
}

// A refined control mesh has the same surface and, with a level less, the same patches.
TEST(Quality, PutsSurfacesOfDifferentLevelsSideBySide) {
  const TempFolder folder;
  const std::string coarse = folder / "coarse.obj";
  const std::string fine = folder / "fine.obj";
  ASSERT_EQ(surpass({"interpolate", data("quad_torus.obj"), "-o", coarse}).status, 0);
  ASSERT_EQ(surpass({"subdivide", coarse, "-o", fine, "--levels", "1"}).status, 0);
  const json report = report_of({"quality", coarse, fine, "--reference", fine, "--levels", "4"});
  const json& a = report["surfaces"][0];
  const json& b = report["surfaces"][1];
  EXPECT_EQ(a["levels"], 4);
  EXPECT_EQ(b["levels"], 3);
  EXPECT_EQ(a["coverage"]["patches"], b["coverage"]["patches"]);
  for (const char* key : {"bending", "thin_plate_relative", "total_variation", "high_curvature"}) {
    const double value = a[key];
    EXPECT_NEAR(b[key].get<double>(), value, 1e-8 * value) << key;
  }
  EXPECT_LT(a["normal_deviation"]["max"], 1e-6);
  const Outcome table = surpass({"quality", coarse, fine, "--reference", fine, "--levels", "4"});
  EXPECT_EQ(table.status, 0);
  for (const char* word : {"A  ", "B  ", "bending", "length^2", "degrees", "is left out"}) {
    EXPECT_NE(table.out.find(word), std::string::npos) << word << "\n" << table.out;
  }
  std::istringstream lines(table.out);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with("levels")) {
      EXPECT_EQ(line.size(), 24U + 12 + 2 * 14) << line;
    }
  }
}

// Both results and the given mesh itself, in any order: as many patches of each, and angles.
TEST(Quality, ADummyRingIsNoPartOfTheSurface) {
  const TempFolder folder;
  const std::string given = data("quad_patch.ply");
  const std::string ring = folder / "ring.ply";
  const std::string plain = folder / "plain.ply";
  for (const auto& [path, open] :
       {std::pair(ring, "dummy-ring"), std::pair(plain, "boundary-rules")}) {
    ASSERT_EQ(surpass({"interpolate", given, "-o", path, "--method", "similarity", "--scheme",
                       "catmull-clark", "--open", open})
                  .status,
              0);
  }
  const json report = report_of({"quality", ring, plain, given, "--scheme", "catmull-clark",
                                 "--reference", given, "--levels", "4"});
  const json& surfaces = report["surfaces"];
  EXPECT_EQ(surfaces[0]["levels"], 3);
  EXPECT_EQ(surfaces[1]["levels"], 3);
  EXPECT_EQ(surfaces[2]["levels"], 4);
  for (const json& surface : surfaces) {
    EXPECT_EQ(surface["coverage"]["patches"], surfaces[0]["coverage"]["patches"]);
    EXPECT_TRUE(surface.contains("normal_deviation"));
  }
  EXPECT_EQ(surfaces[2]["normal_deviation"]["max"], 0);
}

void expect_failure(std::vector<std::string> words, int status, const std::string& sentence) {
  words.insert(words.begin(), "quality");
  const Outcome outcome = surpass(words);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Quality, RefusesWhatCannotBeMeant) {
  const TempFolder folder;
  const std::string loop = folder / "loop.obj";
  const std::string quads = folder / "quads.obj";
  const std::string fine = folder / "fine.obj";
  ASSERT_EQ(surpass({"interpolate", data("octahedron.obj"), "-o", loop}).status, 0);
  ASSERT_EQ(surpass({"interpolate", data("quad_torus.obj"), "-o", quads}).status, 0);
  ASSERT_EQ(surpass({"subdivide", quads, "-o", fine, "--levels", "2"}).status, 0);
  expect_failure({}, 1, "MESH is required");
  expect_failure({quads, "--levels", "0"}, 1, "is not a number from 1 to 10");
  expect_failure({quads, "--rings", "-1"}, 1, "is not a number from 0 to 1000");
  expect_failure({quads, fine, "--levels", "2"}, 1, "take 3 or more");
  expect_failure({loop, quads}, 3, "--scheme");
  expect_failure({quads, "--scheme", "loop"}, 3, "triangulate");
  expect_failure({data("cube.obj"), "--levels", "1"}, 3, "nothing of the surface is left");
  expect_failure({quads, "--reference", data("cube.obj")}, 3, "other faces");
  expect_failure({quads, folder / "missing.obj"}, 2, "missing.obj");
  expect_failure({"-", "-"}, 1, "-");
}

}  // namespace
}  // namespace surpass::test

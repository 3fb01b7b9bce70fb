// Our readers beside CGAL's polygon soup reader, on the committed meshes and on any others given.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include "unit/io_support.hpp"

namespace surpass {
namespace {

namespace fs = std::filesystem;
using Soup = std::pair<std::vector<CGAL::Simple_cartesian<double>::Point_3>,
                       std::vector<std::vector<std::size_t>>>;

std::vector<std::string> meshes_below(const fs::path& folder) {
  std::vector<std::string> paths;
  if (!fs::exists(folder)) return paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const Format format = format_of_path(entry.path().string());
    const bool shared = format == Format::obj || format == Format::ply || format == Format::off;
    if (entry.is_regular_file() && shared) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Text PLY files of floats are rounded by CGAL and kept as written by us.
bool same_position(const Point& ours, const Soup::first_type::value_type& theirs) {
  const auto same = [](double a, double b) {
    return a == b || static_cast<float>(a) == static_cast<float>(b);
  };
  return same(ours[0], theirs.x()) && same(ours[1], theirs.y()) && same(ours[2], theirs.z());
}

// CGAL gives up at OpenSubdiv's `t` lines in OBJ, so it is handed positions and faces only.
bool read_with_cgal(const std::string& path, Soup& soup) {
  if (format_of_path(path) != Format::obj) {
    return CGAL::IO::read_polygon_soup(path, soup.first, soup.second);
  }
  std::ifstream file(path);
  std::stringstream lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("v ") || line.starts_with("f ")) lines << line << '\n';
  }
  return CGAL::IO::read_OBJ(lines, soup.first, soup.second);
}

enum class Outcome { compared, refused_by_cgal };

void compare(const Mesh& ours, const Soup& soup) {
  ASSERT_EQ(ours.points.size(), soup.first.size());
  for (std::size_t v = 0; v < soup.first.size(); ++v) {
    ASSERT_TRUE(same_position(ours.points[v], soup.first[v])) << "vertex " << v;
  }
  ASSERT_EQ(ours.face_count(), soup.second.size());
  for (Index f = 0; f < ours.face_count(); ++f) {
    const auto face = ours.face(f);
    ASSERT_TRUE(std::equal(face.begin(), face.end(), soup.second[f].begin(), soup.second[f].end()))
        << "face " << f;
  }
}

Outcome expect_same(const std::string& path) {
  SCOPED_TRACE(path);
  const auto ours = read_mesh(path);
  EXPECT_TRUE(ours) << (ours ? "" : describe(ours.error()));
  Soup soup;
  if (!read_with_cgal(path, soup)) return Outcome::refused_by_cgal;
  if (ours) compare(ours->mesh, soup);
  return Outcome::compared;
}

// A polygon mesh of our own, so that the test means something without any data.
TEST(BesideCgal, WrittenMeshes) {
  Mesh mesh;
  for (int k = 0; k < 20; ++k) mesh.points.push_back({k / 7.0, k * k / 3.0, -1.0 / (k + 1)});
  for (Index f = 0; f < 15; ++f) {
    mesh.add_face(std::array<Index, 5>{f, f + 1, f + 2, f + 3, f + 4});
    mesh.add_face(std::array<Index, 3>{f + 2, f + 1, f});
  }
  for (const char* name : {"a.obj", "a.ply", "a.off"}) {
    const std::string path = (fs::path(testing::TempDir()) / name).string();
    ASSERT_TRUE(write_mesh(mesh, path));
    EXPECT_EQ(expect_same(path), Outcome::compared);
    fs::remove(path);
  }
}

TEST(BesideCgal, CommittedMeshes) {
  for (const std::string& path : meshes_below(SURPASS_DATA_DIR)) {
    EXPECT_EQ(expect_same(path), Outcome::compared) << path;
  }
}

TEST(BesideCgal, GivenMeshes) {
  const char* folder = std::getenv("SURPASS_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of meshes";
  std::size_t compared = 0;
  std::vector<std::string> refused;  // CGAL wants the vertices of an OFF face on one line
  for (const char* kind : {"tri", "quad"}) {
    for (const std::string& path : meshes_below(fs::path(folder) / kind)) {
      if (expect_same(path) == Outcome::compared) {
        ++compared;
      } else {
        refused.push_back(path);
      }
    }
  }
  EXPECT_GT(compared, 20 * refused.size()) << testing::PrintToString(refused);
}

}  // namespace
}  // namespace surpass

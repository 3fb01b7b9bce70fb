// Exits 2 to 5 and 130: files that cannot be read or written, meshes that do not suit, tolerances
// out of reach, interruptions. A failed command leaves nothing behind.
#include <csignal>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "process.hpp"

namespace surpass::test {
namespace {

using Names = std::vector<std::string>;

TEST(Unreadable, AMissingFile) {
  const TempFolder folder;
  const Outcome outcome = surpass({"interpolate", folder / "none.obj", "-o", folder / "x.obj"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("none.obj"), std::string::npos);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(Unreadable, AnEmptyFile) {
  const TempFolder folder;
  for (const char* name : {"empty.obj", "empty.ply", "empty.off", "empty.stl"}) {
    const std::string path = folder.file(name, "");
    const Outcome outcome = surpass({"inspect", path});
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
  }
}

TEST(Unreadable, ASyntaxErrorNamesLineAndColumn) {
  const TempFolder folder;
  const std::string path = folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 one 0\nf 1 2 3\n");
  const Outcome outcome = surpass({"convert", path, folder / "x.off"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("bad.obj:3:5:"), std::string::npos) << outcome.err;
}

TEST(Unreadable, AListOfVerticesWithAWrongNumber) {
  const TempFolder folder;
  const auto run = [&](const std::string& list) {
    return surpass({"interpolate", data("octahedron.obj"), "-o", folder / "x.obj", "--only", list});
  };
  const Outcome beyond = run(folder.file("beyond.txt", "0 1 # two\n  2 6\n"));
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.err.find("beyond.txt:2:5: there is no vertex 6"), std::string::npos)
      << beyond.err;
  EXPECT_EQ(run(folder.file("word.txt", "0 one")).status, 2);
  EXPECT_EQ(run(folder.file("none.txt", "# nothing\n")).status, 2);
  EXPECT_EQ(run(folder / "missing.txt").status, 2);
}

TEST(Unsuitable, PolygonsForLoop) {
  const TempFolder folder;
  const Outcome outcome =
      surpass({"interpolate", data("cube.obj"), "-o", folder / "x.obj", "--scheme", "loop"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("--triangulate"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("face 0"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), Names{});
  EXPECT_EQ(
      surpass({"interpolate", data("cube.obj"), "-o", folder / "x.obj", "--triangulate"}).status,
      0);
}

TEST(Unsuitable, AnEdgeOfThreeFaces) {
  const TempFolder folder;
  const std::string fan = folder.file("fan.off",
                                      "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n"
                                      "3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  const Outcome refused = surpass({"interpolate", fan, "-o", folder / "x.off"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("edge 0-1"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--repair"), std::string::npos) << refused.err;
  const Outcome inspected = surpass({"inspect", fan});
  EXPECT_EQ(inspected.status, 3);
  EXPECT_NE(inspected.out.find("verdict             refused"), std::string::npos) << inspected.out;
  const Outcome mended = surpass({"interpolate", fan, "-o", folder / "x.off", "--repair"});
  EXPECT_EQ(mended.status, 0) << mended.err;
  EXPECT_NE(mended.err.find("note: "), std::string::npos) << "what was done is said";
}

TEST(Unsuitable, MeshesOfDifferentSize) {
  const Outcome outcome = surpass({"check", data("octahedron.obj"), "--against", data("tube.obj")});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("has 6 vertices"), std::string::npos) << outcome.err;
}

TEST(OutOfReach, NoMeshIsWrittenUnlessTheBestIsWanted) {
  const TempFolder folder;
  const Names few = {"interpolate",
                     data("sphere_irregular.obj"),
                     "-o",
                     folder / "x.obj",
                     "--max-iterations",
                     "3",
                     "--report",
                     folder / "r.json"};
  const Outcome outcome = surpass(few);
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("--keep-best"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), Names{"r.json"});

  Names keeping = few;
  keeping.push_back("--keep-best");
  EXPECT_EQ(surpass(keeping).status, 4);
  EXPECT_EQ(folder.names(), (Names{"r.json", "x.obj"}));
  const Names check = {"check", folder / "x.obj", "--against", data("sphere_irregular.obj")};
  EXPECT_EQ(surpass(check).status, 4);
}

TEST(Unwritable, AFolderThatDoesNotExist) {
  const TempFolder folder;
  const Outcome outcome = surpass({"convert", data("octahedron.obj"), folder / "none/there.off"});
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.err.find("folder does not exist"), std::string::npos) << outcome.err;
}

TEST(Unwritable, AFolderThatMayNotBeWritten) {
  const TempFolder folder;
  std::string locked = folder / "locked";
  ::mkdir(locked.c_str(), 0555);
  if (::access(locked.c_str(), W_OK) == 0) locked = "/proc";  // root may write anywhere but there
  const Outcome outcome = surpass({"interpolate", data("octahedron.obj"), "-o", locked + "/x.obj"});
  EXPECT_EQ(outcome.status, 5) << outcome.err;
  EXPECT_NE(outcome.err.find("x.obj"), std::string::npos) << outcome.err;
}

TEST(Unwritable, AFullDisk) {
  const TempFolder folder;
  const std::string given = data("sphere_irregular.obj");
  const Outcome full = surpass({"interpolate", given, "-o", "/dev/full", "--to", "obj"});
  EXPECT_EQ(full.status, 5) << full.err;
  EXPECT_NE(full.err.find("/dev/full"), std::string::npos) << full.err;
  struct stat status = {};
  ASSERT_EQ(::stat("/dev/full", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode)) << "the device was replaced by a file";

  const Outcome piped = surpass({"interpolate", given, "-o", "-"}, {.output_to = "/dev/full"});
  EXPECT_EQ(piped.status, 5) << piped.err;
  const Outcome table = surpass({"inspect", given}, {.output_to = "/dev/full"});
  EXPECT_EQ(table.status, 5) << table.err;

  const Outcome limited =
      surpass({"interpolate", given, "-o", folder / "x.obj"}, {.file_limit = 4096});
  EXPECT_EQ(limited.status, 5) << limited.err;
  EXPECT_EQ(folder.names(), Names{}) << "neither a part of the mesh nor a temporary file";
}

TEST(Unwritable, APipeThatNobodyReads) {
  const Outcome outcome =
      surpass({"convert", data("sphere_irregular.obj"), "-"}, {.closed_pipe = true});
  EXPECT_EQ(outcome.status, 5) << outcome.err;
}

/// Interrupts a solve that would take minutes, once it is seen to run.
void expect_interruption(int signal) {
  const TempFolder folder;
  const std::string given = folder.file("grid.off", grid_off(400));
  const Outcome outcome = surpass_interrupted(
      {"interpolate", given, "-o", folder / "x.ply", "--surface", folder / "s.ply", "--levels", "2",
       "--solver", "richardson", "--tolerance", "0", "--max-iterations", "1000000000", "--report",
       folder / "r.json"},
      "iteration", signal);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), Names{"grid.off"});
}

TEST(Interrupted, NothingIsLeftBehind) {
  expect_interruption(SIGINT);
  expect_interruption(SIGTERM);
}

}  // namespace
}  // namespace surpass::test

// surpass reconstruct, which is a program of its own behind the same command line.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "process.hpp"
#include "schema.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

/// Points of a torus, with a colour each.
std::string torus_xyz(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * M_PI * std::fmod(0.6180339887498949 * i, 1);
    const double v = 2 * M_PI * i / n;
    const double radius = 1 + 0.4 * std::cos(v);
    text += fmt::format("{} {} {} {} 7 200\n", radius * std::cos(u), radius * std::sin(u),
                        0.4 * std::sin(v), i % 256);
  }
  return text;
}

class ReconstructCommand : public testing::Test {
 protected:
  json report_of(std::vector<std::string> words, int status) {
    const std::string path = folder_ / "report.json";
    words.insert(words.end(), {"--report", path});
    outcome_ = surpass(words);
    EXPECT_EQ(outcome_.status, status) << outcome_.err;
    json report = json::parse(slurp(path));
    EXPECT_EQ(Schema(SURPASS_SCHEMA).complaint(report.dump()), "") << report.dump(1);
    return report;
  }
  TempFolder folder_;
  Outcome outcome_;
};

TEST_F(ReconstructCommand, FromPointsToEveryFile) {
  const std::string points = folder_.file("torus.xyz", torus_xyz(3000));
  const json report =
      report_of({"reconstruct", points, "-o", folder_ / "mesh.ply", "--vertices", "600",
                 "--control", folder_ / "control.obj", "--surface", folder_ / "surface.ply",
                 "--levels", "1", "--unused", folder_ / "unused.xyz"},
                0);
  EXPECT_EQ(report["reconstruction"]["genus"], 1);
  EXPECT_EQ(report["mesh"]["vertices"], 600);
  EXPECT_LE(report["interpolation"]["max"], 1e-12);
  EXPECT_EQ(report["distance"]["all"]["points"], 3000);
  EXPECT_EQ(report["outputs"].size(), 4U);
  EXPECT_NE(outcome_.err.find("genus 1"), std::string::npos) << outcome_.err;
  // Another command agrees that the control mesh's surface passes through the mesh's vertices.
  EXPECT_EQ(surpass({"check", folder_ / "control.obj", "--against", folder_ / "mesh.ply",
                     "--tolerance", "1e-12"})
                .status,
            0);
  EXPECT_NE(slurp(folder_ / "mesh.ply").find("property uchar red"), std::string::npos);
}

TEST_F(ReconstructCommand, FromTheStandardInputToTheStandardOutput) {
  const Outcome outcome = surpass({"reconstruct", "-", "--from", "xyz", "-o", "-", "--to", "off",
                                   "--scheme", "loop", "--quiet"},
                                  {.input = torus_xyz(800)});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("OFF"), std::string::npos);
}

TEST_F(ReconstructCommand, ExitCodesAreThoseOfSurpass) {
  EXPECT_EQ(surpass({"reconstruct", folder_ / "none.xyz", "-o", folder_ / "x.ply"}).status, 2);
  const std::string bad = folder_.file("bad.xyz", "0 0 0\n1 0\n");
  EXPECT_EQ(report_of({"reconstruct", bad, "-o", folder_ / "x.ply"}, 2)["failure"]["line"], 2);
  const std::string line = folder_.file("line.xyz", "0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n");
  report_of({"reconstruct", line, "-o", folder_ / "x.ply"}, 3);
  EXPECT_NE(outcome_.err.find("line"), std::string::npos) << outcome_.err;
  const std::string points = folder_.file("torus.xyz", torus_xyz(500));
  EXPECT_EQ(surpass({"reconstruct", points, "-o", folder_ / "none/x.ply"}).status, 5);
  EXPECT_EQ(surpass({"reconstruct", points, "-o", folder_ / "x.xyz"}).status, 1);
  const Outcome wrong = surpass({"reconstruct", points, "-o", "x.ply", "--tolerence", "1e-3"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("did you mean '--tolerance'? See surpass reconstruct --help"),
            std::string::npos)
      << wrong.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.ply"));
}

TEST_F(ReconstructCommand, WhatCannotBeIsRefusedBeforeTheWork) {
  const std::string points = folder_.file("torus.xyz", torus_xyz(500));
  const auto refused = [&](std::vector<std::string> words, const char* sentence) {
    words.insert(words.begin(), {"reconstruct", points});
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 1) << sentence;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"torus.xyz"});
  };
  const std::string mesh = folder_ / "mesh.ply";
  refused({"-o", mesh, "--unused", folder_ / "u.stl"}, "would be STL, which holds triangles only");
  refused({"-o", folder_ / "mesh.stl", "--unused", "-"}, "would be STL");
  refused({"-o", mesh, "--levels", "2"}, "--levels is for --surface");
  refused({"-o", mesh, "--vertices", "1e-3"}, "'1e-3' is not a whole number");
  refused({"-o", mesh, "--vertices", "3"}, "'3' is not a number from 4");
  refused({"-o", mesh, "--report", points}, "is an input");
  EXPECT_EQ(slurp(points), torus_xyz(500));
  const Outcome lost = surpass({"reconstruct", points, "-o", mesh, "--report", "/nonexist/r.json"});
  EXPECT_EQ(lost.status, 5);
  EXPECT_EQ(std::count(lost.err.begin(), lost.err.end(), '\n'), 1) << lost.err;
}

TEST_F(ReconstructCommand, CountsMayHaveExponents) {
  const std::string points = folder_.file("torus.xyz", torus_xyz(1000));
  const json report =
      report_of({"reconstruct", points, "-o", folder_ / "mesh.ply", "--vertices", "3e2"}, 0);
  EXPECT_EQ(report["mesh"]["vertices"], 300);
}

TEST_F(ReconstructCommand, ChannelsThatAreNotFiniteAreLeftOut) {
  std::string text;
  std::istringstream lines(torus_xyz(400));
  std::size_t n = 0;
  for (std::string line; std::getline(lines, line); ++n) {
    const bool bad = n == 7;
    text += line.substr(0, line.find(' ', line.find(' ', line.find(' ') + 1) + 1)) +
            (bad ? " nan nan nan\n" : " 0 0 1\n");
  }
  const std::string points = folder_.file("torus.xyz", text);
  report_of({"reconstruct", points, "-o", folder_ / "mesh.ply", "--unused", folder_ / "u.ply"}, 0);
  EXPECT_NE(outcome_.err.find("the channel 'normal' is left out: at 1 of 400 points"),
            std::string::npos)
      << outcome_.err;
  EXPECT_EQ(slurp(folder_ / "mesh.ply").find("nx"), std::string::npos);
  EXPECT_EQ(slurp(folder_ / "u.ply").find("nx"), std::string::npos);
}

TEST_F(ReconstructCommand, AFailedOutputTellsWhichFilesAreThere) {
  const std::string points = folder_.file("torus.xyz", torus_xyz(500));
  const std::string full = folder_ / "full.ply";
  std::filesystem::create_symlink("/dev/full", full);
  report_of({"reconstruct", points, "-o", folder_ / "mesh.ply", "--control", full}, 5);
  EXPECT_NE(outcome_.err.find("(already written: '" + (folder_ / "mesh.ply") + "')"),
            std::string::npos)
      << outcome_.err;
}

TEST_F(ReconstructCommand, AnInterruptionLeavesNothingBehind) {
  const std::string points = folder_.file("torus.xyz", torus_xyz(120000));
  for (const char* stage : {"delaunay", "front"}) {
    const Outcome outcome =
        surpass_interrupted({"reconstruct", points, "-o", folder_ / "mesh.ply"}, stage, SIGINT);
    EXPECT_EQ(outcome.status, 130) << stage;
    EXPECT_NE(outcome.err.find("nothing was written"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"torus.xyz"});
  }
}

TEST_F(ReconstructCommand, WhereItIsNotBuiltAMessageSaysSo) {
  const std::string alone = folder_ / "surpass";
  std::filesystem::copy_file(SURPASS_EXECUTABLE, alone);
  const std::string said = folder_ / "said";
  const int status =
      std::system(fmt::format("PATH= {} reconstruct a.xyz -o b.ply 2> {}", alone, said).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(slurp(said).find("libcgal-dev"), std::string::npos) << slurp(said);
}

}  // namespace
}  // namespace surpass::test

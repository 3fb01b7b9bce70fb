// Exit 1 and help: what a user sees who mistypes or asks.
#include <gtest/gtest.h>

#include "process.hpp"

namespace surpass::test {
namespace {

const std::vector<std::string> kCommands = {"interpolate", "predict", "subdivide", "check",
                                            "inspect",     "compare", "quality",   "convert",
                                            "render",      "view",
#ifdef SURPASS_RECONSTRUCT
                                            "reconstruct"
#endif
};

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& sentence) {
  const Outcome outcome = surpass(arguments);
  EXPECT_EQ(outcome.status, 1) << sentence;
  EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Usage, TheNearestCommandIsSuggested) {
  expect_usage_error({"interpolat", "a.obj"}, "did you mean 'interpolate'?");
  expect_usage_error({"chekc"}, "did you mean 'check'?");
  expect_usage_error({"subdivied"}, "did you mean 'subdivide'?");
  expect_usage_error({"qqqqqqqq"}, "there is no command 'qqqqqqqq'; see surpass --help");
  expect_usage_error({"--versoin"}, "did you mean '--version'?");
  expect_usage_error({}, "name a command");
}

TEST(Usage, TheNearestOptionIsSuggested) {
  const std::string given = data("octahedron.obj");
  expect_usage_error({"interpolate", given, "--outptu", "x.obj"}, "did you mean '--output'?");
  expect_usage_error({"interpolate", given, "-o", "x.obj", "--tolerence=1e-6"},
                     "did you mean '--tolerance'? See surpass interpolate --help");
  expect_usage_error({"subdivide", given, "-o", "x.obj", "--level", "1"},
                     "did you mean '--levels'?");
  expect_usage_error({"inspect", given, "--xyzzyx"}, "there is no option '--xyzzyx'; see");
  expect_usage_error({"inspect", given, "-o", "x.ply"}, "there is no option '-o'; see");
}

TEST(Usage, TheNearestValueIsSuggested) {
  const std::string given = data("octahedron.obj");
  expect_usage_error({"interpolate", given, "-o", "x.obj", "--solver", "chebychev"},
                     "did you mean 'chebyshev'?");
  expect_usage_error({"predict", given, "--boundary", "edge"}, "edge-and-corner, hoppe, interior");
  expect_usage_error({"convert", given, "-", "--to", "plx"}, "did you mean 'ply'?");
}

TEST(Usage, NumbersOutOfRangeAreRefused) {
  const std::string given = data("octahedron.obj");
  expect_usage_error({"subdivide", given, "-o", "x.obj", "--levels", "11"}, "0 to 10");
  expect_usage_error({"subdivide", given, "-o", "x.obj", "--levels", "-1"}, "0 to 10");
  expect_usage_error({"interpolate", given, "-o", "x.obj", "--tolerance", "-1e-9"}, "--tolerance");
  expect_usage_error({"interpolate", given, "-o", "x.obj", "--threads", "many"}, "--threads");
  expect_usage_error({"interpolate", given, "-o", "x.obj", "--max-iterations", "0"},
                     "--max-iterations");
}

TEST(Usage, OptionsOfAnotherMethodAreRefused) {
  const std::vector<std::string> start = {"interpolate", data("cube.obj"), "-o", "x.obj"};
  const auto expect = [&](std::vector<std::string> more, const std::string& sentence) {
    more.insert(more.begin(), start.begin(), start.end());
    expect_usage_error(more, sentence);
  };
  expect({"--similarity", "vectors"},
         "--similarity says nothing of the method progressive; it is for --method similarity\n");
  expect({"--samples", "5"}, "it is for --method similarity or fair");
  expect({"--membrane", "1"}, "it is for --method fair");
  expect({"--weights", "none"}, "--weights none says nothing of the method progressive");
  expect({"--weights", "cosine,averaging"}, "'averaging' is the second of its kind");
  expect({"--method", "fair", "--similarity", "vectors"}, "of the method fair");
  expect({"--method", "similarity", "--membrane", "1"}, "--membrane says nothing");
  expect({"--method", "similarity", "--weights", "unit"}, "is for --similarity directions");
  expect({"--method", "similarity", "--solver", "minres"}, "conjugate-gradient and gauss-seidel");
  expect({"--method", "fair", "--direct"}, "--direct is for --method progressive");
  expect({"--method", "fair", "--skip-component", "0"}, "--skip-component is for");
  expect({"--method", "fair", "--thin-plate", "0"}, "not both 0");
  expect({"--method", "similarity", "--samples", "4"}, "3, 5, 9 or 17");
  expect({"--method", "similar"}, "did you mean 'similarity'?");
}

TEST(Usage, RefinementsBeyondAnyMemoryAreRefusedFirst) {
  const TempFolder folder;
  const std::string grid = folder.file("grid.off", grid_off(20));  // 722 triangles
  expect_usage_error({"subdivide", grid, "-o", folder / "x.ply", "--levels", "10"},
                     "at most 9 levels are possible");
}

TEST(Usage, MissingArgumentsAreNamed) {
  expect_usage_error({"interpolate"}, "GIVEN is required");
  expect_usage_error({"interpolate", data("octahedron.obj")}, "--output is required");
  expect_usage_error({"check", data("octahedron.obj")}, "--against is required");
  expect_usage_error({"compare", data("octahedron.obj")}, "B is required");
}

TEST(Usage, OutputsThatCannotBeMeant) {
  const TempFolder folder;
  const std::string given = folder.file("given.obj", slurp(data("octahedron.obj")));
  expect_usage_error({"interpolate", given, "-o", given}, "add --force to replace it");
  expect_usage_error({"interpolate", given, "-o", folder / "./given.obj"}, "is an input");
  std::filesystem::create_symlink(given, folder / "link.obj");
  expect_usage_error({"interpolate", given, "-o", folder / "link.obj"}, "is an input");
  std::filesystem::create_symlink("a.obj", folder / "to_a.obj");  // which is not there yet
  for (const char* again : {"a.obj", "./a.obj", "../@/a.obj", "to_a.obj"}) {
    std::string path = folder / again;
    if (const auto at = path.find('@'); at != std::string::npos) {
      path.replace(at, 1, std::filesystem::path(folder / "").parent_path().filename());
    }
    for (const char* option : {"--surface", "--report"}) {
      expect_usage_error({"interpolate", given, "-o", folder / "a.obj", option, path},
                         "is the same file as");
    }
  }
  const auto with_reference = [&](const std::string& path) {
    return std::vector<std::string>{
        "interpolate",       given,        "-o",          folder / "a.obj",
        "--method",          "similarity", "--reference", folder / "link.obj",
        "--write-reference", path};
  };
  expect_usage_error(with_reference(folder / "a.obj"), "is the same file as");
  expect_usage_error(with_reference(given), "is an input");
  expect_usage_error(with_reference(folder / "link.obj"), "is an input");
  expect_usage_error(with_reference(folder / "r.png"), "does not name a format");
  expect_usage_error(
      {"interpolate", given, "-o", folder / "a.obj", "--write-reference", folder / "r.obj"},
      "it is for --method similarity or fair");
  const std::string list = folder.file("list.off", "0 1 2\n");
  expect_usage_error({"interpolate", given, "-o", list, "--only", list}, "is an input");
  expect_usage_error({"interpolate", given, "-o", folder / "a.xyz"}, "does not name a format");
  expect_usage_error({"check", "-", "--against", "-"}, "only one input can be '-'");
  // The report goes where it was asked to go, and tells of the failure.
  const Outcome both = surpass({"interpolate", given, "-o", "-", "--report", "-"});
  EXPECT_EQ(both.status, 1);
  EXPECT_NE(both.err.find("only one output can be '-'"), std::string::npos) << both.err;
  EXPECT_NE(both.out.find("\"failure\""), std::string::npos) << both.out;
  EXPECT_EQ(slurp(given), slurp(data("octahedron.obj")));
}

TEST(Usage, AReportTakesNoOutputsPlace) {
  const TempFolder folder;
  const std::string before = folder.file("before.obj", "made earlier");
  const std::string again = folder / "./before.obj";
  expect_usage_error({"interpolate", data("octahedron.obj"), "-o", before, "--report", again},
                     "is the same file as");
  EXPECT_EQ(slurp(before), "made earlier");
}

TEST(Usage, FormatsAreCheckedBeforeAnythingIsWritten) {
  const TempFolder folder;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--surface", folder / "s.stl"},
        std::vector<std::string>{"--write-reference", folder / "r.stl", "--method",
                                 "similarity"}}) {
    std::vector<std::string> words = {"interpolate", data("quad_torus.obj"), "-o",
                                      folder / "c.obj"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = surpass(words);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("STL holds triangles only"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("of the box side"), std::string::npos)
        << "solved before it was seen";
    EXPECT_TRUE(folder.names().empty());
  }
}

// --triangulate cuts what is read, and a control mesh of similarity has quadrilaterals all the
// same.
TEST(Usage, TrianglesAreAdvisedWhereTheyHelp) {
  const TempFolder folder;
  const std::string hint = "--triangulate cuts polygons";
  const Outcome converted = surpass({"convert", data("quad_torus.obj"), folder / "t.stl"});
  EXPECT_EQ(converted.status, 3);
  EXPECT_NE(converted.err.find(hint), std::string::npos) << converted.err;
  EXPECT_EQ(surpass({"convert", data("quad_torus.obj"), folder / "t.stl", "--triangulate"}).status,
            0);
  const Outcome plain = surpass({"interpolate", data("quad_torus.obj"), "-o", folder / "t.stl"});
  EXPECT_NE(plain.err.find(hint), std::string::npos) << plain.err;
  const Outcome refined =
      surpass({"subdivide", data("quad_torus.obj"), "-o", folder / "s.stl", "--levels", "1"});
  EXPECT_EQ(refined.status, 3);
  EXPECT_EQ(refined.err.find(hint), std::string::npos) << refined.err;
  const Outcome similar =
      surpass({"interpolate", data("quad_torus.obj"), "-o", folder / "s.stl", "--method",
               "similarity", "--triangulate", "--scheme", "catmull-clark"});
  EXPECT_EQ(similar.status, 3);
  EXPECT_EQ(similar.err.find(hint), std::string::npos) << similar.err;
}

TEST(Usage, ForceReplacesTheInput) {
  const TempFolder folder;
  const std::string given = folder.file("given.obj", slurp(data("octahedron.obj")));
  EXPECT_EQ(surpass({"interpolate", given, "-o", given, "--force"}).status, 0);
  EXPECT_NE(slurp(given), slurp(data("octahedron.obj")));
  EXPECT_EQ(surpass({"check", given, "--against", data("octahedron.obj")}).status, 0);
}

TEST(Usage, EveryCommandExplainsItself) {
  const Outcome overview = surpass({"--help"});
  EXPECT_EQ(overview.status, 0);
  EXPECT_EQ(overview.err, "");
  for (const std::string& command : kCommands) {
    EXPECT_NE(overview.out.find("  " + command), std::string::npos);
    const Outcome help = surpass({command, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    for (const char* part : {"Usage: surpass", "Examples:", "--threads", "--report", "--quiet"}) {
      EXPECT_NE(help.out.find(part), std::string::npos) << command << " " << part;
    }
    EXPECT_EQ(surpass({"help", command}).out, help.out);
  }
  for (const char* code : {"  0 ", "  1 ", "  2 ", "  3 ", "  4 ", "  5 ", "  130 "}) {
    EXPECT_NE(overview.out.find(code), std::string::npos);
  }
}

TEST(Usage, TheVersionNamesItsComponents) {
  const Outcome outcome = surpass({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.find("surpass "), 0U);
  for (const char* part : {"threads", "oracle", "render", "reconstruct"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos);
  }
}

// OpenSubdiv is in a program beside this one.
TEST(Usage, WithoutItsProgramTheOracleIsNotBuiltIn) {
  const TempFolder folder;
  const std::string alone = folder / "surpass";
  std::filesystem::copy_file(SURPASS_EXECUTABLE, alone);
  const std::string given = data("octahedron.obj");
  const std::string control = folder / "c.obj";
  ASSERT_EQ(surpass({"interpolate", given, "-o", control}).status, 0);
  const std::vector<std::string> check = {"check", control, "--against", given, "--oracle"};
  const Outcome refused = surpass(check, {.program = alone});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("no program surpass-oracle lies beside"), std::string::npos)
      << refused.err;
  EXPECT_NE(surpass({"--version"}, {.program = alone}).out.find("oracle       not built in"),
            std::string::npos);
  EXPECT_EQ(surpass({"check", control, "--against", given}, {.program = alone}).status, 0);
  EXPECT_EQ(surpass(check).status == 0, is_built_in("oracle"));
  EXPECT_EQ(surpass({"check", control, "--against", given, "--oracle=true"}).status == 0,
            is_built_in("oracle"));
  // This program itself under that name, and something that is no program.
  const std::string other = folder / "surpass-oracle";
  std::filesystem::create_symlink(alone, other);
  EXPECT_EQ(surpass(check, {.program = alone}).err, refused.err);
  std::filesystem::remove(other);
  std::filesystem::copy_file(SURPASS_EXECUTABLE, other);
  EXPECT_EQ(surpass(check, {.program = other}).err, refused.err);
  std::filesystem::remove(other);
  folder.file("surpass-oracle", "nothing");
  const Outcome broken = surpass(check, {.program = alone});
  EXPECT_EQ(broken.status, 1);
  EXPECT_NE(broken.err.find("surpass-oracle cannot be started"), std::string::npos) << broken.err;
}

}  // namespace
}  // namespace surpass::test

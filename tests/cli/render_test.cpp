// `surpass render`: styles, several pictures in one, scales.
#include <surpass/surpass.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#ifdef SURPASS_PNG
#include <png.h>
#endif

#include "process.hpp"

namespace surpass::test {
namespace {

using nlohmann::json;

class RenderCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_built_in("render")) GTEST_SKIP() << "this build makes no pictures";
  }

  json report_of(std::vector<std::string> words, int status = 0) {
    words.insert(words.end(), {"-o", folder_ / "x.png", "--report", folder_ / "x.json"});
    words.insert(words.begin(), "render");
    outcome_ = surpass(words);
    EXPECT_EQ(outcome_.status, status) << outcome_.err;
    if (status == 1) return {};
    return json::parse(slurp(folder_ / "x.json"));
  }

  TempFolder folder_;
  Outcome outcome_;
};

const std::string kTorus = SURPASS_DATA_DIR "/quad_torus.obj";
const std::string kOctahedron = SURPASS_DATA_DIR "/octahedron.obj";

TEST_F(RenderCommand, StylesOfSeveralMeshesMakeOnePicture) {
  const json found = report_of({kTorus, kOctahedron, "--style", "matte,wireframe,curvature",
                                "--size", "300x200", "--columns", "3", "--levels", "2"});
  EXPECT_EQ(found["picture"]["width"], 900);
  EXPECT_EQ(found["picture"]["height"], 400);
  const json& panels = found["picture"]["panels"];
  ASSERT_EQ(panels.size(), 6U);
  EXPECT_EQ(panels[1]["mesh"], kTorus);
  EXPECT_EQ(panels[1]["style"], "wireframe");
  EXPECT_FALSE(panels[1].contains("scale"));
  // One scale for both, with zero in its middle.
  EXPECT_EQ(panels[2]["scale"], panels[5]["scale"]);
  EXPECT_EQ(panels[2]["scale"][0].get<double>(), -panels[2]["scale"][1].get<double>());
  EXPECT_EQ(found["inputs"][0]["scheme"], "catmull-clark");
  EXPECT_EQ(found["inputs"][1]["scheme"], "loop");
}

TEST_F(RenderCommand, AFrameIsOneViewForSeveralPictures) {
  const auto bytes_of = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--size", "96x64"});
    report_of(words);
    return slurp(folder_ / "x.png");
  };
  const std::string framed = bytes_of({kOctahedron, "--frame", kTorus});
  EXPECT_NE(framed, bytes_of({kOctahedron}));
  EXPECT_EQ(framed, bytes_of({kOctahedron, "--frame", kTorus + "," + kTorus}));
  EXPECT_EQ(bytes_of({kTorus, "--frame", kTorus}), bytes_of({kTorus}));
  report_of({kTorus, "--frame", folder_ / "none.obj"}, 2);
}

TEST_F(RenderCommand, PixelsAreWholeNumbers) {
  for (const char* size : {"nanx100", "64.5x64", "infx64", "64", "64x64x64"}) {
    const Outcome outcome = surpass({"render", kTorus, "-o", folder_ / "x.png", "--size", size});
    EXPECT_EQ(outcome.status, 1) << size;
    EXPECT_NE(outcome.err.find("--size takes"), std::string::npos) << outcome.err;
  }
}

TEST_F(RenderCommand, TheScaleOfErrorsReachesTheLargest) {
  const auto given = read_mesh(kOctahedron);
  ASSERT_TRUE(given);
  const auto limit = limit_positions(given->mesh, {});
  double largest = 0;
  for (Index v = 0; v < given->mesh.vertex_count(); ++v) {
    const Point& a = given->mesh.points[v];
    const Point& b = (*limit)[v];
    largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  largest /= bounding_box(given->mesh.points).side();
  const json at_points =
      report_of({kOctahedron, "--style", "error", "--size", "64x48"})["picture"]["panels"][0];
  EXPECT_EQ(at_points["scale"][0], 0);
  EXPECT_GE(at_points["scale"][1].get<double>(), largest);
  EXPECT_LE(at_points["scale"][1].get<double>(), 1.6 * largest);
  // On the refined surface the same places are the furthest: an octahedron's corners.
  const json between = report_of({kOctahedron, "--style", "error", "--size", "64x48", "--levels",
                                  "3"})["picture"]["panels"][0];
  EXPECT_EQ(between["scale"], at_points["scale"]);
  const json itself = report_of({kOctahedron, "--style", "error", "--size", "64x48", "--against",
                                 kOctahedron})["picture"]["panels"][0];
  EXPECT_LE(itself["scale"][1].get<double>(), 1e-12);
  const json asked = report_of({kOctahedron, "--style", "gaussian", "--size", "64x48", "--range",
                                "-0.5,7"})["picture"]["panels"][0];
  EXPECT_EQ(asked["scale"], json({-0.5, 7.0}));
}

#ifdef SURPASS_PNG
// The part of a row of a panel that is drawn, from the left to the first background: what is
// behind everything does not change along a row.
std::pair<unsigned, unsigned> first_drawn(const std::string& png, unsigned panel_width,
                                          unsigned panel, unsigned y) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
  const unsigned char* row = &pixels[std::size_t{3} * y * image.width];
  const auto is_drawn = [&](unsigned x) {
    const unsigned char* here = row + std::size_t{3} * (panel * panel_width + x);
    return !std::equal(here, here + 3, row);
  };
  unsigned first = 0;
  while (first < panel_width && !is_drawn(first)) ++first;
  unsigned last = first;
  while (last < panel_width && is_drawn(last)) ++last;
  return {first, last};
}

TEST_F(RenderCommand, PanelsWithAndWithoutAScaleShowTheSameEquallyLarge) {
  const std::vector<std::string> words = {kOctahedron, "--size", "260x240", "--levels", "3"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    report_of(all);
    return slurp(folder_ / "x.png");
  };
  const std::string alone = with({"--style", "matte"});
  const std::string sheet = with({"--style", "matte,curvature,error,reflection"});
  const auto first = first_drawn(sheet, 260, 0, 120);
  EXPECT_NE(first, first_drawn(alone, 260, 0, 120));
  for (unsigned panel = 1; panel < 4; ++panel) {
    EXPECT_EQ(first_drawn(sheet, 260, panel, 120), first) << panel;
  }
  report_of({kOctahedron, "--beside", kOctahedron, "--style", "error", "--against", kOctahedron,
             "--size", "260x240"});
  const std::string beside = slurp(folder_ / "x.png");
  EXPECT_EQ(first_drawn(beside, 260, 0, 120), first_drawn(beside, 260, 1, 120));
}
#endif

TEST_F(RenderCommand, PointsAreDrawnAndStandBesideMeshes) {
  const std::string points = folder_.file("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
  EXPECT_EQ(report_of({points, "--size", "64x48"})["inputs"][0]["faces"], 0);
  const json found = report_of({kTorus, "--beside", points + "," + kOctahedron, "--size", "64x48"});
  EXPECT_EQ(found["picture"]["width"], 3 * 64);
}

TEST_F(RenderCommand, TheSameBytesForAnyNumberOfThreads) {
  std::vector<std::string> pictures;
  for (const char* threads : {"1", "2", "7"}) {
    report_of({kTorus, "--style", "reflection,curvature,gaussian,error", "--size", "250x170",
               "--columns", "2", "--levels", "2", "--threads", threads});
    pictures.push_back(slurp(folder_ / "x.png"));
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

TEST_F(RenderCommand, RefusesWhatCannotBeMeant) {
  report_of({kTorus, "--style", "mate"}, 1);
  EXPECT_NE(outcome_.err.find("did you mean 'matte'?"), std::string::npos) << outcome_.err;
  report_of({kTorus, "--against", kTorus}, 1);
  report_of({kTorus, "--range", "0,1"}, 1);
  report_of({kTorus, "--style", "curvature", "--range", "1"}, 1);
  report_of({kTorus, "--camera", "1,2,3,4"}, 1);
  report_of({kTorus, "--camera", "1,2,0"}, 1);
  report_of({kTorus, "--size=-5x10"}, 1);
  EXPECT_NE(outcome_.err.find("-5 x 10"), std::string::npos) << outcome_.err;
  report_of({kTorus, "--reflection-lines"}, 1);
  const std::string points = folder_.file("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  report_of({points, "--style", "curvature"}, 3);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.png"));
}

}  // namespace
}  // namespace surpass::test

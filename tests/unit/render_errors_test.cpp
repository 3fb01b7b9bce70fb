#include <limits>

#include "render_samples.hpp"

namespace surpass {
namespace {

using samples::square;

Error refusal(const Mesh& mesh, const RenderOptions& options = {}) {
  const Result<Image> image = render(mesh, options);
  EXPECT_FALSE(image);
  return image ? Error{ErrorCode::cannot_write, "nothing was refused"} : image.error();
}

TEST(RenderErrors, SizesOutOfRange) {
  for (const auto& [width, height] : {std::pair(0, 100), std::pair(100, 0), std::pair(-1, 100),
                                      std::pair(16385, 100), std::pair(100, 16385)}) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    const Error error = refusal(square(false), options);
    EXPECT_EQ(error.code, ErrorCode::invalid_argument);
    EXPECT_NE(error.message.find("16384"), std::string::npos);
  }
  EXPECT_EQ(samples::draw(square(false), samples::from_front(1, 1)).pixels.size(), 3U);
  EXPECT_EQ(samples::draw(square(false), samples::from_front(16384, 1)).width, 16384);
}

TEST(RenderErrors, OptionsThatCannotBeMeant) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](auto&& change) {
    RenderOptions options;
    change(options);
    return refusal(square(false), options).code == ErrorCode::invalid_argument;
  };
  EXPECT_TRUE(refuses([](RenderOptions& o) { o.samples = 0; }));
  EXPECT_TRUE(refuses([](RenderOptions& o) { o.samples = 1025; }));
  EXPECT_TRUE(refuses([](RenderOptions& o) { o.up = 'u'; }));
  EXPECT_TRUE(refuses([&](RenderOptions& o) { o.azimuth = nan; }));
  EXPECT_TRUE(refuses([&](RenderOptions& o) { o.elevation = nan; }));
  EXPECT_TRUE(refuses([&](RenderOptions& o) { o.crease_angle = nan; }));
  EXPECT_TRUE(refuses([](RenderOptions& o) { o.point_radius = -1; }));
  EXPECT_TRUE(refuses([&](RenderOptions& o) { o.points = {{0, nan, 0}}; }));
  EXPECT_TRUE(refuses([&](RenderOptions& o) { o.frame = {{0, 0, 1 / 0.0}}; }));
}

TEST(RenderErrors, MeshesThatCannotBeDrawn) {
  EXPECT_EQ(refusal({}).code, ErrorCode::empty_mesh);
  Mesh hole = square(false);
  hole.hole_faces = {0};
  EXPECT_EQ(refusal(hole).code, ErrorCode::empty_mesh);

  Mesh broken = square(true);
  broken.points[2][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(broken).code, ErrorCode::not_finite);
  EXPECT_EQ(refusal(broken).place.vertex, Index{2});

  broken = square(true);
  broken.face_vertices[4] = 9;
  EXPECT_EQ(refusal(broken).code, ErrorCode::index_out_of_range);
  EXPECT_EQ(refusal(broken).place.face, Index{1});

  broken = square(true);
  broken.add_face(std::array<Index, 2>{0, 1});
  EXPECT_EQ(refusal(broken).code, ErrorCode::degenerate_face);
}

TEST(RenderErrors, DegenerateShapesAreDrawnOrEmptyButDoNotFail) {
  Mesh mesh = square(true);
  for (Point& p : mesh.points) p = {1, 2, 3};
  EXPECT_EQ(samples::count_drawn(samples::draw(mesh, samples::from_front(40, 30))), 0);
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(samples::draw(mesh, samples::from_front(40, 30)).pixels.size(), 3600U);
}

TEST(RenderErrors, CancelledByTheCaller) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const Result<Image> image = render(square(false), {}, context);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace surpass

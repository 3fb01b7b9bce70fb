// Numbers as colours: what a pixel shows is the number at the place that it sees.
#include <surpass/fairness.hpp>

#include <algorithm>

#include "render/colour_map.hpp"
#include "render/legend.hpp"
#include "render/lettering.hpp"
#include "render/srgb.hpp"
#include "render_samples.hpp"

namespace surpass {
namespace {

using samples::draw;
using samples::from_front;
using samples::pixel;
using samples::sphere;
using Rgb = std::array<int, 3>;

// From the definition of sRGB, IEC 61966-2-1.
double linear(int byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double byte(double x) {
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

RenderOptions with_field(RenderOptions options, std::vector<double> values, double low,
                         double high) {
  options.shading = Shading::field;
  options.field = {
      .values = std::move(values), .low = low, .high = high, .diverging = true, .legend = false};
  return options;
}

// The colour that the scale has for a value.
Rgb colour(const ColourField& field, double value) {
  const picture::SrgbTable to_srgb;
  const picture::Colour c = picture::colour_of(value, field);
  return {to_srgb(c[0]), to_srgb(c[1]), to_srgb(c[2])};
}

TEST(RenderField, ASpheresCurvatureHasOneColourAndThatOfItsRadius) {
  for (const double radius : {0.5, 2.0, 8.0}) {
    Mesh mesh = sphere(96, 48, radius);
    Channel normals{"normal", {"x", "y", "z"}, {}};
    for (const Point& p : mesh.points) {
      for (const double x : p) normals.values.push_back(x / radius);
    }
    mesh.channels = {normals};
    const auto curvatures = vertex_curvatures(mesh);
    ASSERT_TRUE(curvatures);
    std::vector<double> mean;
    for (const VertexCurvature& k : *curvatures) mean.push_back(k.mean);
    const RenderOptions options = with_field(from_front(300, 300), mean, -3, 3);
    const Image image = draw(mesh, options);
    // In the middle the surface faces the viewer, and the colour is the scale's own.
    const Rgb expected = colour(*options.field, 1 / radius);
    const Rgb seen = pixel(image, 150, 150);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], expected[k], 1) << radius;
    // Elsewhere it is darker, by the same factor in each of the lights.
    for (const auto& [x, y] : {std::pair(90, 150), std::pair(150, 220), std::pair(80, 90)}) {
      const Rgb here = pixel(image, x, y);
      const double shade = linear(here[1]) / linear(expected[1]);
      EXPECT_GT(shade, 0.6);
      EXPECT_LT(shade, 1);
      for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
        EXPECT_NEAR(here[k], byte(shade * linear(expected[k])), 2) << k;
      }
    }
  }
}

TEST(RenderField, NumbersAreLinearInsideTriangles) {
  const Mesh mesh = samples::square(true);  // x from -1 to 1 from left to right
  const RenderOptions options = with_field(from_front(400, 400), {-1, 1, 1, -1}, -1.5, 2);
  const Image image = draw(mesh, options);
  int left = 200;
  int right = 200;
  while (samples::is_drawn(image, left - 1, 200)) --left;
  while (samples::is_drawn(image, right, 200)) ++right;
  for (const double share : {0.05, 0.3, 0.5, 0.8, 0.97}) {
    const int x = left + static_cast<int>(share * (right - left));
    const double place = (x + 0.5 - left) / (right - left) * 2 - 1;
    const Rgb seen = pixel(image, x, 200);
    // The view is in perspective, but straight at a plane; what it shades is a few in a hundred.
    const picture::Colour expected = picture::colour_of(place, *options.field);
    const double shade = linear(seen[1]) / static_cast<double>(expected[1]);
    EXPECT_GT(shade, 0.97);
    EXPECT_LT(shade, 1.01);
    for (int k : {0, 2}) {
      EXPECT_NEAR(linear(seen[static_cast<std::size_t>(k)]),
                  shade * static_cast<double>(expected[k]), 0.012);
    }
  }
}

TEST(RenderField, ASymmetricFieldGivesASymmetricPicture) {
  const Mesh mesh = sphere(48, 24);
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(p[0] * p[0] + p[1]);
  RenderOptions options = with_field(from_front(201, 201), values, -1, 1);
  options.samples = 1;
  const Image image = draw(mesh, options);
  int drawn = 0;
  for (int y = 0; y < 201; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Rgb a = pixel(image, x, y);
      const Rgb b = pixel(image, 200 - x, y);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 3) << x << ", " << y;
      drawn += samples::is_drawn(image, x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(drawn, 8000);
}

TEST(RenderField, TheScaleReadsAsTheSurfaceDoes) {
  RenderOptions options = with_field(from_front(640, 480), {2, 2, 2, 2}, -1, 4);
  options.field->legend = true;
  options.field->title = "mean curvature";
  const Image image = draw(samples::square(true), options);
  EXPECT_EQ(image.width, 640);
  EXPECT_EQ(image.height, 480);
  const int strip = picture::legend_width(options);
  ASSERT_GT(strip, 60);
  const Rgb middle = pixel(image, (640 - strip) / 2, 240);
  // Up the bar: three fifths of the way from its foot to its head.
  const int x = 640 - strip + 16;
  int foot = 479;
  while (pixel(image, x, foot) == pixel(image, 0, foot)) --foot;
  int head = 66;  // below the title
  while (pixel(image, x, head) == pixel(image, 0, head)) ++head;
  const Rgb there = pixel(image, x, static_cast<int>(foot - 0.6 * (foot - head)));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(middle[k], there[k], 4);
}

// Columns between which something is drawn in a row, left of the strip.
std::pair<int, int> extent(const Image& image, int y, int strip) {
  int first = image.width;
  int last = -1;
  for (int x = 0; x < image.width - strip; ++x) {
    if (!samples::is_drawn(image, x, y)) continue;
    first = std::min(first, x);
    last = x;
  }
  return {first, last};
}

TEST(RenderField, PicturesWithTheSameStripShowTheSameEquallyLarge) {
  const Mesh ball = sphere(24, 12);
  RenderOptions scaled =
      with_field(from_front(300, 280), std::vector(ball.points.size(), 2.0), -1, 4);
  scaled.field->legend = true;
  scaled.field->title = "mean curvature";
  const int needed = scale_width(scaled);
  ASSERT_GT(needed, 60);
  RenderOptions plain = from_front(300, 280);
  EXPECT_EQ(scale_width(plain), 0);
  const auto before = extent(draw(ball, plain), 140, 0);
  EXPECT_NE(before, extent(draw(ball, scaled), 140, needed));
  for (const int strip : {needed, needed + 25}) {
    scaled.strip = plain.strip = strip;
    const Image with = draw(ball, scaled);
    for (const Shading shading : {Shading::matte, Shading::wireframe, Shading::reflection}) {
      plain.shading = shading;
      const Image without = draw(ball, plain);
      EXPECT_EQ(without.width, 300);
      for (const int y : {60, 140, 220}) {
        EXPECT_EQ(extent(with, y, strip), extent(without, y, strip));
        EXPECT_LT(extent(without, y, 0).second, 300 - strip);
      }
    }
  }
  for (const int wrong : {-1, 300}) {
    plain.strip = wrong;
    EXPECT_EQ(render(ball, plain).error().code, ErrorCode::invalid_argument);
  }
}

TEST(RenderField, MarkedPointsDoNotChangeAGivenFrame) {
  const Mesh ball = sphere(24, 12);
  RenderOptions options = from_front(300, 280);
  options.frame = ball.points;
  const auto without = extent(draw(ball, options), 140, 0);
  options.points = {{0, 0, 0}};  // hidden inside
  EXPECT_EQ(extent(draw(ball, options), 140, 0), without);
}

TEST(RenderField, WhatIsNoNumberIsGreyAndWhatIsBeyondHasTheEndsColours) {
  ColourField field{.values = {}, .low = -1, .high = 1, .diverging = true};
  EXPECT_EQ(colour(field, -7), colour(field, -1));
  EXPECT_EQ(colour(field, 1e300), colour(field, 1));
  const Rgb grey = colour(field, std::nan(""));
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  const Rgb low = colour(field, -1);
  const Rgb high = colour(field, 1);
  EXPECT_GT(low[2], low[0] + 80);    // blue
  EXPECT_GT(high[0], high[2] + 80);  // red
  const Rgb zero = colour(field, 0);
  EXPECT_GT(*std::min_element(zero.begin(), zero.end()), 230);
  field.diverging = false;
  int before = 766;
  for (double x = -1; x <= 1; x += 0.125) {  // darker without an exception
    const Rgb c = colour(field, x);
    EXPECT_LT(c[0] + c[1] + c[2], before);
    before = c[0] + c[1] + c[2];
  }
}

TEST(RenderField, SameBitsForAnyNumberOfThreads) {
  const Mesh mesh = sphere(40, 20);
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(std::sin(7 * p[0]) * p[2]);
  RenderOptions options = with_field({}, values, -0.7, 0.7);
  options.width = 333;
  options.height = 257;
  options.edges = true;
  options.field->legend = true;
  options.field->title = "sine";
  const Image one = draw(mesh, options, 1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(draw(mesh, options, threads).pixels, one.pixels);
}

TEST(RenderField, RefusesFieldsThatDoNotFit) {
  const Mesh mesh = samples::square(true);
  const auto code = [&](const RenderOptions& options) {
    return render(mesh, options).error().code;
  };
  EXPECT_EQ(code(with_field(from_front(9, 9), {1, 2, 3}, 0, 1)), ErrorCode::mismatch);
  EXPECT_EQ(code(with_field(from_front(9, 9), {1, 2, 3, 4}, 1, 1)), ErrorCode::invalid_argument);
  EXPECT_EQ(code(with_field(from_front(9, 9), {1, 2, 3, 4}, 0, std::nan(""))),
            ErrorCode::invalid_argument);
  RenderOptions none = from_front(9, 9);
  none.shading = Shading::field;
  EXPECT_EQ(code(none), ErrorCode::mismatch);
}

TEST(RenderLettering, TextStaysInItsPlaceAndLettersDiffer) {
  const auto written = [](std::string_view text) {
    Image image{200, 30, std::vector<std::uint8_t>(std::size_t{3} * 200 * 30, 255)};
    picture::write_text(image, text, 10, 22, 12);
    return image;
  };
  const std::string_view known = "0123456789-+./abcdefghijklmnopqrstuvwxyz";
  std::vector<std::vector<std::uint8_t>> seen;
  for (const char& c : known) {
    const Image image = written({&c, 1});
    const float width = picture::text_width({&c, 1}, 12);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (samples::brightness(image, x, y) == 765) continue;
        EXPECT_GE(x, 8) << c;
        EXPECT_LE(x, 12 + width) << c;
        EXPECT_GE(y, 8) << c;
        EXPECT_LE(y, 28) << c;
      }
    }
    for (const auto& other : seen) EXPECT_NE(other, image.pixels) << c;
    seen.push_back(image.pixels);
  }
  EXPECT_NEAR(picture::text_width("0101", 12), 2 * picture::text_width("01", 12) + 3.4F, 1e-4);
}

}  // namespace
}  // namespace surpass

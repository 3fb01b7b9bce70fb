#include <cstdlib>

#include <png.h>

#include "render_samples.hpp"

namespace surpass {
namespace {

Image chequers(int width, int height, int seed) {
  Image image{width, height, {}};
  for (int k = 0; k < 3 * width * height; ++k) {
    image.pixels.push_back(static_cast<std::uint8_t>((k * 97 + seed * 31 + k / 7) % 256));
  }
  return image;
}

TEST(RenderImage, PngHoldsTheSamePixels) {
  const Image image = chequers(37, 23, 1);
  const Result<std::string> bytes = encode_png(image);
  ASSERT_TRUE(bytes);
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes->data(), bytes->size()), 0);
  EXPECT_EQ(png.width, 37U);
  EXPECT_EQ(png.height, 23U);
  EXPECT_EQ(png.format, PNG_FORMAT_RGB);
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, image.pixels);
}

TEST(RenderImage, BesideKeepsEveryRow) {
  const Image left = chequers(5, 4, 1);
  const Image right = chequers(3, 4, 2);
  const Result<Image> joined = beside({left, right});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->width, 8);
  EXPECT_EQ(joined->height, 4);
  ASSERT_EQ(joined->pixels.size(), 3U * 8 * 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(samples::pixel(*joined, x, y),
                x < 5 ? samples::pixel(left, x, y) : samples::pixel(right, x - 5, y));
    }
  }
}

TEST(RenderImage, RefusesWhatDoesNotFit) {
  const auto code = [](const auto& result) { return result.error().code; };
  EXPECT_EQ(code(beside({})), ErrorCode::invalid_argument);
  EXPECT_EQ(code(beside({chequers(2, 3, 0), chequers(2, 4, 0)})), ErrorCode::invalid_argument);
  Image short_of_a_byte = chequers(4, 4, 0);
  short_of_a_byte.pixels.pop_back();
  EXPECT_EQ(code(encode_png(short_of_a_byte)), ErrorCode::invalid_argument);
  EXPECT_EQ(code(beside({short_of_a_byte})), ErrorCode::invalid_argument);
  EXPECT_EQ(code(encode_png({})), ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace surpass

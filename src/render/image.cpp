// Pictures beside each other, and as PNG files by libpng.
#include <surpass/render.hpp>

#include <algorithm>
#include <csetjmp>

#include <fmt/format.h>
#include <png.h>

#include "render/backdrop.hpp"
#include "render/srgb.hpp"

namespace surpass {

namespace picture {

Image blank(int width, int height) {
  const SrgbTable to_srgb;
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const Colour colour = backdrop(y, height);
    for (int x = 0; x < width; ++x) {
      for (int k = 0; k < 3; ++k) image.pixels.push_back(to_srgb(colour[k]));
    }
  }
  return image;
}

}  // namespace picture

namespace {

Result<void> check_image(const Image& image) {
  const auto bytes = std::size_t{3} * static_cast<std::size_t>(std::max(0, image.width)) *
                     static_cast<std::size_t>(std::max(0, image.height));
  if (bytes == 0 || image.pixels.size() != bytes) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a picture of {} x {} pixels needs 3 bytes each, it has {}",
                            image.width, image.height, image.pixels.size()));
  }
  return {};
}

// On smooth shades one filter and little search give files as small as libpng's defaults do, in a
// third of the time.
constexpr int kFilter = PNG_FILTER_SUB;
constexpr int kCompression = 4;

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// Without these two libpng prints.
[[noreturn]] void stop(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignore(png_structp, png_const_charp) {}

// False if libpng failed. It leaves by longjmp, so nothing here may need a destructor.
bool write_png(png_structp png, png_infop info, const Image& image) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width);
  const auto height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_filter(png, PNG_FILTER_TYPE_DEFAULT, kFilter);
  png_set_compression_level(png, kCompression);
  png_write_info(png, info);
  const std::size_t row = std::size_t{3} * width;
  for (std::size_t y = 0; y < height; ++y) png_write_row(png, &image.pixels[y * row]);
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<Image> beside(const std::vector<Image>& images) {
  if (images.empty()) return fail(ErrorCode::invalid_argument, "there are no pictures to join");
  Image joined;
  joined.height = images.front().height;
  for (const Image& image : images) {
    if (auto checked = check_image(image); !checked) return tl::make_unexpected(checked.error());
    if (image.height != joined.height) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("pictures beside each other must be of equal height, not {} and {}",
                              joined.height, image.height));
    }
    joined.width += image.width;
  }
  for (int y = 0; y < joined.height; ++y) {
    for (const Image& image : images) {
      const auto row = std::ptrdiff_t{3} * image.width;
      const auto begin = image.pixels.begin() + y * row;
      joined.pixels.insert(joined.pixels.end(), begin, begin + row);
    }
  }
  return joined;
}

Result<Image> in_rows(const std::vector<Image>& images, std::size_t columns) {
  if (images.empty() || columns == 0) {
    return fail(ErrorCode::invalid_argument, "there are no pictures to join");
  }
  for (const Image& image : images) {
    if (auto checked = check_image(image); !checked) return tl::make_unexpected(checked.error());
    if (image.width != images.front().width || image.height != images.front().height) {
      return fail(ErrorCode::invalid_argument, "pictures in rows must all be of one size");
    }
  }
  Image joined;
  for (std::size_t first = 0; first < images.size(); first += columns) {
    const std::size_t count = std::min(columns, images.size() - first);
    const auto begin = images.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<Image> row(begin, begin + static_cast<std::ptrdiff_t>(count));
    const bool short_row = images.size() > columns && count < columns;
    if (short_row) row.resize(columns, picture::blank(images.front().width, images.front().height));
    Result<Image> wide = beside(row);
    if (!wide) return wide;
    joined.width = wide->width;
    joined.height += wide->height;
    joined.pixels.insert(joined.pixels.end(), wide->pixels.begin(), wide->pixels.end());
  }
  return joined;
}

Result<std::string> encode_png(const Image& image) {
  if (auto checked = check_image(image); !checked) return tl::make_unexpected(checked.error());
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, stop, ignore);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  bool written = false;
  if (info != nullptr) {
    png_set_write_fn(png, &bytes, append, nullptr);
    written = write_png(png, info, image);
  }
  png_destroy_write_struct(&png, &info);
  if (!written) return fail(ErrorCode::cannot_write, "libpng could not make a file of the picture");
  return bytes;
}

}  // namespace surpass

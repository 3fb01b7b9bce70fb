// Pictures beside each other, and as PNG files by libpng's simplified interface.
#include <surpass/render.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <png.h>

namespace surpass {
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

Result<std::string> encode_png(const Image& image) {
  if (auto checked = check_image(image); !checked) return tl::make_unexpected(checked.error());
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  const int written =
      png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr);
  if (written == 0) {
    return fail(ErrorCode::cannot_write, fmt::format("libpng failed: {}", png.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace surpass

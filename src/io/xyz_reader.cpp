// XYZ: a line a point, numbers with blanks between. The format has no head; what stands behind the
// position is told by the number of columns. A first line of one number is taken for the count of
// points, as in .pts and some .pwn files.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "io/readers.hpp"

namespace surpass::io {
namespace {

constexpr std::size_t kMostColumns = 64;

class XyzReader {
 public:
  XyzReader(Scanner& scan, LoadedMesh& out) : scan_(scan), mesh_(out.mesh) {}

  bool read() {
    for (scan_.skip_space(); !scan_.done(); scan_.skip_space()) {
      if (!read_line()) return false;
    }
    if (announced_ && *announced_ != mesh_.points.size()) {
      return scan_.fail(ErrorCode::unexpected_end,
                        fmt::format("{} points are announced in the first line, but {} follow",
                                    *announced_, mesh_.points.size()));
    }
    if (width_ > 3) add_channels();
    return true;
  }

 private:
  bool read_line();
  bool keep(const char* start);
  void add_channels();
  void add_channel(const char* name, std::vector<std::string> parts, std::size_t first,
                   Storage storage = Storage::float64);
  [[nodiscard]] bool are_colours(std::size_t first) const;

  Scanner& scan_;
  Mesh& mesh_;
  std::vector<double> row_;
  std::size_t width_ = 0;      // columns of a point, once one was read
  std::vector<double> extra_;  // what follows the positions, width_ - 3 a point
  std::optional<std::size_t> announced_;
};

bool XyzReader::read_line() {
  const char* start = scan_.at();
  row_.clear();
  while (!scan_.at_line_end()) {
    constexpr const char* kFurther = "a number";
    const char* what = row_.size() < 3 ? kCoordinates[row_.size()] : kFurther;
    if (!scan_.number(row_.emplace_back(), what)) return false;
    if (row_.size() > kMostColumns) {
      return scan_.fail(ErrorCode::unsupported, "a line has more than 64 numbers", start);
    }
  }
  if (width_ == 0 && !announced_ && row_.size() == 1 && row_[0] >= 0 &&
      row_[0] == std::floor(row_[0]) && row_[0] < kNone) {
    announced_ = static_cast<std::size_t>(row_[0]);
    return true;
  }
  return keep(start);
}

bool XyzReader::keep(const char* start) {
  if (row_.size() < 3) {
    return scan_.fail(ErrorCode::syntax,
                      fmt::format("a point has three coordinates, but this line has {} number{}",
                                  row_.size(), row_.size() == 1 ? "" : "s"),
                      start);
  }
  if (width_ == 0) width_ = row_.size();
  if (row_.size() != width_) {
    return scan_.fail(
        ErrorCode::syntax,
        fmt::format("this line has {} numbers where the lines before have {}", row_.size(), width_),
        start);
  }
  if (mesh_.points.size() == kNone - 1) {
    return scan_.fail(ErrorCode::too_large, "more than 4294967294 points", start);
  }
  mesh_.points.push_back({row_[0], row_[1], row_[2]});
  extra_.insert(extra_.end(), row_.begin() + 3, row_.end());
  return true;
}

// Whole numbers up to 255, and not only zeros and ones, which normals along the axes have.
bool XyzReader::are_colours(std::size_t first) const {
  bool above_one = false;
  for (std::size_t i = first; i < extra_.size(); i += width_ - 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      const double x = extra_[k];
      if (!(x >= 0 && x <= 255) || x != std::floor(x)) return false;
      above_one = above_one || x > 1;
    }
  }
  return above_one;
}

void XyzReader::add_channel(const char* name, std::vector<std::string> parts, std::size_t first,
                            Storage storage) {
  Channel channel{name, std::move(parts), {}, storage};
  channel.values.reserve(mesh_.points.size() * channel.width());
  for (std::size_t i = first; i < extra_.size(); i += width_ - 3) {
    for (std::size_t k = 0; k < channel.width(); ++k) channel.values.push_back(extra_[i + k]);
  }
  mesh_.channels.push_back(std::move(channel));
}

void XyzReader::add_channels() {
  std::size_t first = 0;
  if (width_ == 4 || width_ == 7 || width_ == 10) {  // an intensity before the rest
    add_channel("intensity", {"intensity"}, first++);
  }
  bool has_colours = false;
  bool has_normals = false;
  for (; first + 3 <= width_ - 3; first += 3) {
    if (!has_colours && are_colours(first)) {
      add_channel("color", {"red", "green", "blue"}, first, Storage::uint8);
      has_colours = true;
    } else if (!has_normals) {
      add_channel("normal", {"nx", "ny", "nz"}, first);
      has_normals = true;
    } else {
      break;
    }
  }
  for (; first < width_ - 3; ++first) {
    const std::string name = fmt::format("column{}", first + 4);
    add_channel(name.c_str(), {name}, first);
  }
}

}  // namespace

bool read_xyz(Scanner& scan, LoadedMesh& out) { return XyzReader(scan, out).read(); }

}  // namespace surpass::io

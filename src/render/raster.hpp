// Values for a band of a picture's rows.
#pragma once

#include <cstddef>
#include <vector>

namespace surpass::picture {

/// Rows [first, last) of a picture; x and y count as in the whole picture.
template <class T>
class Raster {
 public:
  Raster(int width, int first, int last)
      : width_(width),
        first_(first),
        last_(last),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(last - first)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return last_; }

  [[nodiscard]] T& at(int x, int y) { return values_[place(x, y)]; }
  [[nodiscard]] const T& at(int x, int y) const { return values_[place(x, y)]; }

  /// Calls visit(value) for those of the pixels at most `radius` rows and columns away that the
  /// band has, with their offset.
  template <class Visit>
  void for_each_near(int x, int y, int radius, Visit&& visit) const {
    for (int j = y - radius; j <= y + radius; ++j) {
      if (j < first_ || j >= last_) continue;
      for (int i = x - radius; i <= x + radius; ++i) {
        if (i >= 0 && i < width_) visit(at(i, j), i - x, j - y);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - first_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int first_;
  int last_;
  std::vector<T> values_;
};

}  // namespace surpass::picture

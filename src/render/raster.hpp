// Values for a band of a picture's rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace surpass::picture {

/// Rows [first, last) of a picture; x and y count as in the whole picture.
template <class T>
class Raster {
 public:
  explicit Raster(int width) : width_(width) {}

  /// Goes to other rows and keeps the memory; what the values are is unspecified.
  void cover(int first, int last) {
    first_ = first;
    last_ = last;
    values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(last - first));
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return last_; }

  [[nodiscard]] T& at(int x, int y) { return values_[place(x, y)]; }
  [[nodiscard]] const T& at(int x, int y) const { return values_[place(x, y)]; }
  [[nodiscard]] std::span<T> row(int y) {
    return std::span(values_).subspan(place(0, y), static_cast<std::size_t>(width_));
  }

  /// Calls visit(value) for those of the pixels at most `radius` rows and columns away that the
  /// band has, with their offset.
  template <class Visit>
  void for_each_near(int x, int y, int radius, Visit&& visit) const {
    for (int j = std::max(first_, y - radius); j < std::min(last_, y + radius + 1); ++j) {
      for (int i = std::max(0, x - radius); i < std::min(width_, x + radius + 1); ++i) {
        visit(at(i, j), i - x, j - y);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - first_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int first_ = 0;
  int last_ = 0;
  std::vector<T> values_;
};

}  // namespace surpass::picture

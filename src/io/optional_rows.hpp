// Numbers that a file may give behind some of its rows, such as colours: a channel only if every
// row has them, and equally many.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace surpass::io {

class OptionalRows {
 public:
  void add(std::span<const double> row) {
    if (rows_++ == 0) width_ = row.size();
    uniform_ = uniform_ && row.size() == width_;
    values_.insert(values_.end(), row.begin(), row.end());
  }

  /// True if they make a channel for `count` rows. Else a notice is left if there were any.
  [[nodiscard]] bool complete(std::size_t count, const char* of_what,
                              std::vector<std::string>& notices) const {
    if (rows_ == 0) return false;
    if (rows_ == count && uniform_) return true;
    notices.push_back(fmt::format("{} of {} {} have a colour{}; these colours are left out", rows_,
                                  count, of_what, uniform_ ? "" : ", not all of equal width"));
    return false;
  }
  [[nodiscard]] std::vector<double>& values() { return values_; }
  /// {"red", "green", "blue"}, with "alpha" where there are four.
  [[nodiscard]] std::vector<std::string> colour_parts() const {
    std::vector<std::string> parts = {"red", "green", "blue", "alpha"};
    parts.resize(width_);
    return parts;
  }

 private:
  std::vector<double> values_;
  std::size_t rows_ = 0;
  std::size_t width_ = 0;
  bool uniform_ = true;
};

}  // namespace surpass::io

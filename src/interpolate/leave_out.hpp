// As few of a list as do.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace surpass {

/// What is left of the list when parts of it are left out, halves first and single ones last, as
/// long as the rest suffices: then nothing alone can be left out, where more never suffices less
/// (Zeller and Hildebrandt, Simplifying and isolating failure-inducing input, 2002).
/// `suffices(rest)` says as an optional list what of the rest does, or nothing. About as many tries
/// as are left times the logarithm of those that were.
template <class T, class Suffices>
[[nodiscard]] std::vector<T> leave_out(std::vector<T> list, Suffices&& suffices) {
  for (std::size_t part = (list.size() + 1) / 2; part > 0; part /= 2) {
    for (std::size_t begin = 0; begin < list.size();) {
      std::vector<T> rest = list;
      const auto from = rest.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto count = static_cast<std::ptrdiff_t>(std::min(part, list.size() - begin));
      rest.erase(from, from + count);
      if (std::optional<std::vector<T>> fewer = suffices(std::move(rest))) {
        list = std::move(*fewer);
      } else {
        begin += part;
      }
    }
  }
  return list;
}

}  // namespace surpass

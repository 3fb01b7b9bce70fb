// The rows of a PLY file behind its header, as text or as bytes. Both sources offer the same
// functions, so that what an element means is written once.
#pragma once

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/ply_channels.hpp"
#include "io/ply_header.hpp"
#include "io/scanner.hpp"
#include "io/storage.hpp"

namespace surpass::io {

/// Text: one row a line.
class PlyText {
 public:
  static constexpr bool kBinary = false;
  explicit PlyText(Scanner& scan) : scan_(scan) {}

  /// Where the next value begins.
  [[nodiscard]] const char* at() {
    scan_.skip_blanks();
    return scan_.at();
  }
  /// The least number of bytes that a value takes, a blank or line end included.
  [[nodiscard]] static std::uint64_t least_size(Storage) { return 2; }
  /// Bytes that are left for values; the last one needs no blank behind it.
  [[nodiscard]] std::uint64_t left() const { return std::uint64_t{scan_.left()} + 1; }
  void begin_row() { scan_.skip_space(); }
  [[nodiscard]] bool end_row() {
    if (scan_.at_line_end()) return scan_.end_line();
    return fail(ErrorCode::syntax,
                "the line holds more values than the header announces; correct the header or the "
                "line",
                scan_.at());
  }
  [[nodiscard]] bool value(Storage type, const std::string& name, double& value) {
    scan_.skip_blanks();
    const char* place = scan_.at();
    if (!scan_.number(value, name.c_str())) return false;
    if (is_floating(type)) return true;
    value += 0.0;  // whole numbers have no negative zero
    return fits({&value, 1}, type) ||
           fail(ErrorCode::bad_number,
                fmt::format("{} is no whole number that fits the header's type {}", name,
                            ply_name(type)),
                place);
  }
  [[nodiscard]] bool skip(Storage type, const std::string& name) {
    double ignored = 0;
    return value(type, name, ignored);
  }
  bool fail(ErrorCode code, std::string message, const char* place) {
    return scan_.fail(code, std::move(message), place);
  }

 private:
  Scanner& scan_;
};

/// Bytes; kSwapped where their order is not the machine's.
template <bool kSwapped>
class PlyBytes {
 public:
  static constexpr bool kBinary = true;
  explicit PlyBytes(Scanner& scan) : scan_(scan) {}

  [[nodiscard]] const char* at() const { return scan_.at(); }
  [[nodiscard]] static std::uint64_t least_size(Storage type) { return size_of(type); }
  [[nodiscard]] std::uint64_t left() const { return scan_.left(); }
  void begin_row() {}
  [[nodiscard]] bool end_row() { return true; }
  [[nodiscard]] bool value(Storage type, const std::string& name, double& value) {
    const char* place = scan_.at();
    if (!skip(type, name)) return false;
    value = with_type(type, [place](auto zero) {
      return static_cast<double>(load<decltype(zero), kSwapped>(place));
    });
    return std::isfinite(value) || scan_.allows_not_finite() ||
           fail(ErrorCode::not_finite,
                fmt::format("{} is {}; only finite numbers can be used, correct or remove it", name,
                            std::isnan(value) ? "NaN" : "infinite"),
                place);
  }
  [[nodiscard]] bool skip(Storage type, const std::string& name) {
    const std::size_t size = size_of(type);
    if (scan_.left() < size) {
      return fail(ErrorCode::unexpected_end, fmt::format("the file ends before {}", name), at());
    }
    scan_.advance(size);
    return true;
  }
  bool fail(ErrorCode code, std::string message, const char* place) {
    return scan_.fail_at_byte(code, std::move(message), place);
  }

  /// Reads rows of single values column by column, a block that fits the cache at a time. Sizes
  /// were checked before. False, and nothing is consumed, if a value is not finite.
  [[nodiscard]] bool gather(const PlyElement& element, const std::vector<Column>& columns) {
    constexpr std::size_t kBlock = 512;
    std::size_t stride = 0;
    for (const PlyProperty& property : element.properties) stride += size_of(property.type);
    const auto rows = static_cast<std::size_t>(element.count);
    for (std::size_t first = 0; first < rows; first += kBlock) {
      const std::size_t count = std::min(kBlock, rows - first);
      const char* from = at() + first * stride;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        double* to = columns[k].to + first * columns[k].stride;
        const bool finite = with_type(element.properties[k].type, [&](auto zero) {
          return copy_column<decltype(zero)>(from, stride, count, to, columns[k].stride);
        });
        if (!finite) return false;
        from += size_of(element.properties[k].type);
      }
    }
    scan_.advance(rows * stride);
    return true;
  }

  /// Reads rows that are one list of 32-bit whole numbers below `limit` each. False, and nothing is
  /// consumed, for other lists and wherever reading row by row finds something to refuse.
  [[nodiscard]] bool gather_lists(const PlyElement& element, std::uint64_t limit,
                                  std::vector<Index>& values, std::vector<Index>& offsets) {
    const PlyProperty& list = element.properties.front();
    if (element.properties.size() != 1 || !list.count_type) return false;
    if (list.type != Storage::int32 && list.type != Storage::uint32) return false;
    switch (*list.count_type) {
      case Storage::uint8: return copy_lists<std::uint8_t>(element.count, limit, values, offsets);
      case Storage::int32:
      case Storage::uint32: return copy_lists<std::uint32_t>(element.count, limit, values, offsets);
      default: return false;
    }
  }

 private:
  template <class T>
  static bool copy_column(const char* from, std::size_t from_stride, std::size_t count, double* to,
                          std::size_t to_stride) {
    double sum = 0;  // of zeros, unless a value is NaN or infinite
    for (std::size_t row = 0; row < count; ++row) {
      const auto value = static_cast<double>(load<T, kSwapped>(from + row * from_stride));
      to[row * to_stride] = value;
      sum += value * 0.0;
    }
    return sum == 0;
  }

  // Negative numbers count as large ones, which are out of range as well.
  template <class Length>
  bool copy_lists(std::uint64_t rows, std::uint64_t limit, std::vector<Index>& values,
                  std::vector<Index>& offsets) {
    const char* p = at();
    const char* end = p + left();
    for (std::uint64_t row = 0; row < rows; ++row) {
      if (static_cast<std::size_t>(end - p) < sizeof(Length)) return false;
      const std::size_t count = load<Length, kSwapped>(p);
      p += sizeof(Length);
      const std::size_t first = values.size();
      if (count == 0 || static_cast<std::size_t>(end - p) / sizeof(Index) < count ||
          first + count >= kNone) {
        return false;
      }
      values.resize(first + count);
      Index largest = 0;
      for (std::size_t k = 0; k < count; ++k, p += sizeof(Index)) {
        values[first + k] = load<Index, kSwapped>(p);
        largest = std::max(largest, values[first + k]);
      }
      if (largest >= limit) return false;
      offsets.push_back(static_cast<Index>(values.size()));
    }
    scan_.move_to(p);
    return true;
  }

  Scanner& scan_;
};

/// Reads all rows of an element. Single values go to their columns; for a list, on_list(property
/// number, length) reads the values; end_row(first byte of the row, row) has the last word.
template <class Source, class OnList, class EndRow>
[[nodiscard]] bool read_rows(Source& source, const PlyElement& element,
                             const std::vector<Column>& columns, OnList&& on_list,
                             EndRow&& end_row) {
  for (std::size_t row = 0; row < element.count; ++row) {
    source.begin_row();
    const char* place = source.at();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (!property.count_type) {
        if (!source.value(property.type, property.name, columns[k].to[row * columns[k].stride])) {
          return false;
        }
        continue;
      }
      double length = 0;
      const char* list = source.at();
      if (!source.value(*property.count_type, property.name, length)) return false;
      if (length < 0) {
        return source.fail(ErrorCode::syntax,
                           fmt::format("the list {} has a negative length", property.name), list);
      }
      if (length * static_cast<double>(source.least_size(property.type)) >
          static_cast<double>(source.left())) {
        return source.fail(ErrorCode::unexpected_end,
                           fmt::format("the list {} announces {} values, more than the file has "
                                       "bytes for; it is damaged or cut off",
                                       property.name, length),
                           list);
      }
      if (!on_list(k, static_cast<std::size_t>(length))) return false;
    }
    if (!source.end_row() || !end_row(place, row)) return false;
  }
  return true;
}

}  // namespace surpass::io

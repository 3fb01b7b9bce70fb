// The rows of a PLY file behind its header, as text or as bytes. Both sources offer the same
// functions, so that what an element means is written once.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

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

  /// Reads rows of single values column by column, a block that fits the cache at a time. Before
  /// each, grow(rows) is told how many rows the columns must have room for; so that memory which
  /// has to be cleared is written to while it is near. Sizes were checked before. False, and
  /// nothing is consumed, if a value is not finite.
  template <class Grow>
  [[nodiscard]] bool gather(const PlyElement& element, const std::vector<Column>& columns,
                            Grow&& grow) {
    constexpr std::size_t kBlock = 512;
    std::size_t stride = 0;
    for (const PlyProperty& property : element.properties) stride += size_of(property.type);
    const auto rows = static_cast<std::size_t>(element.count);
    for (std::size_t first = 0; first < rows; first += kBlock) {
      const std::size_t count = std::min(kBlock, rows - first);
      grow(first + count);
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
    bool finite = true;
    for (std::size_t row = 0; row < count; ++row) {
      const auto value = static_cast<double>(load<T, kSwapped>(from + row * from_stride));
      to[row * to_stride] = value;
      finite &= std::abs(value) <= std::numeric_limits<double>::max();
    }
    return finite;
  }

  template <class Length>
  bool copy_lists(std::uint64_t rows, std::uint64_t limit, std::vector<Index>& values,
                  std::vector<Index>& offsets) {
    constexpr std::uint64_t kBlock = 1024;
    const char* p = at();
    for (std::uint64_t row = 0; row < rows; row += kBlock) {
      const auto count = static_cast<std::size_t>(std::min(kBlock, rows - row));
      if (!copy_block<Length>(p, count, limit, values, offsets)) return false;
    }
    scan_.move_to(p);
    return true;
  }

  // The rows from p on, which moves behind them. Room is made for all of them at once, as if they
  // were like the first, but for no more than was reserved. Negative numbers count as large ones,
  // which are out of range as well.
  template <class Length>
  bool copy_block(const char*& p, std::size_t rows, std::uint64_t limit, std::vector<Index>& values,
                  std::vector<Index>& offsets) {
    const char* end = at() + left();
    const auto has = [&](std::size_t count, std::size_t size) {
      return static_cast<std::size_t>(end - p) / size >= count;
    };
    if (!has(1, sizeof(Length))) return false;
    constexpr std::size_t kUsualLength = 4;
    std::size_t used = values.size();
    const std::size_t first_row = offsets.size();
    const std::size_t length = std::min<std::size_t>(load<Length, kSwapped>(p), kUsualLength);
    values.resize(std::min(used + rows * length, values.capacity()));
    offsets.resize(first_row + rows);
    Index largest = 0;
    for (std::size_t row = first_row; row < first_row + rows; ++row) {
      if (!has(1, sizeof(Length))) return false;
      const std::size_t count = load<Length, kSwapped>(p);
      p += sizeof(Length);
      if (count == 0 || !has(count, sizeof(Index)) || used + count >= kNone) return false;
      if (values.size() < used + count) values.resize(used + count);
      Index* to = values.data() + used;
      largest = std::max(largest, count == 3 ? copy_list<3>(p, 3, to) : copy_list<0>(p, count, to));
      p += count * sizeof(Index);
      used += count;
      offsets[row] = static_cast<Index>(used);
    }
    values.resize(used);
    return largest < limit;
  }

  // The largest of `count` numbers, which are copied; a constant kCount says it for the compiler.
  template <std::size_t kCount>
  static Index copy_list(const char* from, std::size_t count, Index* to) {
    Index largest = 0;
    for (std::size_t k = 0; k < (kCount != 0 ? kCount : count); ++k) {
      to[k] = load<Index, kSwapped>(from + k * sizeof(Index));
      largest = std::max(largest, to[k]);
    }
    return largest;
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

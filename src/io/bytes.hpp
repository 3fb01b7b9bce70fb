// A whole file in memory.
#pragma once

#include <surpass/result.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace surpass::io {

/// Bytes on the heap that are not cleared before they are read into.
class Bytes {
 public:
  [[nodiscard]] std::string_view view() const { return {data_.get(), size_}; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] char* free_space() { return data_.get() + size_; }
  void grow_by(std::size_t count) { size_ += count; }
  /// Makes room for `capacity` bytes in all; false if there is no memory for them.
  [[nodiscard]] bool reserve(std::size_t capacity);

 private:
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// Reads a file, a device or a pipe to its end; "-" is the standard input.
[[nodiscard]] Result<Bytes> read_bytes(const std::string& path);

}  // namespace surpass::io

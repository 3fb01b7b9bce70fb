// Number types of binary files: size, name in PLY, conversion from and to double.
#pragma once

#include <surpass/mesh.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace surpass::io {

[[nodiscard]] std::size_t size_of(Storage type);
[[nodiscard]] inline bool is_floating(Storage type) {
  return type == Storage::float64 || type == Storage::float32;
}
/// "double", "uchar", ...
[[nodiscard]] const char* ply_name(Storage type);
/// Both of PLY's families of names: "uchar" and "uint8".
[[nodiscard]] std::optional<Storage> storage_named(std::string_view name);

/// Calls use(T{}) with the type's C++ counterpart.
template <class Use>
decltype(auto) with_type(Storage type, Use&& use) {
  switch (type) {
    case Storage::float32: return use(float{});
    case Storage::int8: return use(std::int8_t{});
    case Storage::uint8: return use(std::uint8_t{});
    case Storage::int16: return use(std::int16_t{});
    case Storage::uint16: return use(std::uint16_t{});
    case Storage::int32: return use(std::int32_t{});
    case Storage::uint32: return use(std::uint32_t{});
    case Storage::float64: break;
  }
  return use(double{});
}

/// The nearest float's value. Not inlined, because GCC 12.2 drops a conversion to float and back
/// where it vectorises the pair.
[[gnu::noinline]] [[nodiscard]] double rounded_to_float(double value);

/// True if every value survives conversion to the type and back, the sign of zero included.
[[nodiscard]] bool fits(std::span<const double> values, Storage type);

/// A number at an unaligned place; kSwapped reads the other byte order than the machine's.
template <class T, bool kSwapped>
[[nodiscard]] T load(const char* place) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, place, sizeof(T));
  if constexpr (kSwapped) {
    for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(bytes[k], bytes[sizeof(T) - 1 - k]);
  }
  return std::bit_cast<T>(bytes);
}

template <class T>
void append(std::string& out, T value, bool swap) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (swap) {
    for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(bytes[k], bytes[sizeof(T) - 1 - k]);
  }
  out.append(bytes, sizeof(T));
}

}  // namespace surpass::io

// What C++20 has and Emscripten 3.1.6's library has not. Included ahead of every source of this
// build, so that the core need not know.
#pragma once

#include <bit>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace std {  // NOLINT(cert-dcl58-cpp): the very names that the standard has there

#ifndef __cpp_lib_bit_cast
template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>)
    [[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class Array>
requires(is_unbounded_array_v<Array>)
    [[nodiscard]] unique_ptr<Array> make_unique_for_overwrite(size_t size) {
  return unique_ptr<Array>(new remove_extent_t<Array>[size]);
}
#endif

}  // namespace std

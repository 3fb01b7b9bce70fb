// What a binary STL file is made of.
#pragma once

#include <bit>
#include <cstddef>

namespace surpass::io::stl {

inline constexpr std::size_t kHeader = 80;
inline constexpr std::size_t kPrelude = kHeader + 4;  // header and count
inline constexpr std::size_t kFacet = 50;             // normal, three positions, attribute
inline constexpr std::size_t kFacetPositions = 12;
inline constexpr std::size_t kFacetAttribute = 48;
inline constexpr bool kSwap = std::endian::native != std::endian::little;

}  // namespace surpass::io::stl

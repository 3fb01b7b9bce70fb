#include "io/storage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace surpass::io {
namespace {

struct TypeName {
  Storage type;
  const char* ply;
  const char* sized;
};

constexpr TypeName kTypes[] = {
    {Storage::float64, "double", "float64"}, {Storage::float32, "float", "float32"},
    {Storage::int8, "char", "int8"},         {Storage::uint8, "uchar", "uint8"},
    {Storage::int16, "short", "int16"},      {Storage::uint16, "ushort", "uint16"},
    {Storage::int32, "int", "int32"},        {Storage::uint32, "uint", "uint32"},
};

template <class T>
bool fits_in(double value) {
  if constexpr (std::is_same_v<T, double>) {
    return true;
  } else if constexpr (std::is_same_v<T, float>) {
    const bool in_range = std::abs(value) <= static_cast<double>(std::numeric_limits<T>::max());
    return in_range && rounded_to_float(value) == value;
  } else {
    return value >= static_cast<double>(std::numeric_limits<T>::min()) &&
           value <= static_cast<double>(std::numeric_limits<T>::max()) &&
           value == std::floor(value) && !(value == 0 && std::signbit(value));
  }
}

}  // namespace

std::size_t size_of(Storage type) {
  return with_type(type, [](auto zero) { return sizeof(zero); });
}

const char* ply_name(Storage type) {
  for (const TypeName& known : kTypes) {
    if (known.type == type) return known.ply;
  }
  return "double";
}

std::optional<Storage> storage_named(std::string_view name) {
  for (const TypeName& known : kTypes) {
    if (name == known.ply || name == known.sized) return known.type;
  }
  return std::nullopt;
}

double rounded_to_float(double value) { return static_cast<double>(static_cast<float>(value)); }

bool fits(std::span<const double> values, Storage type) {
  return with_type(type, [values](auto zero) {
    return std::all_of(values.begin(), values.end(), fits_in<decltype(zero)>);
  });
}

}  // namespace surpass::io

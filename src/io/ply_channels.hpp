// Which PLY properties belong together, and what they make of a mesh.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/ply_header.hpp"

namespace surpass::io {

/// Properties that many programs write side by side.
struct KnownChannel {
  std::string name;
  std::vector<std::string> parts;
};
[[nodiscard]] const std::vector<KnownChannel>& known_channels();

/// Where the values of a property go, row after row: every `stride` numbers from `to` on.
struct Column {
  double* to = nullptr;  ///< null also where there are no rows
  std::size_t stride = 0;
  bool taken = false;
};
[[nodiscard]] Column column_of(std::span<double> values, std::size_t part, std::size_t width);

/// Makes channels (Channel or FaceChannel) of the single-valued properties that have no column yet,
/// and gives them their columns. Takes memory for element.count rows.
template <class AnyChannel>
[[nodiscard]] std::vector<AnyChannel> make_channels(const PlyElement& element,
                                                    std::vector<Column>& columns);

}  // namespace surpass::io

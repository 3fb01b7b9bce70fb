// The text at the head of a PLY file: which elements follow, and the properties of each.
#pragma once

#include <surpass/io.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scanner.hpp"

namespace surpass::io {

struct PlyProperty {
  std::string name;
  Storage type = Storage::float64;         ///< of a value
  std::optional<Storage> count_type = {};  ///< of a list's length; none for a single value
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};
  const char* place = nullptr;  ///< of its line in the header

  /// The property's number, or nullopt.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  Encoding encoding = Encoding::automatic;
  std::vector<PlyElement> elements;

  [[nodiscard]] const PlyElement* find(std::string_view element) const;
};

/// Reads up to and with the line `end_header`. Annotations in comments go to the mesh.
[[nodiscard]] bool read_ply_header(Scanner& scan, PlyHeader& header, Mesh& mesh);

}  // namespace surpass::io

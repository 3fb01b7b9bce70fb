// Short forms for tests of readers and writers.
#pragma once

#include <surpass/io.hpp>

#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace surpass {

/// Parses text that must be legal.
inline LoadedMesh parsed(std::string_view text, Format format) {
  Result<LoadedMesh> result = parse_mesh(text, format, "test");
  EXPECT_TRUE(result) << (result ? "" : describe(result.error()));
  return result ? std::move(*result) : LoadedMesh{};
}

/// Writes a mesh that can be written; what was left out goes to `notes`.
inline std::string formatted(const Mesh& mesh, const WriteOptions& options,
                             std::vector<std::string>* notes = nullptr) {
  std::string bytes;
  const auto result = format_mesh(mesh, options, bytes);
  EXPECT_TRUE(result) << (result ? "" : describe(result.error()));
  if (notes != nullptr && result) *notes = *result;
  return bytes;
}

inline Mesh written_and_read(const Mesh& mesh, const WriteOptions& options) {
  return parsed(formatted(mesh, options), options.format).mesh;
}

inline Mesh unit_triangle() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face(std::array<Index, 3>{0, 1, 2});
  return mesh;
}

}  // namespace surpass

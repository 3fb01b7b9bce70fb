// The faces of a refined mesh, all of one size.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/result.hpp>

#include <fmt/format.h>

namespace surpass {

/// Half-edges of a closed mesh are numbered by Index; more corners than half of that are refused.
[[nodiscard]] inline Result<void> check_refined_corners(std::uint64_t corners) {
  if (corners <= kNone / 2) return {};
  return fail(ErrorCode::too_large,
              fmt::format("the refined mesh would have {} face corners", corners));
}

/// Room for `faces` faces of `size` corners; the vertices are to be filled in.
[[nodiscard]] inline Result<Mesh> mesh_of_equal_faces(std::uint64_t faces, std::uint64_t size) {
  if (auto ok = check_refined_corners(faces * size); !ok) return tl::make_unexpected(ok.error());
  Mesh mesh;
  mesh.face_offsets.resize(faces + 1);
  for (std::uint64_t f = 0; f <= faces; ++f) mesh.face_offsets[f] = static_cast<Index>(f * size);
  mesh.face_vertices.resize(faces * size);
  return mesh;
}

}  // namespace surpass

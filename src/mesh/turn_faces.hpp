#pragma once

#include <span>

#include "mesh/select.hpp"

namespace surpass {

/// The mesh with those faces turned inside out that have turn[f] != 0; their first corner stays
/// first.
[[nodiscard]] inline Mesh turn_faces(const Mesh& mesh, std::span<const unsigned char> turn) {
  Selection s = Selection::of_all_vertices(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (turn[f] == 0) {
      s.add_face(mesh, f);
      continue;
    }
    s.add_corner(mesh, mesh.face_offsets[f]);
    for (Index c = mesh.face_offsets[f + 1]; --c > mesh.face_offsets[f];) s.add_corner(mesh, c);
    s.end_face(f);
  }
  return select(mesh, std::move(s));
}

}  // namespace surpass

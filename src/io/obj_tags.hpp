// OpenSubdiv's `t` lines in OBJ files: `t NAME #ints/#floats/#strings ints... floats...
// strings...`, vertices and faces counted from 0.
#pragma once

#include <surpass/mesh.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "io/scanner.hpp"

namespace surpass::io {

/// Something that faces and tags name by number.
struct Numbered {
  const char* name;                 ///< "vertex"
  std::uint64_t count = 0;          ///< how many the file has given so far
  std::uint64_t needed = 0;         ///< the largest number named so far, counted from 1
  const char* needed_at = nullptr;  ///< and the place

  void name_it(std::uint64_t from_zero, const char* place) {
    if (from_zero < needed) return;
    needed = from_zero + 1;
    needed_at = place;
  }
};

/// Reads the rest of a line behind its `t`. Creases, corners and holes go to their places in the
/// mesh, everything else to Mesh::tags.
[[nodiscard]] bool read_obj_tag(Scanner& scan, Numbered& vertices, Numbered& faces, Mesh& mesh,
                                std::vector<std::string>& notices);

}  // namespace surpass::io

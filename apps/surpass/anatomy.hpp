// What `inspect` finds out about a mesh, as values.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/repair.hpp>
#include <surpass/scheme.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session.hpp"

namespace surpass::cli {

/// What only a topology can tell; absent where the mesh has none.
struct Connections {
  std::size_t edges = 0;
  std::size_t components = 0;
  std::size_t isolated_vertices = 0;
  std::size_t bowties = 0;
  std::vector<std::size_t> boundary_loops;         ///< edges of each loop
  std::map<Index, std::size_t> interior_valences;  ///< valence -> number of vertices
  std::map<Index, std::size_t> boundary_valences;
};

struct Anatomy {
  std::map<std::size_t, std::size_t> face_sizes;  ///< corners -> number of faces
  Box box;
  std::optional<Connections> connections;
  Diagnosis diagnosis;  ///< with the scheme's own refusal of polygons among its refusals
};

[[nodiscard]] Anatomy examine(const Mesh& mesh, Scheme scheme);

[[nodiscard]] Json anatomy_json(const Mesh& mesh, const Anatomy& anatomy);

/// The same for people.
[[nodiscard]] std::string anatomy_table(const Mesh& mesh, const Anatomy& anatomy);

}  // namespace surpass::cli

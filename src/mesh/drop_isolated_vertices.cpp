#include <surpass/repair.hpp>

#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass {

Mended drop_isolated_vertices(const Mesh& mesh) {
  std::vector<unsigned char> used(mesh.points.size(), 0);
  for (const Index v : mesh.face_vertices) used[v] = 1;
  Selection s = Selection::of_vertices(used);
  const std::size_t dropped = mesh.points.size() - s.vertex_source.size();
  if (dropped == 0) return {mesh, {}};
  for (Index f = 0; f < mesh.face_count(); ++f) s.add_face(mesh, f);
  return {select(mesh, std::move(s)),
          {fmt::format("dropped {} that no face uses", counted(dropped, "vertex", "vertices"))}};
}

}  // namespace surpass

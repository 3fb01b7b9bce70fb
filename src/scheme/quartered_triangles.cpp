#include "scheme/quartered_triangles.hpp"

#include <algorithm>
#include <iterator>

#include "parallel/parallel.hpp"
#include "scheme/refine_attributes.hpp"
#include "scheme/refined_faces.hpp"

namespace surpass {

Result<Mesh> quartered_triangles(const Mesh& mesh, const Topology& topology,
                                 const Context& context) {
  const Index n = topology.vertex_count();
  const Index faces = topology.face_count();
  auto refined = mesh_of_equal_faces(std::uint64_t{4} * faces, 3);
  if (!refined) return refined;
  parallel::for_ranges(context, faces, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto h = static_cast<Index>(3 * f);
      const Index middle[3] = {n + topology.edge(h), n + topology.edge(h + 1),
                               n + topology.edge(h + 2)};
      const Index child[12] = {
          topology.tail(h), middle[0],
          middle[2],  //
          middle[0],        topology.tail(h + 1),
          middle[1],        middle[2],
          middle[1],        topology.tail(h + 2),
          middle[0],        middle[1],
          middle[2],
      };
      std::copy(std::begin(child), std::end(child),
                refined->face_vertices.begin() + 12 * static_cast<std::ptrdiff_t>(f));
    }
  });
  inherit_creases(mesh, topology, *refined);
  inherit_face_attributes(
      mesh, [](Index f) { return 4 * f; }, *refined);
  refine_corner_channels_of_triangles(mesh, *refined);
  return refined;
}

}  // namespace surpass

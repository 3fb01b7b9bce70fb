#include <surpass/repair.hpp>

#include "mesh/ear_clipping.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass {

Mended triangulate(const Mesh& mesh) {
  Selection s = Selection::of_all_vertices(mesh);
  EarClipping clip;
  std::vector<Point> polygon;
  std::size_t polygons = 0;
  std::size_t triangles = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() <= 3) {
      s.add_face(mesh, f);
      continue;
    }
    polygon.clear();
    for (const Index v : face) polygon.push_back(mesh.points[v]);
    for (const EarClipping::Triangle& triangle : clip(polygon)) {
      for (const Index corner : triangle) s.add_corner(mesh, mesh.face_offsets[f] + corner);
      s.end_face(f);
      ++triangles;
    }
    ++polygons;
  }
  if (polygons == 0) return {mesh, {}};
  return {select(mesh, std::move(s)),
          {fmt::format("cut {} into {} triangles", counted(polygons, "polygon", "polygons"),
                       triangles)}};
}

}  // namespace surpass

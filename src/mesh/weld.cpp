#include <surpass/repair.hpp>

#include <cmath>

#include "mesh/coincident.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass {

Result<Mended> weld(const Mesh& mesh, double distance) {
  if (!(distance >= 0) || !std::isfinite(distance)) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("vertices cannot be welded within {}: give a distance of 0 or more", distance));
  }
  const auto target = merge_targets(mesh.points, distance);
  Selection s;
  s.vertex_image.resize(mesh.points.size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    s.vertex_image[v] = target[v] == v ? s.add_copy(v) : s.vertex_image[target[v]];
  }
  const std::size_t merged = mesh.points.size() - s.vertex_source.size();
  if (merged == 0) return Mended{mesh, {}};
  for (Index f = 0; f < mesh.face_count(); ++f) s.add_face(mesh, f);
  return Mended{select(mesh, std::move(s)),
                {fmt::format("merged {} into others at most {} away",
                             counted(merged, "vertex", "vertices"), distance)}};
}

}  // namespace surpass

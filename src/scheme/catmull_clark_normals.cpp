#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_masks.hpp"

namespace surpass::catmull_clark {
Result<std::vector<Point>> CatmullClark::limit_normals(const Mesh& mesh, const Topology& topology,
                                                       const Rules& rules,
                                                       const Context& context) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  return normals_from_tangents(mesh, topology, context, [&](Index v) {
    const FaceRing ring = FaceRing::around(topology, *sharpness, v);
    return normal_masks(ring.columns, ring);
  });
}

}  // namespace surpass::catmull_clark

#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_masks.hpp"

namespace surpass::catmull_clark {
namespace {

NormalMasks masks_around(FaceRing&& given) {
  NormalMasks masks{std::move(given.columns), {}, {}};
  if (is_settled(given)) {
    masks.sectors = tangent_masks(given);
    return masks;
  }
  auto settled = settle(given, is_settled);
  masks.weights = std::move(settled.weights);
  masks.sectors = tangent_masks(settled.ring);
  return masks;
}

}  // namespace

Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                         Boundary boundary, const Context& context) {
  const auto sharpness = Sharpness::build(mesh, topology, boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  return normals_from_tangents(mesh, topology, context, [&](Index v) {
    return masks_around(FaceRing::around(topology, *sharpness, v));
  });
}

}  // namespace surpass::catmull_clark

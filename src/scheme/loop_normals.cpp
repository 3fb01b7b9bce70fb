#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"

namespace surpass::loop {
namespace {

NormalMasks masks_around(const LoopRing& given) {
  NormalMasks masks{{given.center}, {}, {}};
  masks.columns.insert(masks.columns.end(), given.spokes.begin(), given.spokes.end());
  if (given.is_settled()) {
    masks.sectors = tangent_masks(given);
    return masks;
  }
  auto settled = settle(given, [](const LoopRing& ring) { return ring.is_settled(); });
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
    return masks_around(LoopRing::around(topology, *sharpness, boundary, v));
  });
}

}  // namespace surpass::loop

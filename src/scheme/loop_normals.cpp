#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"

namespace surpass::loop {
Result<std::vector<Point>> Loop::limit_normals(const Mesh& mesh, const Topology& topology,
                                               const Rules& rules, const Context& context) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  return normals_from_tangents(mesh, topology, context, [&](Index v) {
    const LoopRing ring = LoopRing::around(topology, *sharpness, rules.boundary, v);
    std::vector<Index> columns = {v};
    columns.insert(columns.end(), ring.spokes.begin(), ring.spokes.end());
    return normal_masks(std::move(columns), ring);
  });
}

}  // namespace surpass::loop

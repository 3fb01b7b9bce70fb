#include "nonstationary.hpp"

#include <vector>

namespace surpass::wasm {
namespace {

using emscripten::val;

bool has_valence_3(const Mesh& mesh, const Topology& topology) {
  std::vector<bool> on_curve(mesh.points.size());
  for (const Crease& crease : mesh.creases) {
    for (const Index v : crease.vertices) on_curve[v] = on_curve[v] || crease.sharpness > 0;
  }
  for (const Corner& corner : mesh.corners) {
    on_curve[corner.vertex] = on_curve[corner.vertex] || corner.sharpness > 0;
  }
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (topology.is_isolated(v) || topology.is_boundary(v) || on_curve[v]) continue;
    if (topology.valence(v) == 3) return true;
  }
  return false;
}

}  // namespace

val shapes_of(const Mesh& mesh, const Topology& topology) {
  const auto [lowest, highest] = shape_range(has_valence_3(mesh, topology));
  val shapes = val::object();
  shapes.set("lowest", lowest);
  shapes.set("highest", highest);
  shapes.set("round", kRoundShape);
  shapes.set("standard", kDefaultShape);
  shapes.set("flat", kFlatShape);
  return shapes;
}

Result<NonstationaryLoop> refined_by_itself(const Mesh& mesh, const NonstationaryOptions& options,
                                            int levels, const Context& context) {
  auto surface = NonstationaryLoop::create(mesh, options, context);
  for (int level = 0; surface && level < levels; ++level) {
    context.report({.stage = "subdivide", .fraction = static_cast<double>(level) / levels});
    const auto refined = surface->refine(context);
    if (!refined) return tl::make_unexpected(refined.error());
  }
  return surface;
}

}  // namespace surpass::wasm

// Catmull-Clark subdivision of any polygons. One file a method: catmull_clark_limit.cpp,
// catmull_clark_refine.cpp (new vertices: the given ones, then one per edge, then one per face),
// catmull_clark_normals.cpp, catmull_clark_evaluate.cpp, catmull_clark_patch.cpp.
#pragma once

#include "scheme/subdivision_scheme.hpp"

namespace surpass::catmull_clark {

class CatmullClark final : public SubdivisionScheme {
 public:
  const char* name() const override { return "catmull-clark"; }
  const char* title() const override { return "Catmull-Clark"; }
  [[nodiscard]] Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                                     const Rules& rules,
                                                     const Context& context) const override;
  [[nodiscard]] Result<Mesh> refinement(const Mesh& mesh, const Topology& topology,
                                        const Rules& rules, const Context& context,
                                        RowSink& sink) const override;
  [[nodiscard]] Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                                         const Rules& rules,
                                                         const Context& context) const override;
  [[nodiscard]] Spot spot(const Topology& topology, const Sharpness& sharpness,
                          Index v) const override;
  [[nodiscard]] LimitJet jet(const Mesh& mesh, const Topology& topology, Index v) const override;
  [[nodiscard]] Result<std::unique_ptr<const SurfaceEvaluator>> evaluator(
      const Mesh& mesh, const Topology& topology, const Rules& rules,
      const Context& context) const override;
  [[nodiscard]] bool makes_corners_faces() const override { return true; }
  [[nodiscard]] Result<SparseRows> given_limits(const Mesh& refined, const Topology& topology,
                                                const Rules& rules, const Mesh& given,
                                                const Context& context) const override;
  [[nodiscard]] Result<PatchKind> patch_kind(const Mesh& piece, const Rules& rules, int level,
                                             std::span<const unsigned char> sides,
                                             std::span<const Index> cut) const override;
};

}  // namespace surpass::catmull_clark

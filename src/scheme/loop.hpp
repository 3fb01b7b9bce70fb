// Loop subdivision. One file a method: loop_limit.cpp, loop_refine.cpp, loop_normals.cpp.
#pragma once

#include "scheme/subdivision_scheme.hpp"

namespace surpass::loop {

class Loop final : public SubdivisionScheme {
 public:
  const char* name() const override { return "loop"; }
  const char* title() const override { return "Loop"; }
  Index face_size() const override { return 3; }
  bool has_boundary_rule(Boundary) const override { return true; }
  [[nodiscard]] Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                                     const Rules& rules,
                                                     const Context& context) const override;
  [[nodiscard]] Result<Mesh> refinement(const Mesh& mesh, const Topology& topology,
                                        const Rules& rules, const Context& context,
                                        RowSink& sink) const override;
  [[nodiscard]] Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                                         const Rules& rules,
                                                         const Context& context) const override;
  [[nodiscard]] Result<SparseRows> given_limits(const Mesh& refined, const Topology& topology,
                                                const Rules& rules, const Mesh& given,
                                                const Context& context) const override;
  [[nodiscard]] Result<PatchKind> patch_kind(const Mesh& piece, const Rules& rules, int level,
                                             std::span<const unsigned char> sides,
                                             std::span<const Index> cut) const override;
  [[nodiscard]] Spot spot(const Topology& topology, const Sharpness& sharpness,
                          Index v) const override;
  [[nodiscard]] LimitJet jet(const Mesh& mesh, const Topology& topology, Index v) const override;
  double patch_measure() const override;
};

}  // namespace surpass::loop

// Doo-Sabin subdivision of polygon meshes: every corner of a face makes a point, every face, edge
// and vertex a new face.
//
// Doo, Sabin, Behaviour of recursive division surfaces near extraordinary points, 1978 (the scheme;
// weights `cosine`); Catmull, Clark, Recursively generated B-spline surfaces on arbitrary
// topological meshes, 1978 (weights `averaging`, those of the progressive-interpolation paper).
// Boundaries, creases, corners, darts, tips and doublets are ours; docs/methods/doo-sabin.md says
// which rule is whose. The words used for them in these files:
//
//   corner point   new vertex of a face's corner (half-edge) h; it has the number h
//   curve edge     boundary edge or infinitely sharp edge; it adds two curve points at a quarter
//                  of its length, so that curves are quadratic B-splines of the curve edges
//   kept vertex    vertex that stays where it is: sharp, on three or more curve edges, isolated
//   curve vertex   one with two curve edges; dart: with one; both unless kept
//   doublet        smooth vertex of two faces: its new face would have two sides and is left out
//   lens           the same at a kept vertex: the vertex joins the edge between the two faces
//   tip            a kept vertex with fewer than two curve edges, in a fan of triangles
#pragma once

#include "scheme/subdivision_scheme.hpp"

namespace surpass::doo_sabin {

class DooSabin final : public SubdivisionScheme {
 public:
  const char* name() const override { return "doo-sabin"; }
  const char* title() const override { return "Doo-Sabin"; }
  [[nodiscard]] Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                                     const Rules& rules,
                                                     const Context& context) const override;
  [[nodiscard]] Result<Mesh> refinement(const Mesh& mesh, const Topology& topology,
                                        const Rules& rules, const Context& context,
                                        RowSink& sink) const override;
  [[nodiscard]] Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                                         const Rules& rules,
                                                         const Context& context) const override;
  /// By the faces that the given vertices turned into, or the edges and vertices where they have
  /// none; a row may fail to have a vertex of its own beside doublets.
  [[nodiscard]] Result<SparseRows> given_limits(const Mesh& refined, const Topology& topology,
                                                const Rules& rules, const Mesh& given,
                                                const Context& context) const override;
  [[nodiscard]] bool finds_given_by_faces() const override { return true; }
  [[nodiscard]] Result<PatchKind> patch_kind(const Mesh& piece, const Rules& rules, int level,
                                             std::span<const unsigned char> sides,
                                             std::span<const Index> cut) const override;
  /// A patch a smooth vertex of four faces; one a vertex of a curve, with what leads along it.
  [[nodiscard]] Result<PatchRows> patch_rows(const Mesh& mesh, const Topology& topology,
                                             const Rules& rules, int level,
                                             std::span<const unsigned char> sampled,
                                             const Context& context, Sides sides) const override;
  /// From level 1 the dual of the refined mesh, whose vertices lie on the limit surface. The given
  /// vertices' limits come first.
  [[nodiscard]] Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                        const Context& context, Steps& steps) const override;
  [[nodiscard]] Spot spot(const Topology& topology, const Sharpness& sharpness,
                          Index v) const override;
  [[nodiscard]] LimitJet jet(const Mesh& mesh, const Topology& topology, Index v) const override;
  /// A patch a vertex, its sample at its centre: second derivatives jump between patches.
  [[nodiscard]] Result<LimitSamples> limit_samples(const Mesh& control, const Rules& rules,
                                                   int levels,
                                                   const Context& context) const override;
};

}  // namespace surpass::doo_sabin

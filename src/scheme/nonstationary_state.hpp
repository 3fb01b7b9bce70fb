// Where a non-stationary subdivision stands: its level and the parameters there.
#pragma once

#include <optional>
#include <vector>

#include "scheme/nonstationary_parameters.hpp"
#include "scheme/row_sink.hpp"
#include "scheme/settle.hpp"
#include "scheme/sharpness.hpp"
#include "scheme/tangents.hpp"

namespace surpass::nonstationary {

struct State {
  NonstationaryOptions options;  ///< the shape in its range
  std::vector<double> vertices;  ///< #given first parameters
  int level = 0;
  /// NonstationaryRule::mean: the parameter of each vertex of this level.
  std::vector<double> own = {};

  [[nodiscard]] Index given() const { return static_cast<Index>(vertices.size()); }
  /// Surfaces of these rules pass through the given vertices, so their curves have to, too.
  [[nodiscard]] bool interpolates() const {
    return options.rule == NonstationaryRule::interpolating ||
           options.rule == NonstationaryRule::quadratic;
  }
  /// The first step of the quadratic rule is one of its own; later ones are Loop's.
  [[nodiscard]] bool is_quadratic_step() const {
    return options.rule == NonstationaryRule::quadratic && level == 0;
  }
  /// Of the edges at this level, and that in their mask.
  [[nodiscard]] double beta() const { return iterated(options.shape, level, options); }
  [[nodiscard]] double edge_mask() const { return in_mask(beta(), options); }
  /// Of vertex v at this level; those that were born on an edge have its parameter.
  [[nodiscard]] double alpha(Index v) const {
    if (!own.empty()) return own[v];
    return v < given() ? iterated(vertices[v], level, options) : beta();
  }
};

/// A smooth edge between plain vertex `inner` and `curve`, a vertex on a curve, whose rule is bent
/// so that the curve's vertex has the eigenvalue 1/2 across: see nonstationary_curves.cpp.
struct BentEdge {
  Index curve = 0;
  Index inner = 0;
  double weight = 0;  ///< of `inner`, which the plain rule gives 1/2 - d
};
/// The edge of the half-edge h between `inner` and `curve`, or nothing if the plain rule holds.
[[nodiscard]] std::optional<BentEdge> bent_edge(const State& state, const Topology& topology,
                                                const Sharpness& sharpness, Index inner,
                                                Index curve);

/// The rows of new points on curves and at corners.
void add_curve_vertex(const State& state, const Topology& topology, const Sharpness& sharpness,
                      Index v, RowTile& tile);
void add_curve_edge(const State& state, const Topology& topology, const Sharpness& sharpness,
                    Index e, RowTile& tile);

/// Those of the quadratic rule's first step, at plain vertices and smooth edges.
void add_quadratic_vertex(const State& state, const Topology& topology, const Sharpness& sharpness,
                          Index v, RowTile& tile);
void add_quadratic_edge(const Topology& topology, const Sharpness& sharpness, Index e,
                        RowTile& tile);

/// One refinement step, as SubdivisionScheme::refinement.
[[nodiscard]] Result<Mesh> refinement(const State& state, const Mesh& mesh,
                                      const Topology& topology, const Sharpness& sharpness,
                                      const Context& context, RowSink& sink);

/// What a plain vertex with a parameter of its own on each spoke tends to: NonstationaryRule::mean.
struct RingLimit {
  Mask position;  ///< over center and spokes
  Tangents tangents;
};
[[nodiscard]] RingLimit ring_limit(double alpha, const std::vector<double>& spokes,
                                   const NonstationaryOptions& options);

/// Rows of #V limits; and #V unit normals. From level 1 on, and at level 0 where the first step is
/// like all others.
void limit_rows(const State& state, const Topology& topology, const Sharpness& sharpness,
                const Context& context, RowSink& sink);
[[nodiscard]] std::vector<Point> normals(const State& state, const Mesh& mesh,
                                         const Topology& topology, const Sharpness& sharpness,
                                         const Context& context);

}  // namespace surpass::nonstationary

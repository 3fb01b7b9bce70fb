// One refinement step with its faces' origins, and where the given vertices' limits stay.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "scheme/doo_sabin_faces.hpp"
#include "scheme/doo_sabin_weights.hpp"
#include "scheme/steps.hpp"

namespace surpass::doo_sabin {

/// A refined mesh without positions and vertex channels, whose rows went to a sink.
struct Step {
  Mesh mesh;
  NewMesh fresh;
};
[[nodiscard]] Result<Step> refinement_step(const Mesh& mesh, const Layout& layout, Weights family,
                                           const Context& context, RowSink& sink);

/// A place on a mesh whose limit point is known: a face's centroid, the midpoint of a curve edge, a
/// kept vertex; or a smooth edge, whose limit is the centroid of the face that it makes next.
struct Site {
  enum class Kind { face, edge, vertex };
  Kind kind = Kind::vertex;
  Index at = 0;  ///< face, half-edge, or vertex
};

/// Sites of the given vertices on the refined mesh, in order.
[[nodiscard]] std::vector<Site> sites_of_vertices(const Layout& layout, const NewMesh& fresh);

/// Where a site of the mesh is after the next refinement step.
[[nodiscard]] Site child_site(const Layout& layout, const NewMesh& fresh, const Site& site);

/// A refined mesh with the sites of the vertices of the mesh it came from.
struct Level {
  Mesh mesh;
  std::unique_ptr<const Topology> topology;  // in one place, where the layout finds it
  Layout layout;
  std::vector<Site> sites;
};
/// `levels` is at least 1.
[[nodiscard]] Result<Level> refined_level(Mesh mesh, const Rules& rules, int levels,
                                          const Context& context, Steps& steps);
[[nodiscard]] inline Result<Level> refined_level(Mesh mesh, const Rules& rules, int levels,
                                                 const Context& context) {
  Steps steps;
  return refined_level(std::move(mesh), rules, levels, context, steps);
}

}  // namespace surpass::doo_sabin

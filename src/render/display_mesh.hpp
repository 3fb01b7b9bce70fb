// The mesh as triangles to draw, which still know the polygons that they come from.
#pragma once

#include <surpass/render.hpp>

#include <vector>

#include "render/vector.hpp"

namespace surpass::picture {

struct Triangle {
  std::array<Index, 3> vertices;
  std::array<Index, 3> corners;  ///< of the mesh's polygon
  /// Side k, from vertex k to the next, is an edge of the polygon and not a cut through it.
  std::array<bool, 3> own_side;
};

struct DisplayMesh {
  std::vector<Triangle> triangles;   ///< without hole faces
  std::vector<Vec3> corner_normals;  ///< #corners of the mesh, unit or zero
};

/// Flat facets where `options` asks for them and where the mesh is no oriented manifold. A mesh of
/// points alone has no triangles. Fails for indices out of range, positions that are not finite,
/// and where there is nothing to draw.
[[nodiscard]] Result<DisplayMesh> make_display_mesh(const Mesh& mesh, const RenderOptions& options,
                                                    const Context& context = {});

/// The mesh's positions at the corners of what is drawn; all of them where there are no faces.
[[nodiscard]] std::vector<Point> drawn_points(const Mesh& mesh, const DisplayMesh& display);

}  // namespace surpass::picture

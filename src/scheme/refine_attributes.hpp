// What refined meshes inherit: creases, corners, face sets, holes and corner channels.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <functional>

namespace surpass {

/// Sharpness of child edges and vertices, for schemes that keep the vertices first and put the
/// point of edge e at #V + e. `refined` receives creases, corners and the remaining tags.
void inherit_creases(const Mesh& mesh, const Topology& topology, Mesh& refined);

/// Face sets, face channels and holes; the child faces of face f are those from first_child(f) to
/// first_child(f + 1).
void inherit_face_attributes(const Mesh& mesh, const std::function<Index(Index f)>& first_child,
                             Mesh& refined);

/// Corner channels of triangles cut in four (corner children first, then the middle), linearly.
/// Corners that shared a row of values, and edges that shared both, share their refined rows.
void refine_corner_channels_of_triangles(const Mesh& mesh, Mesh& refined);

/// Corner channels of polygons cut into a quad at each corner (corner, edge, face, edge), linearly:
/// face values are means. Sharing of rows as above.
void refine_corner_channels_to_quads(const Mesh& mesh, Mesh& refined);

}  // namespace surpass

// Subdivision schemes: refinement, and the limit surface at the vertices.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <string_view>
#include <vector>

namespace surpass {

enum class Scheme { loop, catmull_clark, doo_sabin };

/// What happens at the boundary of an open mesh. Names and meaning of the first two are
/// OpenSubdiv's.
enum class Boundary {
  edge_only,        ///< boundary curve: cubic B-spline of the boundary polygon
  edge_and_corner,  ///< the same, and vertices with exactly one face stay fixed
  hoppe,            ///< Loop: Hoppe et al. 1994, the rules of the progressive-interpolation paper
  interior,  ///< Loop: the interior limit mask over the edge neighbours; limit positions only
};

/// The two families of Doo-Sabin weights in a face of m vertices. They are the same for m = 4.
enum class Weights {
  averaging,  ///< Catmull and Clark 1978: means of vertex, edge midpoints and centroid
  cosine,     ///< Doo and Sabin 1978: (3 + 2 cos(2 pi j / m)) / (4 m)
};

/// A scheme and how it treats boundaries.
struct Rules {
  Scheme scheme = Scheme::loop;
  Boundary boundary = Boundary::edge_and_corner;
  Weights weights = Weights::averaging;  ///< of Doo-Sabin surfaces; other schemes have no choice
  bool operator==(const Rules&) const = default;
};

/// "loop", "catmull-clark", "doo-sabin"; "edge-only", "edge-and-corner", "hoppe", "interior";
/// "averaging", "cosine".
[[nodiscard]] const char* name_of(Scheme scheme);
[[nodiscard]] const char* name_of(Boundary boundary);
[[nodiscard]] const char* name_of(Weights weights);
[[nodiscard]] Result<Scheme> scheme_named(std::string_view name);
[[nodiscard]] Result<Boundary> boundary_named(std::string_view name);
[[nodiscard]] Result<Weights> weights_named(std::string_view name);

/// Makes what the mesh records of its rules ("scheme", "boundary" and, unless they are averaging,
/// "weights") agree with these, as control meshes have it.
void annotate(Mesh& mesh, const Rules& rules);

/// Takes away what says that the mesh is a control mesh: its rules, and that it was refined once.
void forget_rules(Mesh& mesh);

/// Every scheme, in the order of the enumeration.
[[nodiscard]] std::vector<Scheme> all_schemes();

/// Loop if every face is a triangle, else Catmull-Clark.
[[nodiscard]] Scheme suggested_scheme(const Mesh& mesh);

/// Vertices that each face must have; 0 for any number.
[[nodiscard]] Index face_size(Scheme scheme);

/// #V limit positions of the control vertices. Isolated vertices are their own limit. O(#corners).
/// Fails where Topology::build does, or if the scheme does not take such faces.
[[nodiscard]] Result<std::vector<Point>> limit_positions(const Mesh& control, const Rules& rules,
                                                         const Context& context = {});

/// #V unit normals of the limit surface at the control vertices, on the side from which the faces
/// turn counterclockwise. On creases and at corners, where the surface has several tangent planes,
/// the normalised mean of their normals; (0,0,0) where the tangents are parallel or absent. At
/// corners whose sharp edges enclose more than two faces Loop's rules have no tangent plane; there
/// the normals of the control faces are averaged.
[[nodiscard]] Result<std::vector<Point>> limit_normals(const Mesh& control, const Rules& rules,
                                                       const Context& context = {});

/// The mesh after `levels` refinement steps (0 returns it unchanged). Vertices of the given mesh
/// come first and in order, then one per edge, then (Catmull-Clark) one per face. Vertex channels
/// are refined like positions, corner channels linearly; face sets, holes, creases and corners
/// (sharpness less one) are inherited. Doo-Sabin: new vertices are one per face corner, two per
/// boundary or sharp edge, and the given vertices that keep their place; corner channels are
/// refined by the face rule.
[[nodiscard]] Result<Mesh> refine(const Mesh& control, const Rules& rules, int levels,
                                  const Context& context = {});

/// The refined mesh moved onto the limit surface, with the limit normals in channel "normal", and
/// without hole faces. Vertices that only these use go with them, but for those of `control`, by
/// whose numbers a surface is compared; where `control` is annotated "refined" = "1" for
/// Catmull-Clark, only the given ones among these stay.
/// Doo-Sabin, from level 1: the dual of the refined mesh, whose vertices lie on the limit surface,
/// the given vertices' limits first and in order; without corner channels, face data and creases.
[[nodiscard]] Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                      const Context& context = {});

}  // namespace surpass

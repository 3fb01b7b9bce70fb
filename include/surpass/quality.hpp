// Is it true? Certificates recomputed from the control mesh, and distances between surfaces.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <span>
#include <string>
#include <vector>

namespace surpass {

/// Distances between given points and the limit points of a control mesh, vertex by vertex.
struct Certificate {
  double max = 0;       ///< relative to box_side
  double mean = 0;      ///< relative to box_side
  double box_side = 0;  ///< largest side of the given points' box (1 if that is 0)
  Index worst_vertex = 0;
  std::string evaluator;  ///< "surpass" or "OpenSubdiv 3.5.0"
  std::vector<std::string> notes = {};
};

/// Evaluates the limit of `control` anew, from its faces, and compares. The two must have as many
/// vertices. O(#corners).
[[nodiscard]] Result<Certificate> certify(const Mesh& control, std::span<const Point> given,
                                          const Rules& rules, const Context& context = {});

/// The distances themselves: compares #V limit points with as many given ones.
[[nodiscard]] Result<Certificate> compare_points(std::span<const Point> limit,
                                                 std::span<const Point> given,
                                                 std::string evaluator);

/// Distances from one surface to another, both as polygon meshes (polygons cut into triangles).
struct OneSided {
  double max = 0;        ///< largest distance found: a lower bound of the true one-sided distance
  double max_bound = 0;  ///< proven upper bound of it
  double mean = 0;       ///< area-weighted mean
  double rms = 0;
  Point at = {};  ///< a point of the first surface at distance max
};
struct Deviation {
  OneSided a_to_b;
  OneSided b_to_a;
  double hausdorff = 0;        ///< the larger of both
  double hausdorff_bound = 0;  ///< proven upper bound
  double box_side = 0;         ///< of the first surface
};

/// Hausdorff and mean distances in absolute units, triangle to triangle: triangles are split until
/// the bound is within `accuracy` of the value (relative to the box side of `a`), so that no spike
/// between vertices is missed. Errors: a mesh without faces.
[[nodiscard]] Result<Deviation> deviation(const Mesh& a, const Mesh& b, double accuracy = 1e-5,
                                          const Context& context = {});

}  // namespace surpass

// Is it true? Certificates recomputed from the control mesh, and distances between surfaces.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/requirements.hpp>
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
/// vertices; but where `control` is annotated "refined" = "1", as the control meshes of similarity
/// interpolation are, the given vertices are its first ones. O(#corners).
[[nodiscard]] Result<Certificate> certify(const Mesh& control, std::span<const Point> given,
                                          const Rules& rules, const Context& context = {});

/// The same, for any control mesh. On a refined mesh of Doo-Sabin surfaces no vertex stands for a
/// given one, and the function above fails; the faces of `given`, its creases and corners tell
/// which face each given vertex turned into (or which edge or vertex, where it has none), and these
/// have the limit points. Fails if the faces of `control` are not those that `given` refines to.
[[nodiscard]] Result<Certificate> certify(const Mesh& control, const Mesh& given,
                                          const Rules& rules, const Context& context = {});

/// What a control mesh does of what is required of it.
struct RequiredCertificate {
  Certificate vertices;                      ///< limits against `targets`
  std::vector<RequirementOutcome> outcomes;  ///< #requirements; `redundant` is not looked for
  /// #V of the given mesh: the given points, or those that requirements put in their place; where
  /// one is removed the limit itself, so that it is not compared.
  std::vector<Point> targets;
  std::size_t replaced = 0;  ///< given vertices with another place
  std::size_t removed = 0;
};

/// Evaluates the limit of `control` anew, at the vertices and at the places of the requirements, by
/// the law that SimilarityInterpolator::solve_required reports with. `control` is a mesh that
/// certify() takes; one that was not refined is, once, for its surface stays the same. Errors: as
/// certify(); those of solve_required for a requirement that says nothing possible, or that
/// contradicts another one by itself; `mismatch` where requirements are on faces and those of
/// `control` are not what the faces of `given` turn into; `not_converged` where there is no
/// tangent plane, for equations do not see that.
[[nodiscard]] Result<RequiredCertificate> certify_required(
    const Mesh& control, const Mesh& given, const Rules& rules,
    std::span<const Requirement> requirements, const Context& context = {});

/// Whether a control mesh can be compared with so many given points, and how many of its vertices
/// are not theirs: as certify() has it.
[[nodiscard]] Result<void> check_vertex_counts(const Mesh& control, std::size_t given);

/// The distances themselves: compares #V limit points with as many given ones.
[[nodiscard]] Result<Certificate> compare_points(std::span<const Point> limit,
                                                 std::span<const Point> given,
                                                 std::string evaluator);

/// The same distances relative to another side, as where what was compared is a part of what was
/// given; to 1 if it is 0.
[[nodiscard]] Certificate relative_to(double side, Certificate certificate);

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
/// between vertices is missed. Bounds are proven up to rounding, about 1e-15 of the common box, and
/// 1e-8 of a triangle's size where that is thinner than 1e-8 of its length. After some 4 million
/// pieces splitting stops; then the bound is wider than asked, but still a bound.
///
/// Mean and rms are integrated over the pieces that are left, none longer than 1/64 of the common
/// box's side unless its distance is below the accuracy anyway, by a rule on their corners and
/// centres: exact where the distance (its square) is a quadratic function. Nowhere can the error in
/// a piece exceed its length or its upper bound.
///
/// Cost: a search, O(log #F) usually, for each of the pieces; the more the surfaces cross each
/// other at distances below the largest, the more pieces. Errors: a mesh without faces, faces with
/// fewer than three vertices or with vertices that do not exist, coordinates that are not finite,
/// an accuracy that is not positive, cancelled.
[[nodiscard]] Result<Deviation> deviation(const Mesh& a, const Mesh& b, double accuracy = 1e-5,
                                          const Context& context = {});

/// Distances of points to a surface, in the units of the points.
struct PointDistances {
  double max = 0;
  double mean = 0;
  double rms = 0;
  double percentile99 = 0;
  std::size_t count = 0;  ///< points that are finite; others do not count
  Index farthest = 0;     ///< a point at distance max
};

/// Distance of every point to the nearest triangle of the mesh (polygons are cut into triangles).
/// O(#points log #F) usually. Errors: no faces, a vertex that does not exist or is not finite, no
/// finite point, cancelled.
[[nodiscard]] Result<PointDistances> point_distances(std::span<const Point> points,
                                                     const Mesh& surface,
                                                     const Context& context = {});

/// The same, one by one: #points, NaN for points that are not finite.
[[nodiscard]] Result<std::vector<double>> distances_to(std::span<const Point> points,
                                                       const Mesh& surface,
                                                       const Context& context = {});

/// What point_distances says of them. NaN does not count.
[[nodiscard]] PointDistances summary_of(std::span<const double> distances);

}  // namespace surpass

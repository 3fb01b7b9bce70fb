// The limit surface anywhere: positions, derivatives, normals, and the weights that make them.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace surpass {

/// A place on the surface, by a face of the control mesh and parameters u, v in [0, 1].
///
/// Without `corner` the face must be a quad: its corners 0, 1, 2, 3 are at (0,0), (1,0), (1,1) and
/// (0,1), as in OpenSubdiv. With `corner` the place lies in the quarter of the face that belongs to
/// that corner (0 .. number of vertices - 1): (0,0) is the corner's vertex, (1,0) the middle of the
/// edge that leaves it, (1,1) the face's centre, (0,1) the middle of the edge before. Faces of
/// other than four vertices need it.
struct SurfacePlace {
  Index face = 0;
  double u = 0;
  double v = 0;
  Index corner = kNone;
  bool operator==(const SurfacePlace&) const = default;
};

/// What the surface is at a place; derivatives are by the parameters of the place.
///
/// Where the surface has one plane but no parametrisation that is smooth - at vertices of valence
/// other than 4, and others that stay irregular however often the mesh is refined - the derivatives
/// of its patches shrink to zero or grow without bound. There `du` and `dv` are the limits of their
/// directions, with the length that makes them the derivatives for valence 4: the tangents T of
/// Halstead, Kass and DeRose 1993 over the first refinement with quads alone and no fading
/// sharpness around the vertex. Along a sharp edge they are the derivative of its curve, a cubic
/// B-spline. They are (0,0,0) where the edge of the face has no tangent of its own: between sharp
/// edges that enclose three faces or more, at darts, at sharp vertices without sharp edges, and at
/// valence 2.
struct SurfaceSample {
  Point position = {};
  Point du = {};
  Point dv = {};
  /// Unit length, on the side from which the faces turn counterclockwise; at sharp edges that of
  /// this face's side. (0,0,0) where the tangents in the plane (SurfaceStencil::tangent_u) are
  /// parallel or vanish; where only du and dv are absent there is a normal all the same. At corners
  /// whose sharp edges enclose more than two faces there is no tangent plane; the control face's
  /// stands in. Nor is there one at interior vertices of valence 2: normals nearby have no limit,
  /// but swing to one side and the other with each halving of the distance. What stands in is the
  /// plane that they swing about, of the modes along the edges and across them.
  Point normal = {};
  struct Second {
    Point uu = {};
    Point uv = {};
    Point vv = {};
  };
  /// Absent at vertices that stay irregular: there they do not exist.
  std::optional<Second> second = {};
};

/// The same as weights of control points: a sample is linear in them but for the normal. The
/// weights of the position add up to 1, those of the derivatives to 0.
struct SurfaceStencil {
  std::vector<Index> columns;  ///< control vertices, each once
  /// A weight per column. `du` and `dv` are empty where SurfaceSample has (0,0,0), the second
  /// derivatives where it has none.
  std::vector<double> position, du, dv, duu, duv, dvv;
  /// Two directions in the tangent plane that, crossed in this order, give the normal: du and dv
  /// wherever they serve. Lengths have no meaning.
  std::vector<double> tangent_u, tangent_v;
  /// Whether they span the plane that the surface has there, on this face's side. If not they are
  /// stand-ins, so that there is a normal to shade with; see SurfaceSample::normal.
  bool has_plane = true;
};

/// The sample that a stencil makes of control points, from differences to one of them: the surface
/// loses no digits far from the origin. O(#columns).
[[nodiscard]] SurfaceSample sample(const SurfaceStencil& stencil, std::span<const Point> control);

/// The limit surface of a control mesh, ready to be evaluated. Immutable, and may be shared by
/// threads; copies share their contents. For Catmull-Clark surfaces, any faces, with boundaries,
/// creases, corners, darts and semi-sharp edges, also on hole faces.
///
/// Method: the faces around a place are refined by the surface's own rules until it lies in a patch
/// that is a bicubic B-spline, by rules of boundaries where it meets sharp edges. Exact: nothing is
/// approximated near irregular vertices, at any distance from them; at them, limit and tangent
/// masks. Rounding: positions and first derivatives carry a few units in the last place for every
/// refinement; in second derivatives those of the first, divided by the distance to the vertex.
///
/// Cost: setting up is O(#corners). A place takes a few microseconds; the first one on a face takes
/// some tens more, about 50 for each refinement among irregular neighbours. After two or three
/// (ten, where sharpness fades) the neighbourhood repeats itself, and halving the distance to an
/// irregular vertex costs less than a microsecond.
class LimitSurface {
 public:
  /// Copies the control mesh. Fails where Topology::build does, if the scheme does not take such
  /// faces or creases, and with `invalid_argument` for schemes that are not evaluated between their
  /// vertices (Loop, Doo-Sabin).
  static Result<LimitSurface> create(const Mesh& control, const Rules& rules,
                                     const Context& context = {});

  /// Fails with `invalid_argument` if the place is not one: no such face or corner, a parameter
  /// outside [0, 1], or no corner in a face of other than four vertices.
  [[nodiscard]] Result<SurfaceSample> evaluate(const SurfacePlace& place) const;
  [[nodiscard]] Result<SurfaceStencil> stencil(const SurfacePlace& place) const;

  /// A sample per place, on all threads, with the same bits for any number of them. Faster than one
  /// by one where places of a face follow each other: they share its refinements. The error is that
  /// of the first place that has one.
  [[nodiscard]] Result<std::vector<SurfaceSample>> evaluate(std::span<const SurfacePlace> places,
                                                            const Context& context = {}) const;
  [[nodiscard]] Result<std::vector<SurfaceStencil>> stencils(std::span<const SurfacePlace> places,
                                                             const Context& context = {}) const;

  [[nodiscard]] const Mesh& control() const;

 private:
  struct Contents;
  explicit LimitSurface(std::shared_ptr<const Contents> contents)
      : contents_(std::move(contents)) {}

  std::shared_ptr<const Contents> contents_;
};

}  // namespace surpass

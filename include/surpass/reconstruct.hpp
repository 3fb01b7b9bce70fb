// From unorganised points to a triangle mesh that interpolation can use. Optional component, target
// surpass::reconstruct; programs that link it are under the GPL, because CGAL's parts are.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/quality.hpp>
#include <surpass/scheme.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace surpass {

/// Whether a step is taken: where measurements of the points call for it, always, or never.
enum class Choice { automatic, on, off };

/// Which boundary loops are filled.
enum class Closing {
  all,
  small,  ///< up to 30 edges, and no more than the square root of twice its piece's vertices
  none,
};

/// Where the vertices of the mesh are, if the points were smoothed to find it.
enum class Positions {
  automatic,  ///< original while the noise is below 0.3 spacings, else smoothed
  original,   ///< vertices are input points, bit for bit
  smoothed,
};

/// "auto", "on", "off"; "all", "small", "none"; "auto", "original", "smoothed".
[[nodiscard]] const char* name_of(Choice choice);
[[nodiscard]] const char* name_of(Closing closing);
[[nodiscard]] const char* name_of(Positions positions);

/// Lengths in `spacing`s are multiples of the median over the points of the mean distance to their
/// six nearest neighbours.
struct ReconstructOptions {
  Choice outliers = Choice::automatic;  ///< leave out points that stand alone
  /// Smooth the points before they are connected. Automatic: if they scatter by more than 0.15
  /// spacings, and unless that leaves more boundary loops or unused points than there are without.
  Choice smoothing = Choice::automatic;
  Positions positions = Positions::automatic;
  Closing close = Closing::small;
  /// Largest perimeter of a triangle in spacings; 0 is no bound, and the default is 8 where
  /// outliers were found, else no bound.
  std::optional<double> perimeter = {};
  /// Simplify: no input point that was used may be further from the mesh than this, relative to
  /// the largest side of the points' bounding box. Checked point by point, so it always holds.
  std::optional<double> tolerance = {};
  /// Simplify to this many vertices, or to as few as the guards allow. With a tolerance, whichever
  /// is reached first.
  std::optional<Index> vertices = {};
  /// Edges at which the normals of the two faces differ by more than this many degrees become
  /// creases, and vertices where creases meet or turn become corners.
  std::optional<double> feature_angle = {};
};

/// What was found and done. Distances are relative to `box_side`.
struct ReconstructReport {
  std::size_t points = 0;      ///< given
  std::size_t not_finite = 0;  ///< dropped
  std::size_t duplicates = 0;  ///< dropped
  std::size_t outliers = 0;    ///< left out
  std::size_t unused = 0;      ///< finite points at whose place the full mesh has no vertex
  double box_side = 0;         ///< largest side of the finite points' box
  double spacing = 0;          ///< relative to box_side
  /// Scatter about the surface: standard deviation from a local quadric, median, in spacings.
  /// Absent for clouds of fewer than 180 points, where it cannot be told from curvature.
  std::optional<double> noise = {};
  /// Median distance of nearby parallel sheets in spacings, where there are such; else absent, as
  /// for clouds of fewer than 180 points.
  std::optional<double> sheet_gap = {};
  unsigned smoothing_passes = 0;
  bool smoothed_positions = false;  ///< vertices are not input points
  double perimeter = 0;             ///< bound that was applied, in spacings; 0 where none
  std::size_t dropped_pieces = 0;   ///< too small to be kept
  std::size_t filled_loops = 0;
  std::size_t open_loops = 0;  ///< boundary loops left
  std::size_t pieces = 0;      ///< connected components of the mesh
  /// Handles of all pieces together, their boundary loops thought closed; absent where a vertex
  /// joins several fans of faces.
  std::optional<std::size_t> genus = {};
  std::size_t full_vertices = 0;  ///< before simplification
  std::size_t creases = 0;
  std::size_t corners = 0;
  double polyhedron_max = 0;  ///< largest distance of a used point from the mesh
  double polyhedron_rms = 0;
  std::vector<std::string> warnings = {};
};

struct Reconstruction {
  Mesh mesh;                  ///< triangles, oriented; closed pieces outward
  std::vector<Index> source;  ///< #V: the input point of each vertex
  std::vector<Index> unused;  ///< input points that the full mesh does not use, ascending
  ReconstructReport report;
};

/// Cleans the points, connects them by CGAL's advancing front (D. Cohen-Steiner, F. Da, A greedy
/// Delaunay-based surface reconstruction algorithm, The Visual Computer 20, 2004), fills holes,
/// orients and simplifies. Channels (#points rows) are carried to the vertices, but for those with
/// numbers that are not finite at finite points: a warning names them. The result does not depend
/// on the number of threads.
///
/// Linear in practice; about 2.4 kB a point at the peak. Errors: fewer than four different finite
/// points, points on one line (`unsuitable_for_scheme`), coordinates so large that their box
/// overflows, options out of range, too little memory (`too_large`), cancelled.
[[nodiscard]] Result<Reconstruction> reconstruct(std::span<const Point> points,
                                                 std::span<const Channel> channels = {},
                                                 const ReconstructOptions& options = {},
                                                 const Context& context = {});

/// How far given points are from the limit surface of a control mesh.
struct LimitDistances {
  PointDistances all;   ///< of every finite point
  PointDistances used;  ///< of those that are not listed as unused
  int levels = 0;       ///< refinement of the surface that they were measured to
  /// Estimate of how far that surface is from the limit, by the difference to the level before;
  /// absent at level 0, where the mesh was too large to be refined.
  std::optional<double> sampling = {};
};

/// Points that are vertices (`source`, #V numbers into `points`; or empty) are measured to their
/// vertex's limit point, exactly. All others to the control mesh refined and moved to the limit,
/// three times or until it would have more than 800,000 triangles. `unused` is ascending. In the
/// units of the points. Errors: those of limit_mesh and point_distances.
[[nodiscard]] Result<LimitDistances> limit_distances(std::span<const Point> points,
                                                     std::span<const Index> source,
                                                     std::span<const Index> unused,
                                                     const Mesh& control, const Rules& rules,
                                                     const Context& context = {});

}  // namespace surpass

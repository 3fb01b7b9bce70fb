// Non-uniform, non-stationary Loop subdivision: interpolates the given vertices without another
// control mesh, by the choice of its parameters.
//
// Zhang, Zheng, Chen, Interpolating triangular meshes using a non-uniform, non-stationary Loop
// subdivision, Mathematics 13(17), 2025. The text that we have has lost its formulas: which of
// these follow from it and which are our choice says docs/methods/nonstationary-loop.md.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace surpass {

/// Part of the vertex rule that goes to the ring when the parameter is 1.
enum class LoopWeights {
  warren,   ///< 3/8, and 9/16 for valence 3
  classic,  ///< Loop 1987: 5/8 - (3/8 + cos(2 pi / n) / 4)^2
};

/// How parameters go on from level to level; both tend to 1, which is plain Loop subdivision.
enum class ParameterIteration {
  geometric,    ///< v <- 1 + (v - 1) / rate, the one that interpolates
  exponential,  ///< v <- sqrt((1 + v) / 2), the paper's Remark 3: it cannot; for comparison
};

enum class NonstationaryRule {
  interpolating,  ///< the paper's: vertices of each valence have a parameter that is solved for
  uniform,        ///< one parameter for all; approximates (1 is plain Loop subdivision)
  mean,           ///< as interpolating, but an edge has the mean of its ends' parameters; for
                  ///< comparison (the paper's Table 1), closed meshes without creases only
  quadratic,      ///< ours: no parameter; on regular lattices it reproduces quadratic functions
};

[[nodiscard]] const char* name_of(LoopWeights weights);
[[nodiscard]] const char* name_of(ParameterIteration iteration);
[[nodiscard]] const char* name_of(NonstationaryRule rule);

/// The rate of the geometric iteration. It must exceed 4 for tangent planes at vertices of valence
/// 3; 1/16 is the smallest eigenvalue of Loop's rules, so the parameters settle as fast as these
/// do.
inline constexpr double kParameterRate = 16;

/// Shape parameters: the default, the most negative round value for which no quadratic surface
/// comes out worse than its flat triangles; and the range that is allowed, which is smaller where
/// an interior vertex has valence 3.
inline constexpr double kDefaultShape = -1.5;
inline constexpr double kRoundShape = -3;
inline constexpr double kFlatShape = 0;
inline constexpr double kLowestShape = -3.99;
inline constexpr double kHighestShape = 3.99;
inline constexpr double kHighestShapeAtValence3 = 1.99;

/// The surface shall pass through (1 - along) p + along c, where p is the vertex and c the centroid
/// of its neighbours: 0 is the vertex itself. Below 1/2 + shape / 8.
struct LineTarget {
  Index vertex = 0;
  double along = 0;
};

struct NonstationaryOptions {
  NonstationaryRule rule = NonstationaryRule::interpolating;
  /// First parameter of edges; of everything under NonstationaryRule::uniform. Falling values make
  /// the surface rounder. Values outside of the allowed range are moved to its end, with a note.
  double shape = kDefaultShape;
  LoopWeights weights = LoopWeights::warren;
  /// edge_only or edge_and_corner. Curves of an interpolating surface pass through their vertices,
  /// too, and depend on these alone.
  Boundary boundary = Boundary::edge_and_corner;
  /// Vertices where the smooth curve would turn the surface over, so that its normal is on the
  /// other side than its faces' area, become corners, with a note. Without it a curve depends on
  /// its own vertices alone: two patches with the same boundary polygon stay together everywhere.
  bool corners_at_folds = true;
  /// The refined mesh after exactly so many steps contains the given vertices; 0: the limit does.
  int steps = 0;
  /// At most one for a vertex; interior vertices only.
  std::vector<LineTarget> targets = {};
  ParameterIteration iteration = ParameterIteration::geometric;
  double rate = kParameterRate;  ///< above 1; infinity: plain Loop after the first step
  /// First parameters of the vertices (#V) in the place of those that interpolate; empty: solve.
  std::vector<double> vertex_parameters = {};
};

/// Share of the ring's centroid in a vertex after `steps` (0: in the limit), as a function of its
/// first parameter: lambda in (1 - lambda) p + lambda c. Valence 3 or more. O(20).
[[nodiscard]] double centroid_share(double vertex_parameter, Index valence,
                                    const NonstationaryOptions& options);

/// The first parameter with centroid_share `along`: safeguarded Newton's iteration in a proven
/// bracket, to rounding; unique for shapes in (-4, 4) and `along` below 1/2 + shape / 8.
/// Errors (invalid_argument): outside of these, valence below 3, the exponential iteration, or
/// `along` 0 asked of a rule that does not solve.
[[nodiscard]] Result<double> interpolating_parameter(Index valence,
                                                     const NonstationaryOptions& options,
                                                     double along = 0);

/// The allowed shapes for a mesh with an interior vertex of valence 3, or without.
[[nodiscard]] std::pair<double, double> shape_range(bool valence_3);

/// A mesh that refines itself step by step.
///
///     auto surface = NonstationaryLoop::create(mesh, {.shape = -2, .steps = 5});
///     for (int level = 0; level < 5; ++level) surface->refine();
///     // surface->mesh() begins with the vertices of mesh, to rounding
///
/// Triangles only. Creases and corners must be infinitely sharp; creases have the rules of
/// boundaries and may not end inside of the surface. The same bits for any number of threads.
/// Movable; const functions may be called from several threads.
class NonstationaryLoop {
 public:
  /// Checks the mesh and solves for the parameters: one scalar equation a valence and target; then
  /// looks for folds at curves, in O(#corners) for each time that some are found.
  /// Errors: as Topology::build; unsuitable_for_scheme, naming a face that is no triangle, an
  /// interior vertex of valence below 3, a semi-sharp crease or corner, or the end of a crease;
  /// invalid_argument for options out of range, a boundary rule that there is not, a target that
  /// cannot be reached or is on a curve.
  [[nodiscard]] static Result<NonstationaryLoop> create(const Mesh& control,
                                                        const NonstationaryOptions& options = {},
                                                        const Context& context = {});
  NonstationaryLoop(const NonstationaryLoop&) = delete;
  NonstationaryLoop& operator=(const NonstationaryLoop&) = delete;
  NonstationaryLoop(NonstationaryLoop&&) noexcept;
  NonstationaryLoop& operator=(NonstationaryLoop&&) noexcept;
  ~NonstationaryLoop();

  /// One more step: four faces of each; the vertices stay first and in order, then one an edge.
  /// Channels, creases and all else as surpass::refine. O(#corners). Errors: too_large, cancelled;
  /// the mesh stays as it was.
  Result<void> refine(const Context& context = {});

  [[nodiscard]] int level() const;
  [[nodiscard]] const Mesh& mesh() const;

  /// Limits of all vertices of mesh(), in closed form at every level.
  [[nodiscard]] Result<std::vector<Point>> limit_positions(const Context& context = {}) const;

  /// Unit normals of the limit surface there; as surpass::limit_normals at curves and where there
  /// is none.
  [[nodiscard]] Result<std::vector<Point>> limit_normals(const Context& context = {}) const;

  /// mesh() moved onto the limit surface, with channel "normal" and without hole faces.
  [[nodiscard]] Result<Mesh> limit_mesh(const Context& context = {}) const;

  /// The shape as taken, in the allowed range.
  [[nodiscard]] double shape() const;
  /// First parameters of the given vertices; those of curves say nothing.
  [[nodiscard]] std::span<const double> vertex_parameters() const;
  /// What the user should know: a shape that was moved, vertices that became corners.
  [[nodiscard]] const std::vector<std::string>& notes() const;
  /// The points that the surface shall pass through: the given vertices, and their targets.
  [[nodiscard]] const std::vector<Point>& aims() const;

  struct Impl;
  [[nodiscard]] const Impl& impl() const { return *impl_; }

 private:
  explicit NonstationaryLoop(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace surpass

// Interpolation with freedom: the control mesh is the given one refined once, its new vertices are
// free, and they are chosen so that the surface resembles another one, or is fair.
#pragma once

#include <surpass/interpolate.hpp>
#include <surpass/requirements.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace surpass {

/// What the freedom is spent on. Sums run over the derivatives sampled on every patch; g is a
/// derivative of the reference surface, q the same derivative of the surface looked for.
enum class Similarity {
  vectors,     ///< sum |q - g|^2: derivatives alike in direction and length
  directions,  ///< sum w |g x q|^2: alike in direction (Lai and Cheng 2006)
  fair,        ///< sum over w |q|^2: thin plate and membrane (Halstead, Kass, DeRose 1993)
};

/// The weight w of a derivative under Similarity::directions.
enum class RowWeights {
  none,         ///< 1 (the paper)
  unit,         ///< 1 / |g|^2; 0 where |g|^2 is below 1e-24 of its mean over first derivatives
  order,        ///< 1 / the mean of |g|^2 over the derivatives of the same order
  regularised,  ///< 1 / (|g|^2 + 0.09 times the mean of |g|^2 over first derivatives)
};

/// How the refined given mesh becomes the reference: stretched, about the centre of its box, until
/// the box of the limits of the given vertices is the box of the given vertices. Never by more than
/// the factor 8; a side of length 0 stays.
enum class Scaling {
  none,
  per_axis,   ///< (the paper)
  isotropic,  ///< by the geometric mean of the three factors
};

/// What happens at the boundary of an open mesh.
enum class OpenMeshes {
  boundary_rules,  ///< the rules of the options
  /// A ring of dummy faces goes around (the paper): quads outside the boundary edges, with vertices
  /// of their own that start at the boundary's and are free. The boundary curve obeys no rule, and
  /// the surface need not lie straight across it: better where tangents or normals are required
  /// there. Of the two rings of faces that refinement makes of them the inner one stays in the
  /// control mesh, as hole faces behind those of the surface.
  dummy_ring,
};

/// How the linear system of the free vertices is solved.
enum class SimilaritySolver {
  conjugate_gradient,  ///< preconditioned by the diagonal (3 x 3 blocks for directions);
                       ///< matrix-free
  gauss_seidel,  ///< (the paper) on one thread, with the assembled matrix: several kilobytes a
                 ///< vertex of the control mesh
};

[[nodiscard]] const char* name_of(Similarity similarity);
[[nodiscard]] const char* name_of(RowWeights weights);
[[nodiscard]] const char* name_of(Scaling scaling);
[[nodiscard]] const char* name_of(OpenMeshes open);
[[nodiscard]] const char* name_of(SimilaritySolver solver);
[[nodiscard]] Result<Similarity> similarity_named(std::string_view name);
[[nodiscard]] Result<RowWeights> row_weights_named(std::string_view name);
[[nodiscard]] Result<Scaling> scaling_named(std::string_view name);
[[nodiscard]] Result<OpenMeshes> open_meshes_named(std::string_view name);
[[nodiscard]] Result<SimilaritySolver> similarity_solver_named(std::string_view name);

struct SimilarityOptions {
  Rules rules = {.scheme = Scheme::catmull_clark};
  Similarity similarity = Similarity::vectors;
  RowWeights row_weights = RowWeights::regularised;
  Scaling scaling = Scaling::per_axis;
  OpenMeshes open = OpenMeshes::boundary_rules;  ///< dummy_ring: Catmull-Clark only
  /// Samples along the side of a patch: 2^k + 1 for a k from 1 to 4; the paper has 3.
  unsigned samples = 3;
  /// Weights of |Suu|^2 + 2 |Suv|^2 + |Svv|^2 and of |Su|^2 + |Sv|^2 under Similarity::fair.
  double thin_plate = 1;
  double membrane = 0;
  SimilaritySolver solver = SimilaritySolver::conjugate_gradient;
  /// The iteration ends when the residual of the linear system is this part of the residual at its
  /// start, the reference. The surface interpolates however large it is.
  double solver_tolerance = 1e-2;
  unsigned max_iterations = 10000;
  /// Largest distance allowed between a given point and its limit point, as in InterpolateOptions.
  double tolerance = 1e-9;
};

struct SimilarityReport {
  /// As for progressive interpolation. `iterations` counts the solver's; `initial` and `final` are
  /// interpolation errors of the reference and of the result.
  SolveReport solve;
  bool solver_converged = false;  ///< the residual reached the solver's tolerance
  double residual = 0;            ///< at the end, relative to that of the reference; 0 if both are
  std::vector<double> residuals = {};                 ///< relative, from the first iteration on
  std::array<double, 3> scale = {};                   ///< of the reference, for each axis
  std::size_t free_vertices = 0;                      ///< of the control mesh
  std::size_t derivatives = 0;                        ///< sampled, all patches together
  std::vector<RequirementOutcome> requirements = {};  ///< of `solve_required`, in its order
};

struct SimilaritySolution {
  std::vector<Point> points;  ///< of the refined mesh, the given vertices' first but on Doo-Sabin
  std::vector<Channel> channels;  ///< the given channels, interpolated along
  SimilarityReport report;
  /// By solve_required, #given: what the limits of the given vertices are to be. The given points,
  /// or those that requirements put in their place; where one was removed, the limit itself.
  std::vector<Point> targets = {};
};

/// Interpolation prepared for one topology: many point sets, one set-up.
///
///     auto solver = SimilarityInterpolator::create(mesh, options);
///     Mesh control = solver->refined();
///     for (const auto& frame : frames) control.points = solver->solve(frame)->points;
///
/// The limit point of every given vertex is a weighted mean of control points, with one among them
/// that is in no other vertex's mean. It is expressed by the others, so that whatever these are the
/// surface interpolates, to rounding: there is no mesh that cannot be interpolated, and no
/// iteration that must converge. (On Doo-Sabin surfaces vertices of two faces share theirs with
/// their neighbours, and are solved for together.) Movable, immutable after creation; `solve` may
/// be called from several threads.
///
/// Sources: Lai and Cheng, Similarity based interpolation using Catmull-Clark subdivision surfaces,
/// 2006 (`directions`; its weights, its norm of the residual and its derivatives at extraordinary
/// vertices are unstated, see docs/methods/similarity.md for what is done); `vectors` is ours;
/// `fair` samples the energies of Halstead, Kass and DeRose, Efficient, fair interpolation using
/// Catmull-Clark surfaces, 1993, with exact interpolation.
class SimilarityInterpolator {
 public:
  /// Fails where Topology::build does, where the scheme does not take such faces or creases,
  /// with `singular` where limits share all their control points, on numbers out of range, or if
  /// the refined mesh would be too large. Cost: about a refinement, and a hundred bytes a face of
  /// the refined mesh.
  [[nodiscard]] static Result<SimilarityInterpolator> create(const Mesh& mesh,
                                                             const SimilarityOptions& options = {},
                                                             const Context& context = {});
  SimilarityInterpolator(const SimilarityInterpolator&) = delete;
  SimilarityInterpolator& operator=(const SimilarityInterpolator&) = delete;
  SimilarityInterpolator(SimilarityInterpolator&&) noexcept;
  SimilarityInterpolator& operator=(SimilarityInterpolator&&) noexcept;
  ~SimilarityInterpolator();

  /// The topology of the control mesh: the given mesh refined once, without positions and vertex
  /// channels, annotated with its rules and with "refined" = "1". The given vertices come first;
  /// on Doo-Sabin surfaces faces stand for them, see certify().
  [[nodiscard]] const Mesh& refined() const;

  /// Control points whose limit surface goes through these points (#V of the given mesh). Vertex
  /// channels are interpolated along under the vectors form, or the fair one if that is chosen.
  /// Errors: wrong size, not finite, cancelled.
  [[nodiscard]] Result<SimilaritySolution> solve(std::span<const Point> points,
                                                 std::span<const Channel> channels = {},
                                                 const Context& context = {}) const;

  /// The same with a reference of one's own: control points of the given mesh (#V), which are
  /// refined, or of the refined one, which are taken as they are; scaled as the options say.
  [[nodiscard]] Result<SimilaritySolution> solve_like(std::span<const Point> reference,
                                                      std::span<const Point> points,
                                                      std::span<const Channel> channels = {},
                                                      const Context& context = {}) const;

  /// The same with further requirements, at the vertices and at places of the given mesh. They are
  /// met exactly, as the given vertices are, however far the iteration comes; what follows from the
  /// others is dropped and reported. `reference` may be empty: the given points.
  /// Errors: `invalid_argument` for a requirement that says nothing possible, `contradictory` for
  /// those that contradict each other, the given vertices or what such a surface can do there,
  /// `not_finite` for numbers too large to compute with, all naming them. All but moved and removed
  /// vertices need a scheme that LimitSurface evaluates. Not converged: one is missed by more than
  /// kRequirementTolerance. Method: what the equations forbid is projected out of the gradient in
  /// each iteration, by a sparse Cholesky decomposition of their products, whose pivots also tell
  /// whether some depend on the rest. Lai and Cheng 2006, section 3, choose a vertex to eliminate
  /// for each requirement.
  [[nodiscard]] Result<SimilaritySolution> solve_required(std::span<const Requirement> requirements,
                                                          std::span<const Point> points,
                                                          std::span<const Point> reference = {},
                                                          std::span<const Channel> channels = {},
                                                          const Context& context = {}) const;

  /// What the surface is made to resemble, as a control mesh: points for the topology of
  /// `refined()`, stretched as the options say. With the same arguments, `solve`, `solve_like` and
  /// `solve_required` measure by it, start from it, and after no iterations leave all but the given
  /// vertices, and what requirements move, there. `own` as solve_like's reference; empty: the given
  /// points. Errors: those of solve_like, and of solve_required for requirements that say nothing
  /// possible or contradict each other before anything is solved.
  [[nodiscard]] Result<std::vector<Point>> reference(std::span<const Point> points,
                                                     std::span<const Point> own = {},
                                                     std::span<const Requirement> requirements = {},
                                                     const Context& context = {}) const;

  /// Limit points of the given vertices (#V), from control points of the refined mesh: what a
  /// certificate needs. Error: wrong size.
  [[nodiscard]] Result<std::vector<Point>> limit_positions(std::span<const Point> control,
                                                           const Context& context = {}) const;

  struct Impl;

 private:
  explicit SimilarityInterpolator(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

/// A control mesh with the topology of the given mesh refined once, and how it was found.
struct SimilarityInterpolated {
  Mesh control;
  SimilarityReport report;
};

/// One-shot form of SimilarityInterpolator.
[[nodiscard]] Result<SimilarityInterpolated> interpolate_similar(
    const Mesh& mesh, const SimilarityOptions& options = {}, const Context& context = {});

/// The same with further requirements, as SimilarityInterpolator::solve_required has them.
[[nodiscard]] Result<SimilarityInterpolated> interpolate_required(
    const Mesh& mesh, std::span<const Requirement> requirements,
    const SimilarityOptions& options = {}, const Context& context = {});

}  // namespace surpass

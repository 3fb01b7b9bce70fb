// Progressive interpolation: the control mesh whose limit surface passes through given points.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace surpass {

/// How L x = v is solved; L takes control points to limit points.
enum class Solver {
  automatic,   ///< by what is proven of the mesh's operator (the default): chebyshev where a
               ///< bound is, conjugate_gradient (in large blocks after a try of chebyshev) or
               ///< minimal_residual where only symmetry is,
               ///< chebyshev or bicgstab with darts and semi-sharp creases
  chebyshev,   ///< Chebyshev acceleration of the paper's iteration
  richardson,  ///< the paper's iteration, x <- x + (v - L x)
  conjugate_gradient,  ///< in the inner product that makes L symmetric; not with darts or
                       ///< semi-sharp creases, nor where eigenvalues may be negative
  gauss_seidel,        ///< in vertex order, on one thread
  minimal_residual,    ///< MINRES, in the same inner product; eigenvalues may have any sign
  bicgstab,            ///< for any operator
};
[[nodiscard]] const char* name_of(Solver solver);
[[nodiscard]] Result<Solver> solver_named(std::string_view name);

struct InterpolateOptions {
  Rules rules = {};
  Solver solver = Solver::automatic;
  /// Largest distance allowed between a given point and its limit point, relative to the largest
  /// side of the points' bounding box. Never taken below 4 units in the last place of the largest
  /// coordinate. Channels use their own range in the place of the box side.
  double tolerance = 1e-9;
  /// Evaluations of the limit operator that one block of unknowns may take.
  unsigned max_iterations = 10000;
  /// Do exactly the number of sweeps that the a-priori bound asks for, without testing in between
  /// (the paper, end of section 2). Richardson and Chebyshev, on meshes for which a bound is
  /// proven.
  bool direct = false;
  /// Keep every iteration in the history, for any solver; Richardson always does. Chebyshev then
  /// tests after every sweep, and not only where it is likely to be done.
  bool full_history = false;
  /// Interpolate only these vertices and leave the others of the control mesh as given; empty: all.
  std::vector<Index> only = {};
  /// Leave these connected components (numbers as in find_components) of the control mesh as given.
  std::vector<Index> skip_components = {};
};

/// The tolerance as applied to these numbers: at least 4 units in the last place of the largest,
/// relative to `unit` (the box side, or a channel's range). No double can keep less.
[[nodiscard]] double floored_tolerance(double tolerance, std::span<const double> values,
                                       double unit);

/// Errors are distances relative to the box side.
struct Iteration {
  unsigned iteration = 0;  ///< evaluations of the limit so far in this block
  double max = 0;
  double mean = 0;
};

/// What the solver did. Open meshes and meshes with creases are solved in two stages, the curves
/// first (section 4 of the paper); closed smooth meshes in one.
struct SolveReport {
  bool converged = false;
  std::string solver = {};  ///< that solved the surface; several where components needed several
  double box_side = 0;      ///< largest side of the given points' box, the unit of all errors here
  double tolerance = 0;     ///< as applied, after the floor
  unsigned iterations = 0;  ///< evaluations of the limit in the surface block
  unsigned boundary_iterations = 0;  ///< evaluations in the curve block; 0 where there is none
  Iteration initial = {};            ///< error of the given points taken as control points
  Iteration final = {};
  std::vector<Iteration> history = {};           ///< surface block
  std::vector<Iteration> boundary_history = {};  ///< curve block
  std::vector<std::string> notes =
      {};  ///< what the user should know: a fallback taken, a bound missing
};

struct Solution {
  std::vector<Point> points;      ///< #V control points
  std::vector<Channel> channels;  ///< the mesh's channels, interpolated along
  SolveReport report;
};

/// A-priori number of sweeps (one more than that many evaluations reach the tolerance).
struct Prediction {
  double lowest_eigenvalue = 0;           ///< proven bound of the surface block's spectrum [lo, 1]
  double boundary_lowest_eigenvalue = 0;  ///< the same of the curve block
  unsigned sweeps = 0;
  unsigned boundary_sweeps = 0;
};

/// Interpolation prepared for one topology: many point sets, one set-up.
///
///     auto solver = Interpolator::create(mesh, options);
///     for (const auto& frame : frames) auto control = solver->solve(frame);
///
/// Movable, immutable after creation; `solve` may be called from several threads.
class Interpolator {
 public:
  /// Fails where Topology::build does, where the scheme does not take such faces, and if the
  /// options contradict the mesh (conjugate gradients on a dart, `only` out of range). Whether the
  /// operator is singular is decided here, numerically, on the components where it can be.
  [[nodiscard]] static Result<Interpolator> create(const Mesh& mesh,
                                                   const InterpolateOptions& options = {},
                                                   const Context& context = {});
  Interpolator(const Interpolator&) = delete;
  Interpolator& operator=(const Interpolator&) = delete;
  Interpolator(Interpolator&&) noexcept;
  Interpolator& operator=(Interpolator&&) noexcept;
  ~Interpolator();

  /// Control points for these limit points (#V). Not reaching the tolerance is no error: see
  /// `report.converged`. Errors: wrong size, not finite, cancelled, or singular: there are
  /// components that have no interpolating control mesh whatever the solver; the message names
  /// them. Where the operator is singular but the points are compatible with it, the solution
  /// nearest to them is taken, and a note says that it is not the only one.
  [[nodiscard]] Result<Solution> solve(std::span<const Point> points,
                                       std::span<const Channel> channels = {},
                                       const Context& context = {}) const;

  /// Limit points of any control points (#V) of this topology, one evaluation: what a certificate
  /// needs. It uses the plain rows, none of what makes `solve` fast. Error: wrong size.
  [[nodiscard]] Result<std::vector<Point>> limit_positions(std::span<const Point> points,
                                                           const Context& context = {}) const;

  /// The vertices that the surface shall pass through, ascending: what `only` and `skip_components`
  /// leave.
  [[nodiscard]] std::vector<Index> interpolated() const;

  /// The a-priori bound for these points, or an error that says why none is proven.
  [[nodiscard]] Result<Prediction> predict(std::span<const Point> points) const;

  struct Impl;

 private:
  explicit Interpolator(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

/// A control mesh and how it was found.
struct Interpolated {
  Mesh control;  ///< the given mesh with other positions and channels, annotated with its rules
  SolveReport report;
};

/// One-shot form of Interpolator.
[[nodiscard]] Result<Interpolated> interpolate(const Mesh& mesh,
                                               const InterpolateOptions& options = {},
                                               const Context& context = {});

}  // namespace surpass

// The iterations, one a file. Each starts from the target, as the paper does, and leaves its best
// point in x; values of x outside the block are known and stay.
#pragma once

#include "interpolate/monitor.hpp"

namespace surpass {

/// Coefficients of x_{k+1} = x_k + momentum (x_k - x_{k-1}) + step (v - L x_k).
class SemiIteration {
 public:
  /// The paper's progressive interpolation: momentum 0, step 1.
  static SemiIteration richardson() { return SemiIteration(); }
  /// Chebyshev's, for eigenvalues in [lowest, 1]; an eigenvalue below `lowest` only slows it down.
  static SemiIteration chebyshev(double lowest);
  /// The same with Chebyshev's polynomials of the second kind. They are large at the ends of the
  /// interval, where few eigenvalues are, and smaller than those of the first in between: on most
  /// meshes that saves a sweep, but less is proven of it.
  static SemiIteration chebyshev_of_second_kind(double lowest);

  [[nodiscard]] double momentum() const { return momentum_; }
  [[nodiscard]] double step() const { return step_; }
  /// By which a sweep brings errors down in the long run, if the interval holds all eigenvalues.
  [[nodiscard]] double reduction() const { return reduction_; }
  void advance();

 private:
  double momentum_ = 0;
  double step_ = 1;
  double reduction_ = 1;
  double half_width_ = 0;  // of the spectrum interval; 0 for Richardson
  double sigma_ = 0;
  double rho_ = 0;
};

/// Iterates until the monitor is content. One evaluation of the limit an iteration.
Verdict semi_iteration(const LinearSystem& system, SemiIteration coefficients, Monitor& monitor,
                       std::span<double> x);

/// Exactly `sweeps` sweeps, nothing measured in between. False if cancelled.
bool semi_iteration_blind(const LinearSystem& system, SemiIteration coefficients, unsigned sweeps,
                          std::span<double> x);

/// Conjugate gradients in the inner product of op.symmetric_weight, each right-hand side by itself.
/// The block must be symmetric. One evaluation an iteration.
Verdict conjugate_gradient(const LinearSystem& system, Monitor& monitor, std::span<double> x);

/// Gauss-Seidel in vertex order on the caller's thread. One evaluation a sweep.
Verdict gauss_seidel(const LinearSystem& system, Monitor& monitor, std::span<double> x);

/// MINRES in the inner product of op.symmetric_weight, for symmetric blocks whose eigenvalues may
/// have any sign. One evaluation an iteration.
Verdict minimal_residual(const LinearSystem& system, Monitor& monitor, std::span<double> x);

/// BiCGSTAB, for operators without symmetry. Two evaluations an iteration.
Verdict bicgstab(const LinearSystem& system, Monitor& monitor, std::span<double> x);

/// Sparse factorisation (LDL' of a symmetric block, else LU), then iterative refinement. Error
/// `singular`, naming a vertex, where an eigenvalue is zero to rounding.
Result<Verdict> direct_solve(const LinearSystem& system, Monitor& monitor, std::span<double> x);

}  // namespace surpass

// The linear system of the free control points: the energy's derivative by them shall vanish, while
// the dependent ones follow. Two solvers, a file each.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "interpolate/elimination.hpp"
#include "interpolate/patch_energy.hpp"

namespace surpass {

class LinearConstraints;
struct Preconditioned;

/// Arrays are #control points by width. A change of the control points is `extended` if its
/// dependent points keep the limits of the given vertices; a gradient is 0 at them.
struct FreeSystem {
  const Elimination& elimination;
  const PatchEnergy& energy;
  std::size_t width;
  const Context& context;
  /// Further equations that the change shall leave as they are, for width 3; or none.
  const LinearConstraints* constraints = nullptr;

  [[nodiscard]] std::size_t size() const { return elimination.control_count() * width; }
  /// y = the change of the energy's derivative by all control points that goes with the change x,
  /// which is extended first; that of the gradient is what Elimination::restricted makes of it.
  /// Back comes the product of the two.
  double product(Precision precision, std::span<double> x, std::span<double> y) const {
    elimination.meet(context, width, {}, x);
    return energy.product(context, width, precision, x, y);
  }
  [[nodiscard]] double dot(std::span<const double> a, std::span<const double> b) const {
    return parallel::reduce(
        context, a.size(), 0.0,
        [&](std::size_t begin, std::size_t end) {
          double sum = 0;
          for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
          return sum;
        },
        [](double sum, double part) { return sum + part; });
  }
};

struct StopAt {
  double tolerance = 0;  ///< of the gradient's length, relative to that at the start
  unsigned max_iterations = 0;
};

struct FreeOutcome {
  bool cancelled = false;
  bool at_rest = false;  ///< the gradient vanished from the start
  unsigned iterations = 0;
  std::vector<double> residuals = {};  ///< relative, after each iteration
};

/// Brings `x` to where the gradient vanishes by a change that is extended; `gradient` is that at
/// the start and is overwritten. The first iteration goes along `first` as far as the energy falls;
/// from there conjugate gradients, preconditioned by the diagonal blocks of the energy. Points that
/// neither moves stay. With constraints, to where the gradient is nothing but a sum of theirs:
/// Gould, Hribar, Nocedal, On the solution of equality constrained quadratic programming problems
/// arising in optimization, 2001, algorithm 6.2.
[[nodiscard]] FreeOutcome conjugate_gradient(const FreeSystem& system,
                                             const Preconditioned& preconditioned,
                                             const StopAt& stop, std::vector<double> first,
                                             std::span<double> gradient, std::span<double> x);

/// The same for a change that starts at 0 (extended; ends so), by Gauss and Seidel's sweeps over
/// the assembled matrix, on one thread (Lai and Cheng 2006, section 2.4). With constraints each
/// sweep is projected onto them, and followed to where the energy is least along it (ours).
[[nodiscard]] FreeOutcome gauss_seidel(const FreeSystem& system, const PatchLayout& layout,
                                       const StopAt& stop, std::span<double> gradient,
                                       std::span<double> change);

}  // namespace surpass

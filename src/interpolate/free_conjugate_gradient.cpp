#include "interpolate/free_preconditioner.hpp"
#include "interpolate/free_progress.hpp"
#include "interpolate/linear_constraints.hpp"

namespace surpass {
namespace {

// Of a gradient: its squared length, and its product with the preconditioned one.
struct Lengths {
  double squared = 0;
  double rho = 0;
};

// The arrays are far larger than any cache, and what is done with their numbers takes no time. So
// each function is one pass over them, and the preconditioned gradient is computed where it is
// needed: once for its length, once for the direction.

// The gradient goes along the direction by that direction's image.
Lengths descend(const FreeSystem& system, const FreePreconditioner& preconditioner, double length,
                std::span<const double> image, std::span<double> gradient) {
  const std::size_t width = system.width;
  return parallel::reduce(
      system.context, system.elimination.control_count(), Lengths{},
      [&](std::size_t begin, std::size_t end) {
        Lengths sums;
        for (std::size_t j = begin; j < end; ++j) {
          for (std::size_t c = j * width; c < (j + 1) * width; ++c) {
            gradient[c] += length * image[c];
          }
          double squared = 0;
          double rho = 0;
          preconditioner.apply(j, gradient, [&](std::size_t c, double z) {
            squared += gradient[c] * gradient[c];
            rho += gradient[c] * z;
          });
          sums.squared += squared;
          sums.rho += rho;
        }
        return sums;
      },
      [](const Lengths& sum, const Lengths& part) {
        return Lengths{sum.squared + part.squared, sum.rho + part.rho};
      });
}

// x goes along the direction, which then becomes share times itself minus the preconditioned
// gradient.
void turn(const FreeSystem& system, const FreePreconditioner& preconditioner, double length,
          double share, std::span<const double> gradient, std::span<double> direction,
          std::span<double> x) {
  parallel::for_ranges(system.context, system.elimination.control_count(),
                       [&](std::size_t begin, std::size_t end) {
                         for (std::size_t j = begin; j < end; ++j) {
                           preconditioner.apply(j, gradient, [&](std::size_t c, double z) {
                             x[c] += length * direction[c];
                             direction[c] = share * direction[c] - z;
                           });
                         }
                       });
}

void move(const FreeSystem& system, double length, std::span<const double> direction,
          std::span<double> x) {
  parallel::for_ranges(system.context, x.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) x[i] += length * direction[i];
  });
}

}  // namespace

FreeOutcome conjugate_gradient(const FreeSystem& system, const StopAt& stop,
                               std::span<double> gradient, std::span<double> x) {
  if (system.constraints != nullptr) system.constraints->clear(gradient);
  FreeProgress progress(system, stop, gradient);
  if (!progress.goes_on()) return std::move(progress).outcome();
  const FreePreconditioner preconditioner(system);
  std::vector<double> direction(system.size());
  std::vector<double> image(system.size());
  double rho = descend(system, preconditioner, 0, image, gradient).rho;
  turn(system, preconditioner, 0, 0, gradient, direction, x);
  while (rho > 0 && progress.goes_on()) {
    const double curvature = system.product(direction, image);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    const double length = rho / curvature;
    Lengths now = descend(system, preconditioner, length, image, gradient);
    if (system.constraints != nullptr) {
      system.constraints->clear(gradient);
      now = descend(system, preconditioner, 0, image, gradient);
    }
    progress.note(now.squared);
    if (progress.reached()) {
      move(system, length, direction, x);
      break;
    }
    turn(system, preconditioner, length, now.rho / rho, gradient, direction, x);
    rho = now.rho;
  }
  return std::move(progress).outcome();
}

}  // namespace surpass

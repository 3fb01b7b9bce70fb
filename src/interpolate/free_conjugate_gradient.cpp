#include "interpolate/free_preconditioner.hpp"
#include "interpolate/free_progress.hpp"
#include "interpolate/linear_constraints.hpp"

namespace surpass {
namespace {

// Along the direction: the change, and the gradient by the direction's image. Back comes the
// gradient's squared length. One pass over memory, as all that follows: the arrays are far larger
// than any cache, and what is done with their numbers takes no time.
double advance(const FreeSystem& system, double length, std::span<const double> direction,
               std::span<const double> image, std::span<double> change,
               std::span<double> gradient) {
  return parallel::reduce(
      system.context, change.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double squared = 0;
        for (std::size_t i = begin; i < end; ++i) {
          change[i] += length * direction[i];
          gradient[i] += length * image[i];
          squared += gradient[i] * gradient[i];
        }
        return squared;
      },
      [](double sum, double part) { return sum + part; });
}

// direction = share * direction - downhill.
void turn(const FreeSystem& system, double share, std::span<const double> downhill,
          std::span<double> direction) {
  parallel::for_ranges(system.context, direction.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) direction[i] = share * direction[i] - downhill[i];
  });
}

}  // namespace

FreeOutcome conjugate_gradient(const FreeSystem& system, const StopAt& stop,
                               std::span<double> gradient, std::span<double> change) {
  if (system.constraints != nullptr) system.constraints->clear(gradient);
  FreeProgress progress(system, stop, gradient);
  if (!progress.goes_on()) return std::move(progress).outcome();
  const FreePreconditioner preconditioner(system);
  std::vector<double> direction(system.size());
  std::vector<double> work(system.size());  // the direction's image, or the preconditioned gradient
  double rho = preconditioner.apply(gradient, work);
  turn(system, 0, work, direction);
  while (rho > 0 && progress.goes_on()) {
    system.product(direction, work);
    const double curvature = system.dot(direction, work);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    double squared = advance(system, rho / curvature, direction, work, change, gradient);
    if (system.constraints != nullptr) {
      system.constraints->clear(gradient);
      squared = system.dot(gradient, gradient);
    }
    progress.note(squared);
    if (progress.reached()) break;
    const double next = preconditioner.apply(gradient, work);
    turn(system, next / rho, work, direction);
    rho = next;
  }
  return std::move(progress).outcome();
}

}  // namespace surpass

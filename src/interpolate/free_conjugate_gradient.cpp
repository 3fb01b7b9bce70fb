#include "interpolate/free_preconditioner.hpp"
#include "interpolate/free_progress.hpp"
#include "interpolate/linear_constraints.hpp"

namespace surpass {
namespace {

// y += factor * x.
void add(const FreeSystem& system, double factor, std::span<const double> x, std::span<double> y) {
  parallel::for_ranges(system.context, x.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) y[i] += factor * x[i];
  });
}

}  // namespace

FreeOutcome conjugate_gradient(const FreeSystem& system, const StopAt& stop,
                               std::span<double> gradient, std::span<double> change) {
  const auto keep_constraints = [&] {
    if (system.constraints != nullptr) system.constraints->clear(gradient);
  };
  keep_constraints();
  FreeProgress progress(system, stop, gradient);
  if (!progress.goes_on()) return std::move(progress).outcome();
  const FreePreconditioner preconditioner(system);
  std::vector<double> direction(system.size());
  std::vector<double> work(system.size());  // the direction's image, or the preconditioned gradient
  preconditioner.apply(gradient, work);
  for (std::size_t i = 0; i < work.size(); ++i) direction[i] = -work[i];
  double rho = system.dot(gradient, work);
  while (rho > 0 && progress.goes_on()) {
    system.product(direction, work);
    const double curvature = system.dot(direction, work);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    add(system, rho / curvature, direction, change);
    add(system, rho / curvature, work, gradient);
    keep_constraints();
    progress.note(gradient);
    if (progress.reached()) break;
    preconditioner.apply(gradient, work);
    const double next = system.dot(gradient, work);
    const double share = next / rho;
    parallel::for_ranges(system.context, work.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) direction[i] = share * direction[i] - work[i];
    });
    rho = next;
  }
  return std::move(progress).outcome();
}

}  // namespace surpass

#include <cmath>

#include "interpolate/free_preconditioner.hpp"
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
  FreeOutcome outcome;
  const auto keep_constraints = [&] {
    if (system.constraints != nullptr) system.constraints->clear(gradient);
  };
  keep_constraints();
  const double start = std::sqrt(system.dot(gradient, gradient));
  if (start == 0 || stop.max_iterations == 0) return outcome;
  const FreePreconditioner preconditioner(system);
  std::vector<double> z(system.size());
  std::vector<double> direction(system.size());
  std::vector<double> image(system.size());
  preconditioner.apply(gradient, z);
  for (std::size_t i = 0; i < z.size(); ++i) direction[i] = -z[i];
  double rho = system.dot(gradient, z);
  while (outcome.iterations < stop.max_iterations && rho > 0) {
    if (system.context.cancelled()) {
      outcome.cancelled = true;
      return outcome;
    }
    system.product(direction, image);
    const double curvature = system.dot(direction, image);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    add(system, rho / curvature, direction, change);
    add(system, rho / curvature, image, gradient);
    keep_constraints();
    ++outcome.iterations;
    const double residual = std::sqrt(system.dot(gradient, gradient)) / start;
    outcome.residuals.push_back(residual);
    system.context.report({.stage = "solve",
                           .fraction = std::min(1.0, std::log(residual) / std::log(stop.tolerance)),
                           .iteration = outcome.iterations,
                           .error = residual});
    if (residual <= stop.tolerance) break;
    preconditioner.apply(gradient, z);
    const double next = system.dot(gradient, z);
    const double share = next / rho;
    parallel::for_ranges(system.context, z.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) direction[i] = share * direction[i] - z[i];
    });
    rho = next;
  }
  return outcome;
}

}  // namespace surpass
